// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// OpenGL's declarations. VTK changed its loader in 9.4.
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif
