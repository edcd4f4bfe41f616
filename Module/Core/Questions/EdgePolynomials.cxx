// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgePolynomials.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr Box3 kWholePiece{ Vec3(-1.0), Vec3(1.0) };
/// In HessianFunction's list: derivatives by xi, three a function, then six a function; the rest.
constexpr std::size_t kSlopes = 3;
constexpr std::size_t kBends = 6;
constexpr std::size_t kFirstBend = 4 * kSlopes;
constexpr std::size_t kFirstFactor = 4 * (kSlopes + kBends);
/// Of a component, its value among them.
constexpr std::size_t kOfEach = 1 + kSlopes + kBends;

using List = std::vector<BoxPolynomial>;

Degrees DegreeOf(const ScaledModes& modes, int level)
{
  return PieceForm::Of(modes.space, level).Degree();
}

List PartOf(const List& list, std::size_t first, std::size_t count)
{
  const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
  return { begin, begin + static_cast<std::ptrdiff_t>(count) };
}

List Joined(List list, const List& more)
{
  std::ranges::copy(more, std::back_inserter(list));
  return list;
}

List ValuesOf(
  const ScaledModes& modes, int first, int count, int level, const PieceForm::Piece& piece)
{
  List values;
  for (int c = first; c < first + count; ++c)
  {
    values.push_back(RangeIngredient{ &modes, c, Part::Value }.Over(level, piece, kWholePiece));
  }
  return values;
}

List AllOf(const ScaledModes& map, const ScaledModes& field, int component, int level,
  const PieceForm::Piece& piece)
{
  return HessianFunction::Polynomials(map, field, component, level, piece, kWholePiece);
}

List FieldOf(const ScaledModes& map, std::span<const EdgePolynomials::Function> functions,
  int level, const PieceForm::Piece& piece)
{
  List list;
  for (const auto& [modes, component] : functions)
  {
    const List all = AllOf(map, *modes, component, level, piece);
    list = Joined(std::move(list), ValuesOf(*modes, component, 1, level, piece));
    list = Joined(std::move(list), PartOf(all, 3 * kSlopes, kSlopes));
    list = Joined(std::move(list), PartOf(all, kFirstBend + 3 * kBends, kBends));
  }
  return list;
}
} // namespace

EdgePolynomials::EdgePolynomials(const ScaledModes& map, std::span<const Function> functions,
  int level, const PieceForm::Piece& piece)
  : EdgePolynomials(map, functions, level, piece, AllOf(map, map, 0, level, piece))
{
}

EdgePolynomials::EdgePolynomials(const ScaledModes& map, std::span<const Function> functions,
  int level, const PieceForm::Piece& piece, const List& ofMap)
  : TheShape(map.space.shape)
  , Map(DegreeOf(map, level),
      Joined(ValuesOf(map, 0, 3, level, piece), PartOf(ofMap, 0, 3 * kSlopes)))
  , Bends(DegreeOf(map, level), PartOf(ofMap, kFirstBend, 3 * kBends))
  , Field(DegreeOf(functions.empty() ? map : *functions.front().modes, level),
      FieldOf(map, functions, level, piece))
  , Factors(PartOf(ofMap, kFirstFactor, HessianFunction::kPolynomials - kFirstFactor))
{
}

std::size_t EdgePolynomials::Bytes() const
{
  return Map.Bytes() + Bends.Bytes() + Field.Bytes();
}

EdgePolynomials::MapHulls EdgePolynomials::MapOver(const Box3& within) const
{
  std::array<Interval, 3 + 3 * kSlopes> hulls;
  Map.HullsOver(within, hulls);
  MapHulls map;
  for (std::size_t c = 0; c < 3; ++c)
  {
    map.image[c] = hulls[c];
    std::copy_n(
      hulls.begin() + static_cast<std::ptrdiff_t>(3 + kSlopes * c), kSlopes, map.slopes[c].begin());
  }
  return map;
}

EdgePolynomials::Hulls EdgePolynomials::Over(const Box3& within, const MapHulls& map) const
{
  std::array<Interval, HessianFunction::kPolynomials> all;
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::ranges::copy(map.slopes[c], all.begin() + static_cast<std::ptrdiff_t>(kSlopes * c));
  }
  Bends.HullsOver(within, std::span(all).subspan(kFirstBend, 3 * kBends));
  for (std::size_t k = 0; k < Factors.size(); ++k)
  {
    BoxPolynomial factor = Factors[k];
    RestrictTo(within, factor);
    all[kFirstFactor + k] = factor.Hull();
  }
  std::vector<Interval> field(Field.Count());
  if (!field.empty())
  {
    Field.HullsOver(within, field);
  }
  Hulls hulls;
  const std::size_t count = field.size() / kOfEach;
  for (std::size_t c = 0; c < std::max<std::size_t>(count, 1); ++c)
  {
    // Of the map alone: what stands for the field means nothing.
    for (std::size_t k = 0; k < kSlopes && count > 0; ++k)
    {
      all[3 * kSlopes + k] = field[kOfEach * c + 1 + k];
    }
    for (std::size_t k = 0; k < kBends && count > 0; ++k)
    {
      all[kFirstBend + 3 * kBends + k] = field[kOfEach * c + 1 + kSlopes + k];
    }
    const auto ranges = HessianFunction::RangesByXi(TheShape, all);
    std::copy_n(ranges.begin(), 3, hulls.map.begin());
    if (count > 0)
    {
      hulls.functions.push_back(ranges[3]);
      hulls.values.push_back(field[kOfEach * c]);
    }
  }
  return hulls;
}
} // namespace pixelexact
