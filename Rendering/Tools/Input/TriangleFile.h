// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

#include <memory>
#include <string>

namespace pixelexact
{
/// The triangles of a .vtp or .stl file. Throws Error, naming the file, for one that cannot be
/// read, is of another kind, or holds no triangles.
std::shared_ptr<const Surface> ReadTriangles(const std::string& file);
} // namespace pixelexact
