// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Faces/ReferenceFace.h"

#include <optional>
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

/// The affine map that takes places on a face to places on the same face of another element.
struct FaceTurn
{
  FacePoint origin{};
  FacePoint first{};  ///< where { 1, 0 } lies
  FacePoint second{}; ///< where { 0, 1 } lies

  [[nodiscard]] FacePoint At(const FacePoint& point) const
  {
    const auto at = [&](std::size_t d)
    { return origin[d] + point[0] * (first[d] - origin[d]) + point[1] * (second[d] - origin[d]); };
    return { at(0), at(1) };
  }
};

/// The map between two faces that coincide as above; none where they do not.
std::optional<FaceTurn> FindFaceTurn(const Mesh& mesh, const FaceGrids& grids,
  std::span<const Vec3> uncertainty, const ElementFace& one, const ElementFace& other);
} // namespace pixelexact
