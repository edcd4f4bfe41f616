// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <span>

namespace pixelexact
{
class FaceMap;

/// The unit normals of an element's face at some xi, out of the element where its Jacobian is
/// positive; zero where the face has no tangents.
void FaceNormals(const FaceMap& map, std::span<const Vec3> xi, std::span<Vec3> normals);
} // namespace pixelexact
