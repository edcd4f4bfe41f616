// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Rational/ElementParts.h"

#include "Core/Basis/BasisFactor.h"
#include "Formats/Rational/LineMatrix.h"

#include <algorithm>
#include <map>

namespace pixelexact::rational
{
namespace
{
using Key = std::array<int, 3>; // order, part, of

/// The matrix from Legendre's coefficients on [-1,1] to those on a part.
LineMatrix PartMatrix(const Key& key)
{
  const auto [order, part, of] = key;
  const Space line{ Shape::Hexahedron, Form::Collapsed,
    { static_cast<std::uint8_t>(order), 0, 0 } };
  BasisFactor factor = LineFactor(
    order, { order + 1, [line, part = part, of = of](long double z, long double* values) {
              EvaluateModes(line, { (2 * part + 1 + z) / of - 1, 0.0L, 0.0L }, values);
            } });
  return { factor.rows, factor.columns, std::move(factor.matrix) };
}

/// J on a part is J D, D diagonal with 1 / of: what component c of the reference field is times.
double FactorOf(Mapping mapping, const ElementPart& part, int c)
{
  const double volume = 1.0 / (part.of[0] * part.of[1] * part.of[2]);
  switch (mapping)
  {
    case Mapping::Covariant:
      return 1.0 / part.of.at(c);
    case Mapping::Contravariant:
      return volume * part.of.at(c);
    case Mapping::Density:
      return volume;
    default:
      return 1.0;
  }
}
} // namespace

OwnedExpansion RestrictToParts(
  const OwnedExpansion& whole, Mapping mapping, std::span<const ElementPart> parts)
{
  OwnedExpansion result;
  result.spaces = whole.spaces;
  result.components = whole.components;
  for (const ElementPart& part : parts)
  {
    result.spaceOf.push_back(whole.spaceOf[static_cast<std::size_t>(part.element)]);
  }
  result.Allocate();
  std::map<Key, LineMatrix> known;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const ElementPart& part = parts[i];
    const auto e = static_cast<std::size_t>(part.element);
    const Space& space = whole.SpaceOf(e);
    const auto modes = static_cast<std::size_t>(space.Modes());
    for (int c = 0; c < whole.components; ++c)
    {
      const double* from = whole.Coefficients(e).data() + c * modes;
      double* to = result.Coefficients(i).data() + c * modes;
      std::vector<long double> grid(from, from + modes);
      GridSize points{ space.order[0] + 1, space.order[1] + 1, space.order[2] + 1 };
      for (int d = 0; d < 3; ++d)
      {
        if (part.of.at(d) > 1)
        {
          const Key key{ space.order.at(d), part.part.at(d), part.of.at(d) };
          const auto at = known.find(key);
          Sweep(grid, points, d,
            at == known.end() ? known.emplace(key, PartMatrix(key)).first->second : at->second);
        }
      }
      const double factor = FactorOf(mapping, part, c);
      std::ranges::transform(
        grid, to, [factor](long double x) { return factor * static_cast<double>(x); });
    }
  }
  return result;
}
} // namespace pixelexact::rational
