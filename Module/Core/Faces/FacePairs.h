// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceNumbers.h"

#include <span>
#include <vector>

namespace pixelexact
{
class FaceGrids;

/// For each face of a mesh the first face of another element that is the same, seen from the other
/// side: as many corners, and in one of the ways to lay corner on corner the same image at the
/// closed grid of the higher order, which tells polynomials apart, up to both elements'
/// uncertainty (per element, world units). None where there is no such face.
std::vector<ElementFace> FindFacePairs(const Mesh& mesh, const FaceNumbers& numbers,
  const FaceGrids& grids, std::span<const Vec3> uncertainty);
} // namespace pixelexact
