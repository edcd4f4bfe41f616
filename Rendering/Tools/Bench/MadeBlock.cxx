// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/MadeBlock.h"

#include "Bench/BlockParts.h"

#include "Core/Element/ElementUnits.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pixelexact
{
namespace
{
bool IsOther(const BlockKind& kind, int cell, int side)
{
  return kind.mixed && (cell % side + 3 * (cell / side / side)) % 8 == 0;
}

/// Lattice cells along a side, for about the elements wanted.
int SideFor(const BlockKind& kind, int perCell)
{
  const double cells = static_cast<double>(kind.elements) / perCell;
  return std::max(1, static_cast<int>(std::lround(std::cbrt(cells))));
}
} // namespace

MadeBlock::MadeBlock(const BlockKind& kind)
{
  std::vector<BlockParts> parts;
  for (const Shape shape : { kind.shape, Shape::Prism })
  {
    if (parts.empty() || kind.mixed)
    {
      parts.emplace_back(shape, kind.curved);
      MapSpace.push_back(UniformSpace(shape, kind.curved ? 3 : 1));
      FieldSpace.push_back(UniformSpace(shape, kind.order));
    }
  }
  const int side = SideFor(kind, parts[0].PerCell());
  std::vector<int> cellOf;
  std::vector<int> partOf;
  std::int64_t mapSize = 0;
  std::int64_t fieldSize = 0;
  for (int cell = 0; cell < side * side * side; ++cell)
  {
    const std::size_t which = IsOther(kind, cell, side) ? 1 : 0;
    for (int part = 0; part < parts[which].PerCell(); ++part)
    {
      cellOf.push_back(cell);
      partOf.push_back(part);
      SpaceOf.push_back(static_cast<std::int32_t>(which));
      MapOffset.push_back(mapSize);
      FieldOffset.push_back(fieldSize);
      mapSize += 3 * MapSpace[which].Modes();
      fieldSize += FieldSpace[which].Modes();
    }
  }
  const std::size_t elements = SpaceOf.size();
  MapCoefficients.resize(static_cast<std::size_t>(mapSize));
  FieldCoefficients.resize(static_cast<std::size_t>(fieldSize));
  Centre.resize(3 * elements);
  Size.resize(elements);
  Uncertainty.assign(elements, 4e-16);
  tbb::parallel_for(std::size_t{ 0 }, elements,
    [&](std::size_t e)
    {
      const auto which = static_cast<std::size_t>(SpaceOf[e]);
      const int cell = cellOf[e];
      const Vec3 at(cell % side, cell / side % side, cell / side / side);
      const auto values = parts[which].SourceValues(partOf[e], at, side);
      Vec3 low = values[0];
      Vec3 high = values[0];
      for (const Vec3& x : values)
      {
        low = glm::min(low, x);
        high = glm::max(high, x);
      }
      const ElementUnits units = MakeElementUnits(low, high);
      Size[e] = std::ldexp(1.0, units.exponent);
      std::vector<double> source(values.size());
      const auto modes = static_cast<std::size_t>(MapSpace[which].Modes());
      for (int d = 0; d < 3; ++d)
      {
        Centre[3 * e + static_cast<std::size_t>(d)] = units.centre[d];
        std::ranges::transform(values, source.begin(),
          [&](const Vec3& x) { return (x[d] - units.centre[d]) / Size[e]; });
        parts[which].ToModes().Apply(source, 0.0,
          std::span(MapCoefficients)
            .subspan(
              static_cast<std::size_t>(MapOffset[e]) + static_cast<std::size_t>(d) * modes, modes));
      }
      std::minstd_rand random(static_cast<unsigned>(e) + 1U);
      std::uniform_real_distribution<double> uniform(-1.0, 1.0);
      ForEachMode(FieldSpace[which],
        [&](int p, int q, int r, int mode)
        {
          FieldCoefficients[static_cast<std::size_t>(FieldOffset[e] + mode)] =
            uniform(random) * std::exp2(-p - q - r);
        });
    });
  field_.name = std::string("u");
  field_.values = { FieldSpace, SpaceOf, FieldOffset, FieldCoefficients, 1 };
}

Mesh MadeBlock::GetMesh() const
{
  return { { MapSpace, SpaceOf, MapOffset, MapCoefficients, 3 }, Centre, Size, Uncertainty };
}
} // namespace pixelexact
