// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgePolynomials.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Questions/EdgeArithmetic.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace pixelexact
{
namespace
{
/// The largest error of lower degrees, relative to the largest coefficients, and the factor by
/// which they must reduce the number of coefficients.
constexpr double kLeftOut = 0x1p-26;
constexpr double kMuchLess = 1.5;
/// The cost of subdivision per coefficient and degree, in nanoseconds, and the number of these at
/// which the cost of each has doubled, because they leave the cache.
constexpr std::int64_t kCostOfTerms = 9;
constexpr std::int64_t kManyTerms = 54000;
constexpr Box3 kWholePiece{ Vec3(-1.0), Vec3(1.0) };
/// Counts in HessianFunction's list: derivatives by xi, three per function, then six per function,
/// then the factors.
constexpr std::size_t kSlopes = 3;
constexpr std::size_t kBends = 6;
constexpr std::size_t kFirstBend = 4 * kSlopes;
constexpr std::size_t kFirstFactor = 4 * (kSlopes + kBends);
/// The number of polynomials of a component, with its value.
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
  return HessianFunction::Polynomials(map, field, component, level, piece);
}

/// Whether no divisor remains.
bool AreByXi(Shape shape, const List& all)
{
  return shape != Shape::Pyramid &&
    std::ranges::all_of(PartOf(all, kFirstFactor + 2, 2),
      [](const BoxPolynomial& divisor) { return divisor.b.size() == 1; });
}

/// The second derivatives of a function of HessianFunction's list, by its chain rule: 11, 12, 13,
/// 22, 23, 33 by xi where AreByXi, else those by eta unchanged.
List SecondsOf(Shape shape, const List& all, std::size_t function)
{
  List second = PartOf(all, kFirstBend + function * kBends, kBends);
  if (!AreByXi(shape, all))
  {
    return second;
  }
  const BoxPolynomial& e1 = all[kFirstFactor];
  const BoxPolynomial& e2 = all[kFirstFactor + 1];
  List byXi{ second[0], second[1], second[3], second[2], second[4], second[5] };
  if (shape == Shape::Tetrahedron)
  {
    byXi[3] = Sum(second[2], Multiply(e1, second[1]));
    byXi[4] = Sum(second[4], Multiply(e1, second[3]));
    byXi[5] = Sum(second[5], Multiply(e2, second[4]));
  }
  if (shape != Shape::Hexahedron)
  {
    byXi[5] = Sum(byXi[5], Multiply(e1, second[3]));
  }
  return byXi;
}

List BendsOf(Shape shape, const List& all)
{
  List bends;
  for (std::size_t c = 0; c < 3; ++c)
  {
    bends = Joined(std::move(bends), SecondsOf(shape, all, c));
  }
  return bends;
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
    list = Joined(std::move(list), SecondsOf(map.space.shape, all, 3));
  }
  return list;
}
} // namespace

Vec3 CentreOf(Shape shape, const EtaBox& box)
{
  return TensorToReference(shape, 0.5 * (box.lower + box.upper));
}

Vec3 ReachOf(Shape shape, const EtaBox& box)
{
  const Box3 hull = HullInXi(shape, box);
  const Vec3 centre = CentreOf(shape, box);
  return glm::max(hull.upper - centre, centre - hull.lower) * edges::kUp + 1e-15;
}

EdgePolynomials::EdgePolynomials(const ScaledModes& map, std::span<const Function> functions,
  int level, const PieceForm::Piece& piece)
  : EdgePolynomials(map, functions, level, piece, AllOf(map, map, 0, level, piece))
{
}

EdgePolynomials::EdgePolynomials(const ScaledModes& map, std::span<const Function> functions,
  int level, const PieceForm::Piece& piece, const List& ofMap)
  : shape_(map.space.shape)
  , Map(DegreeOf(map, level),
      Joined(ValuesOf(map, 0, 3, level, piece), PartOf(ofMap, 0, 3 * kSlopes)))
  , IsByXi(AreByXi(map.space.shape, ofMap))
  , Bends(DegreeOf(map, level), BendsOf(map.space.shape, ofMap))
  , Field(DegreeOf(functions.empty() ? map : *functions.front().modes, level),
      FieldOf(map, functions, level, piece))
  , Factors(PartOf(ofMap, kFirstFactor, HessianFunction::kPolynomials - kFirstFactor))
{
}

EdgePolynomials::EdgePolynomials(
  Shape shape, PolynomialBatch map, PolynomialBatch bends, PolynomialBatch field)
  : shape_(shape)
  , Map(std::move(map))
  , IsByXi(true)
  , Bends(std::move(bends))
  , Field(std::move(field))
{
}

std::unique_ptr<const EdgePolynomials> EdgePolynomials::Lowered() const
{
  if (!IsByXi)
  {
    return nullptr;
  }
  PolynomialBatch map = Map.Lowered(kLeftOut);
  PolynomialBatch field = Field.Lowered(kLeftOut);
  const auto size = [](const PolynomialBatch& a, const PolynomialBatch& b)
  { return static_cast<double>(CoefficientCount(a.Degree()) + CoefficientCount(b.Degree())); };
  if (size(map, field) * kMuchLess > size(Map, Field))
  {
    return nullptr;
  }
  // std::make_unique cannot call the private constructor.
  return std::unique_ptr<const EdgePolynomials>(
    new EdgePolynomials(shape_, std::move(map), Bends.Lowered(kLeftOut), std::move(field)));
}

