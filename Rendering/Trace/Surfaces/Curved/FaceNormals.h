// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/FaceModes.h"

#include <span>

namespace pixelexact
{
/// A box in world coordinates that contains a face of an element, moved by the mesh's uncertainty.
/// It is much smaller than the element's box. Infinite if the map is not finite. `modes`: of the
/// face, or null.
Box3 FaceBox(const Mesh& mesh, const CurvedPart& part, const FaceModes* modes = nullptr);

class FaceMap;

/// The unit normals of an element's face at points `xi`, out of the element where its Jacobian is
/// positive; zero where the face has no tangents.
void FaceNormals(const FaceMap& map, std::span<const Vec3> xi, std::span<Vec3> normals);

/// Kernels in lanes, with the same bits on all instruction sets.
struct FaceNormalKernels
{
  /// Unit vectors along `sign` times the cross product of two tangents, with coordinates slope[2 c]
  /// and slope[2 c + 1]; zero where it vanishes. Arrays hold PaddedCount(count) doubles.
  void (*make)(double sign, const double* const slope[6], int count, double* const to[3]);
};

const FaceNormalKernels& GetFaceNormalKernels();
} // namespace pixelexact
