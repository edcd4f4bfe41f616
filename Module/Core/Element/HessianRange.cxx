// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/HessianRange.h"

#include "Core/Base/Error.h"
#include "Core/Element/HessianFunction.h"

#include <cmath>

namespace pixelexact
{
namespace
{
CertifiedRange Search(const Mesh& mesh, int element, const Field& field, int component,
  const std::optional<HessianFunction::Pair>& pair, const RangeEffort& effort, const Box3& part)
{
  if (field.mapping != Mapping::Identity)
  {
    throw Unsupported("The second derivatives of field '" + field.name +
      "', an H(curl), H(div) or density field, cannot be certified.");
  }
  const ScaledModes map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3);
  const ScaledModes values(
    field.values.SpaceOf(element), field.values.Coefficients(element), field.values.components);
  CertifiedRange range;
  range.finite = map.finite && values.finite;
  if (!range.finite)
  {
    return range;
  }
  std::vector<RangeIngredient> ingredients;
  AddDerivatives(map, 0, 3, ingredients);
  AddDerivatives(values, component, 1, ingredients);
  const int level = LevelFor(ingredients);
  const int pieces = 1 << level;
  const HessianFunction function(map.space.shape, pair);
  RangeSearch search(function, CertifiedRange{}.attained);
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    const PieceForm::Piece piece{ i / (pieces * pieces), i / pieces % pieces, i % pieces };
    const Box3 within = PartInPiece(part, level, piece);
    if (within.lower.x <= within.upper.x && within.lower.y <= within.upper.y &&
      within.lower.z <= within.upper.z)
    {
      RangeBox box;
      const auto make = [&map, &values, component, level, piece, within]
      { return HessianFunction::Polynomials(map, values, component, level, piece, within); };
      box.polynomials = make();
      if (pieces > 1)
      {
        box.remake = make;
      }
      search.Add(std::move(box));
    }
  }
  range = SearchRange(search, effort.tolerance, 0.0, effort.boxes);
  const int length = map.exponent + std::ilogb(mesh.size[static_cast<std::size_t>(element)]);
  return Scaled(range, values.exponent - 2 * length);
}
} // namespace

CertifiedRange HessianRange(const Mesh& mesh, int element, const Field& field, int component,
  const Vec3& a, const Vec3& b, const RangeEffort& effort, const Box3& part)
{
  const HessianFunction::Pair pair{ { { a.x, a.y, a.z }, { b.x, b.y, b.z } } };
  return Search(mesh, element, field, component, pair, effort, part);
}

CertifiedRange HessianNormRange(const Mesh& mesh, int element, const Field& field, int component,
  const RangeEffort& effort, const Box3& part)
{
  return Search(mesh, element, field, component, std::nullopt, effort, part);
}
} // namespace pixelexact
