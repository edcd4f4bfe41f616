// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceNumbers.h"

#include <span>
#include <vector>

namespace pixelexact
{
class FaceGrids;

/// Finds for each face of a mesh the first face of another element that coincides with it, from the
/// other side. Coinciding faces have the same number of corners and, for one of the assignments of
/// corners, the same image at the closed grid of the higher order, up to both elements' uncertainty
/// (per element, world units); the grid determines the polynomial. None where there is no such
/// face.
std::vector<ElementFace> FindFacePairs(const Mesh& mesh, const FaceNumbers& numbers,
  const FaceGrids& grids, std::span<const Vec3> uncertainty);
} // namespace pixelexact