EdgePolynomials::Cost EdgePolynomials::SubdivisionCost() const
{
  return { CostOf(Map.Degree()), CostOf(Field.Degree()) };
}

std::int64_t EdgePolynomials::CostOf(const Degrees& degree)
{
  const std::int64_t terms =
    static_cast<std::int64_t>(CoefficientCount(degree)) * (1 + std::ranges::max(degree));
  return kCostOfTerms * terms * (kManyTerms + terms) / kManyTerms;
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

std::vector<Vec3> EdgePolynomials::PlacesIn(
  Shape shape, const EtaBox& box, const Vec3& origin, const Degrees& degree)
{
  // A coordinate of xi is a product of functions of one eta each, of degree 1, so its coefficients
  // are its values on the coefficients' grid.
  std::vector<Vec3> places;
  places.reserve(CoefficientCount(degree));
  const auto at = [&](int d, int i) {
    return box.lower[d] + i * (box.upper[d] - box.lower[d]) / degree[static_cast<std::size_t>(d)];
  };
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int k = 0; k <= degree[2]; ++k)
      {
        places.push_back(TensorToReference(shape, { at(0, i), at(1, j), at(2, k) }) - origin);
      }
    }
  }
  return places;
}

EdgePolynomials::Hulls EdgePolynomials::Over(
  const Box3& within, const MapHulls& map, const EtaBox* box) const
{
  const auto isCurved = [](const Degrees& degree)
  { return std::ranges::all_of(degree, [](int n) { return n > 0; }); };
  const bool bounded =
    box != nullptr && IsByXi && isCurved(Bends.Degree()) && isCurved(Field.Degree());
  std::array<Interval, 3 * kBends> bends;
  std::vector<Interval> field(Field.Count());
  Hulls hulls;
  if (bounded)
  {
    const Vec3 centre = CentreOf(shape_, *box);
    hulls.curves.emplace();
    std::array<AffineBound, 3 * kBends> ofMap;
    Bends.BoundsOver(within, bends, PlacesIn(shape_, *box, centre, Bends.Degree()), ofMap);
    for (std::size_t c = 0; c < 3; ++c)
    {
      std::copy_n(ofMap.begin() + static_cast<std::ptrdiff_t>(kBends * c), kBends,
        hulls.curves->map[c].begin());
    }
    if (field.size() == kOfEach)
    {
      Field.BoundsOver(within, field, PlacesIn(shape_, *box, centre, Field.Degree()),
        hulls.curves->functions.emplace_back());
    }
  }
  else
  {
    Bends.HullsOver(within, bends);
  }
  if (!field.empty() && !(bounded && field.size() == kOfEach))
  {
    Field.HullsOver(within, field);
  }
  const std::size_t count = field.size() / kOfEach;
  const auto add = [&](std::size_t c)
  {
    const auto first = field.begin() + static_cast<std::ptrdiff_t>(kOfEach * c);
    hulls.values.push_back(*first);
    auto& function = hulls.functions.emplace_back();
    std::copy_n(first + 1, kSlopes, function.first.begin());
    std::copy_n(first + 1 + kSlopes, kBends, function.second.begin());
  };
  for (std::size_t c = 0; c < count; ++c)
  {
    add(c);
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    hulls.map[c].first = map.slopes[c];
    std::copy_n(
      bends.begin() + static_cast<std::ptrdiff_t>(kBends * c), kBends, hulls.map[c].second.begin());
  }
  if (!IsByXi)
  {
    MakeByXi(within, hulls);
  }
  return hulls;
}

void EdgePolynomials::MakeByXi(const Box3& within, Hulls& hulls) const
{
  std::array<Interval, HessianFunction::kPolynomials> all;
  for (std::size_t k = 0; k < Factors.size(); ++k)
  {
    BoxPolynomial factor = Factors[k];
    pixelexact::RestrictTo(within, factor);
    all[kFirstFactor + k] = factor.Hull();
  }
  const auto put = [&all](std::size_t f, const HessianFunction::XiRanges& ranges)
  {
    std::ranges::copy(ranges.first, all.begin() + static_cast<std::ptrdiff_t>(kSlopes * f));
    std::ranges::copy(
      ranges.second, all.begin() + static_cast<std::ptrdiff_t>(kFirstBend + kBends * f));
  };
  for (std::size_t c = 0; c < 3; ++c)
  {
    put(c, hulls.map[c]);
  }
  for (HessianFunction::XiRanges& function : hulls.functions)
  {
    put(3, function);
    function = HessianFunction::RangesByXi(shape_, all)[3];
  }
  const auto ranges = HessianFunction::RangesByXi(shape_, all);
  std::copy_n(ranges.begin(), 3, hulls.map.begin());
}
} // namespace pixelexact
