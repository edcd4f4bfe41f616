// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/NodePolynomials.h"

#include "Core/Math/Interval.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// 64 MiB.
constexpr std::size_t kMostHeld = std::size_t{ 1 } << 23U;

bool IsInPiece(const EtaBox& box, int level)
{
  const PieceForm::Piece piece = PieceAt({ box.lower, box.upper }, level);
  bool holds = true;
  for (int d = 0; d < 3; ++d)
  {
    const int k = piece[static_cast<std::size_t>(d)];
    holds = holds && box.lower[d] >= std::ldexp(k, 1 - level) - 1.0 &&
      box.upper[d] <= std::ldexp(k + 1, 1 - level) - 1.0;
  }
  return holds;
}

BoxPolynomial Over(const ScaledModes& modes, int component, int level, const EtaBox& box)
{
  const PieceForm::Piece piece = PieceAt({ box.lower, box.upper }, level);
  const Box3 within = PartInPiece({ box.lower, box.upper }, level, piece);
  return RangeIngredient{ &modes, component, Part::Value }.Over(level, piece, within);
}
} // namespace

NodePolynomials::NodePolynomials(const Mesh& mesh, int element)
  : Map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3)
  , MapLevel(PieceForm::LevelOf(Map.space.MaxOrder()))
{
  const auto e = static_cast<std::size_t>(element);
  Uncertainty.fill(rounding::Above(mesh.uncertainty[e] / mesh.size[e]));
}

NodePolynomials::NodePolynomials(
  const Mesh& mesh, int element, const Expansion& values, int component)
  : NodePolynomials(mesh, element)
{
  Field = std::make_unique<ScaledModes>(
    values.SpaceOf(element), values.Coefficients(element), values.components);
  Component = component;
  FieldLevel = Field->finite ? LevelFor({ { Field.get(), component, Part::Value } }) : 0;
}

bool NodePolynomials::CanMakeMap(const ElementTree::Node& node) const
{
  return Map.finite && IsInPiece(node.Frame().box, MapLevel);
}

bool NodePolynomials::CanMakeField(const ElementTree::Node& node) const
{
  return Field->finite && IsInPiece(node.Frame().box, FieldLevel);
}

std::span<const BoxPolynomial, 3> NodePolynomials::MapOver(const ElementTree::Node& node)
{
  const auto [entry, isNew] = Maps.try_emplace(&node);
  std::array<BoxPolynomial, 3>& made = entry->second;
  for (std::size_t c = 0; isNew && c < 3; ++c)
  {
    made[c] = Over(Map, static_cast<int>(c), MapLevel, node.Frame().box);
    // Exact, but for what underflows.
    for (double& b : made[c].b)
    {
      b = std::ldexp(b, Map.exponent);
    }
    made[c].error =
      rounding::Above(std::ldexp(made[c].error, Map.exponent) + Uncertainty[c]) + 0x1p-1000;
    Held += made[c].b.size();
  }
  return made;
}

const BoxPolynomial& NodePolynomials::FieldOver(const ElementTree::Node& node)
{
  const auto [entry, isNew] = Fields.try_emplace(&node);
  if (isNew)
  {
    entry->second = Over(*Field, Component, FieldLevel, node.Frame().box);
    Held += entry->second.b.size();
  }
  return entry->second;
}

void NodePolynomials::Trim()
{
  if (Held > kMostHeld)
  {
    Maps.clear();
    Fields.clear();
    Held = 0;
  }
}
} // namespace pixelexact
