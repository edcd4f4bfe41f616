// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"

namespace pixelexact
{
/// The unit normal of an element's face, out of the element where its Jacobian is positive; zero
/// where the face has no tangents.
[[nodiscard]] Vec3 FaceNormal(const Mesh& mesh, const CurvedPart& part, const Vec3& xi);
} // namespace pixelexact
