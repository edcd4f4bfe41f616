// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/BoxModel.h"
#include "Core/Integral/ClippedSquare.h"
#include "Core/Integral/ElementFunctions.h"

#include <array>
#include <optional>
#include <vector>

namespace pixelexact
{
/// The map's Jacobian and the field over a parametrised surface in an element, as models. Units are
/// those of the modes: x = centre + radius y, u = 2^FieldExponent() times these values.
struct SurfaceModels
{
  /// `axes` and `places`: as in ElementFunctions::Values.
  SurfaceModels(ElementFunctions& functions, const PieceBox& box, const std::array<int, 3>& axes,
    const PointedModels& place, const PieceBox& places);

  std::array<std::array<ChebyshevModel, 3>, 3> jacobian; ///< dy_i / dxi_j
  ChebyshevModel determinant;
  std::vector<ChebyshevModel> field; ///< reference values
};

/// The cofactors of one row of a matrix.
std::array<ChebyshevModel, 3> Cofactors(
  const std::array<std::array<ChebyshevModel, 3>, 3>& matrix, std::size_t row);

/// The determinant times the field's world values, times radius^power. For no mapping does it
/// contain a quotient.
struct WeighedField
{
  std::vector<ChebyshevModel> values;
  int power = 0;
};
WeighedField Weigh(const SurfaceModels& models, Mapping mapping);

ChebyshevModel Dot(const std::array<ChebyshevModel, 3>& a, const std::array<ChebyshevModel, 3>& b);

/// eta along the directions a, b, c.
std::array<ChebyshevModel, 3> EtaModels(const ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const ChebyshevModel& b, const ChebyshevModel& c);
/// The models of z = x - origin.
std::array<ChebyshevModel, 3> PlaceModels(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const Vec3& origin);
/// The clips over a parametrised surface, without those that clip nothing of the box.
std::vector<ChebyshevModel> ClipModels(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place);
/// The part of (s, t) that the question's clips leave. None where it cannot be classified on so
/// large a box.
std::optional<ClippedSquare> ClippedPart(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place);
/// Whether the clips remove all of a box.
bool IsClippedOff(ElementFunctions& functions, const PieceBox& box);
/// (1 - eta) / 2.
ChebyshevModel Collapse(const ChebyshevModel& eta);

/// Enclosures of the integrals over a part of a surface, by quantity.
using Sums = std::vector<Interval>;
void AddTo(Sums& sums, const Sums& more);
/// Sets the integrals of a field that is exactly zero to zero.
void DropZeroField(const ElementFunctions& functions, Sums& sums);
} // namespace pixelexact
