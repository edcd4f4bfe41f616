// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Index/ElementIndex.h"

#include <span>
#include <vector>

namespace pixelexact
{
class FaceGrids;

/// The classification of a face that has no pair.
struct FaceContact
{
  FaceKind kind = FaceKind::Boundary;
  ElementFace neighbour; ///< of Interior, where the face has an area
};

/// Classifies the faces without a pair, given in ascending order, one entry each. Searches for
/// sample points of each face (its open grid) on the others, up to both elements' uncertainty (per
/// element, world units). A face without area, an edge or a vertex of a collapsed element, bounds
/// nothing and is Interior.
std::vector<FaceContact> FindFaceContacts(const ElementIndex& index, const FaceGrids& grids,
  std::span<const Vec3> uncertainty, std::span<const ElementFace> faces);
} // namespace pixelexact
