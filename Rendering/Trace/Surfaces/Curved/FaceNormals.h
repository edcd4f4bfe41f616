// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"

#include <span>

namespace pixelexact
{
/// The unit normals of an element's face at some xi, out of the element where its Jacobian is
/// positive; zero where the face has no tangents.
void FaceNormals(
  const Mesh& mesh, const CurvedPart& part, std::span<const Vec3> xi, std::span<Vec3> normals);
} // namespace pixelexact
