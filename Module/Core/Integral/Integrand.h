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
/// those of the modes: x = centre + radius y, u = 2^FieldExponent() times what is here.
struct SurfaceModels
{
  /// `axes`: as PointedModels' a, b and c. `places`: the part of the box where `place` is, in which
  /// a function without coefficients is interpolated.
  SurfaceModels(ElementFunctions& functions, const PieceBox& box, const std::array<int, 3>& axes,
    const PointedModels& place, const PieceBox& places);

  std::array<std::array<ChebyshevModel, 3>, 3> jacobian; ///< dy_i / dxi_j
  ChebyshevModel determinant;
  std::vector<ChebyshevModel> field; ///< reference values
};

/// The cofactors of one row of a matrix.
std::array<ChebyshevModel, 3> Cofactors(
  const std::array<std::array<ChebyshevModel, 3>, 3>& matrix, std::size_t row);

/// The determinant times the field's world values, which of all mappings has no quotients, times
/// radius^power.
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
/// z = x - origin there.
std::array<ChebyshevModel, 3> PlaceModels(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const Vec3& origin);
/// The part of (s, t) that the question's clips leave; nothing where it is not known on so large a
/// box.
std::optional<ClippedSquare> ClippedPart(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place);
/// Whether the clips leave nothing of a box.
bool IsClippedOff(ElementFunctions& functions, const PieceBox& box);
/// (1 - eta) / 2.
ChebyshevModel Collapse(const ChebyshevModel& eta);

/// What an integral over a part of a surface is known to be, by quantity.
using Sums = std::vector<Interval>;
void AddTo(Sums& sums, const Sums& more);
/// Where the field is zero, exactly, so are the integrals of it.
void DropZeroField(const ElementFunctions& functions, Sums& sums);
} // namespace pixelexact
