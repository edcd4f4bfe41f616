// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <glm/mat3x3.hpp>

namespace pixelexact
{
/// Column-major, as GLM: m[j] is column j. A Jacobian holds dPhi/dxi_j in column j.
using Mat3 = glm::dmat3;
} // namespace pixelexact
