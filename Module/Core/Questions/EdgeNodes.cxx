// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Ranges.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeBounds.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
using namespace edges;

namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of a box's sides, on either side.
constexpr double kMargin = 0.25;
/// Row sums of |M J - I| up to which a box is regular.
constexpr double kMostTurn = 0.7;
/// Halvings of boxes on which the map is not regular, and of those where it is: of functions with
/// few coefficients. Nodes of many cost more, and there are fewer of them.
constexpr int kMostHalvings[2] = { 15, 17 };
constexpr double kFewCoefficients = 216.0;

constexpr Part kBy[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };

Interval Union(const Interval& a, const Interval& b)
{
  return { std::min(a.lower, b.lower), std::max(a.upper, b.upper) };
}
constexpr Interval Nothing()
{
  return { kInfinity, -kInfinity };
}

std::array<EdgeNodeEnd, 6> EndsOf(Shape shape, const EtaBox& box)
{
  const auto normals = EndNormals(shape, box);
  std::array<EdgeNodeEnd, 6> ends;
  for (int k = 0; k < 6; ++k)
  {
    EdgeNodeEnd& end = ends[static_cast<std::size_t>(k)];
    std::copy_n(normals[static_cast<std::size_t>(k)], 3, end.normal);
    end.offset = DepthOf(shape, box, k, Vec3(0.0));
    end.ofElement = k % 2 == 1 ? box.upper[k / 2] == 1.0 : box.lower[k / 2] == -1.0;
  }
  return ends;
}
} // namespace

EdgeBounds::EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element,
  const Field& field, int component, double rounding)
  : Map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3)
  , Component(field.values.SpaceOf(element),
      field.values.Coefficients(element) +
        static_cast<std::ptrdiff_t>(std::max(component, 0)) * field.values.SpaceOf(element).Modes(),
      component < 0 ? field.values.components : 1)
  , Components(component < 0 ? field.values.components : 1)
  , Centre(mesh.centre[3 * static_cast<std::size_t>(element)],
      mesh.centre[3 * static_cast<std::size_t>(element) + 1],
      mesh.centre[3 * static_cast<std::size_t>(element) + 2])
  , Size(mesh.size[static_cast<std::size_t>(element)])
  , Uncertainty{ bounds.uncertainty[0], bounds.uncertainty[1], bounds.uncertainty[2] }
  , Range(Interval::Everything())
{
  if (!Component.finite)
  {
    ValueError = kInfinity;
    return;
  }
  std::vector<RangeIngredient> all;
  all.reserve(4 * (static_cast<std::size_t>(Components) + 3));
  for (int c = 0; c < Components; ++c)
  {
    all.push_back({ &Component, c, Part::Value });
  }
  for (int c = 0; c < 3; ++c)
  {
    all.push_back({ &Map, c, Part::Value });
  }
  AddDerivatives(Map, 0, 3, all);
  AddDerivatives(Component, 0, Components, all);
  Level = LevelFor(all);
  const auto fewer = [](std::size_t coefficients)
  {
    return std::max(
      0, static_cast<int>(std::log2(static_cast<double>(coefficients) / kFewCoefficients)));
  };
  const int besides[2] = { fewer(PieceForm::Of(Map.space, Level).Size()),
    fewer(PieceForm::Of(Component.space, Level).Size()) };
  for (std::size_t k = 0; k < 2; ++k)
  {
    Deepest[k] = kMostHalvings[k] - besides[k];
  }
  Range = ValuesOver({});
  DescribeErrors(rounding);
}

EdgeBounds::~EdgeBounds() = default;

const EdgeNode& EdgeBounds::Whole() const
{
  if (const EdgeNode* ready = Ready.load(std::memory_order_acquire))
  {
    return *ready;
  }
  const std::scoped_lock lock(Growing);
  if (!Root)
  {
    Root = std::make_unique<EdgeNode>();
    Fill(*Root, Range);
    Ready.store(Root.get(), std::memory_order_release);
  }
  return *Root;
}

template <class Visit>
void EdgeBounds::ForEachPiece(const EtaBox& box, const Visit& visit) const
{
  const int pieces = 1 << Level;
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    const PieceForm::Piece piece{ i / (pieces * pieces), i / pieces % pieces, i % pieces };
    const Box3 within = PartInPiece({ box.lower, box.upper }, Level, piece);
    if (within.lower.x < within.upper.x && within.lower.y < within.upper.y &&
      within.lower.z < within.upper.z)
    {
      visit(piece, within);
    }
  }
}

double EdgeBounds::ErrorOf(const ScaledModes& modes, int components, Part part) const
{
  double error = 0.0;
  ForEachPiece({},
    [&](const PieceForm::Piece& piece, const Box3& /*within*/)
    {
      double sum = 0.0;
      for (int c = 0; c < components; ++c)
      {
        const RangeIngredient ingredient{ &modes, c, part };
        sum += PieceForm::Of(modes.space, Level).ErrorBound(part, piece, ingredient.Modes());
      }
      error = std::max(error, sum);
    });
  return std::ldexp(4.0 * error, modes.exponent);
}

void EdgeBounds::DescribeErrors(double rounding)
{
  ValueError = ErrorOf(Component, Components, Part::Value) * (1.0 + rounding / kUnitRoundoff);
  ImageError = ErrorOf(Map, 3, Part::Value);
  for (const Part part : kBy)
  {
    ValueSlopeError = std::max(ValueSlopeError, ErrorOf(Component, Components, part));
    ImageSlopeError = std::max(ImageSlopeError, ErrorOf(Map, 3, part));
  }
}

Interval EdgeBounds::HullOver(
  const EtaBox& box, const ScaledModes& modes, int component, Part part) const
{
  Interval hull = Nothing();
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      hull =
        Union(hull, RangeIngredient{ &modes, component, part }.Over(Level, piece, within).Hull());
    });
  return Scaled(hull, modes.exponent);
}

void EdgeBounds::Fill(EdgeNode& node, const Interval& values) const
{
  ++Count;
  const Vec3 margin = kMargin * (node.box.upper - node.box.lower);
  node.wide.lower = glm::max(node.box.lower - margin, Vec3(-1.0));
  node.wide.upper = glm::min(node.box.upper + margin, Vec3(1.0));
  node.values = values;
  const Vec3 sides = node.box.upper - node.box.lower;
  const int wider = sides.x >= sides.y ? 0 : 1;
  node.direction = sides[wider] >= sides.z ? wider : 2;
  for (int d = 0; d < 3; ++d)
  {
    const double slack = Uncertainty[static_cast<std::size_t>(d)];
    const Interval x =
      Interval(Size) * (HullOver(node.wide, Map, d, Part::Value) + Interval(-slack, slack)) +
      Interval(Centre[d]);
    node.bounds.lower[d] = x.lower;
    node.bounds.upper[d] = x.upper;
  }
  std::array<std::array<Interval, 3>, 3> slopes;
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      slopes[c][j] = HullOver(node.wide, Map, static_cast<int>(c), kBy[j]);
    }
  }
  // What follows costs more.
  if (!DescribeMap(node, slopes))
  {
    return;
  }
  node.values = ValuesOver(node.wide);
  node.boxEnds = EndsOf(Map.space.shape, node.box);
  node.wideEnds = EndsOf(Map.space.shape, node.wide);
  std::vector<std::array<HessianFunction::XiRanges, 4>> ranges;
  ranges.reserve(static_cast<std::size_t>(Components));
  for (int c = 0; c < Components; ++c)
  {
    ranges.push_back(RangesOf(node.wide, c));
  }
  DescribeCurves(node, ranges);
}

Interval EdgeBounds::ValuesOver(const EtaBox& box) const
{
  if (Components == 1)
  {
    return HullOver(box, Component, 0, Part::Value);
  }
  Interval square(0.0);
  for (int c = 0; c < Components; ++c)
  {
    square += Square(HullOver(box, Component, c, Part::Value));
  }
  return Sqrt(square);
}

std::array<HessianFunction::XiRanges, 4> EdgeBounds::RangesOf(
  const EtaBox& box, int component) const
{
  std::array<HessianFunction::XiRanges, 4> ranges;
  bool first = true;
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      const auto here = HessianFunction::RangesByXi(Map.space.shape,
        HessianFunction::Polynomials(Map, Component, component, Level, piece, within));
      for (std::size_t f = 0; f < 4; ++f)
      {
        const int exponent = f < 3 ? Map.exponent : Component.exponent;
        const auto add = [&](Interval& to, const Interval& range)
        { to = first ? Scaled(range, exponent) : Union(to, Scaled(range, exponent)); };
        for (std::size_t k = 0; k < 3; ++k)
        {
          add(ranges[f].first[k], here[f].first[k]);
        }
        for (std::size_t k = 0; k < 6; ++k)
        {
          add(ranges[f].second[k], here[f].second[k]);
        }
      }
      first = false;
    });
  return ranges;
}

bool EdgeBounds::DescribeMap(
  EdgeNode& node, const std::array<std::array<Interval, 3>, 3>& slopes) const
{
  const Shape shape = Map.space.shape;
  const Box3 hull = HullInXi(shape, node.wide);
  node.centre = TensorToReference(shape, 0.5 * (node.wide.lower + node.wide.upper));
  node.origin = ImageOf(node.centre);
  Mat3 middle;
  for (int c = 0; c < 3; ++c)
  {
    for (int j = 0; j < 3; ++j)
    {
      const Interval& range = slopes[static_cast<std::size_t>(c)][static_cast<std::size_t>(j)];
      if (!range.IsFinite())
      {
        return false;
      }
      middle[j][c] = range.Middle();
    }
  }
  const Mat3 inverse = glm::inverse(middle);
  double most = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      node.inverse[i][j] = inverse[static_cast<int>(j)][static_cast<int>(i)];
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      Interval entry(i == j ? -1.0 : 0.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        entry += Interval(node.inverse[i][c]) * slopes[c][j];
      }
      sum += entry.Magnitude();
    }
    node.turn[i] = sum * kUp;
    most = std::max(most, node.turn[i]);
    const int d = static_cast<int>(i);
    node.reach[i] =
      std::max(hull.upper[d] - node.centre[d], node.centre[d] - hull.lower[d]) * kUp + 1e-15;
  }
  // Written so that a NaN is not regular.
  return most <= kMostTurn;
}

void EdgeBounds::DescribeCurves(
  EdgeNode& node, std::span<const std::array<HessianFunction::XiRanges, 4>> components) const
{
  const auto& ranges = components.front();
  // Of all components: the Euclidean norm of bounds bounds that of vectors.
  const auto norm = [&components](auto&& of)
  {
    double sum = 0.0;
    for (const auto& one : components)
    {
      const double magnitude = of(one[3]).Magnitude();
      sum += magnitude * magnitude;
    }
    return components.size() == 1 ? of(components.front()[3]).Magnitude() : std::sqrt(sum) * kUp;
  };
  double bend[6][3];
  for (std::size_t p = 0; p < 6; ++p)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      Interval entry(0.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        entry += Interval(node.inverse[k][c]) * ranges[c].second[p];
      }
      bend[p][k] = entry.Magnitude();
    }
    Solve(node.turn, bend[p]);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    node.slope[k] = norm([k](const HessianFunction::XiRanges& one) { return one.first[k]; });
    node.lean[k] = 0.0;
    node.shift[k] = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      node.lean[k] += std::fabs(node.inverse[k][c]);
      node.shift[k] += std::fabs(node.inverse[k][c]) * kMostMiss * Uncertainty[c];
    }
  }
  Solve(node.turn, node.lean);
  Solve(node.turn, node.shift);
  bool finite = true;
  for (std::size_t p = 0; p < 6; ++p)
  {
    const double twice = kRows[p] == kColumns[p] ? 1.0 : 2.0;
    node.curve[p] = norm([p](const HessianFunction::XiRanges& one) { return one.second[p]; });
    for (std::size_t k = 0; k < 3; ++k)
    {
      node.bend[k][p] = twice * bend[p][k];
      node.curve[p] += node.slope[k] * bend[p][k];
    }
    node.curve[p] *= twice * kUp;
    finite = finite && std::isfinite(node.curve[p]);
  }
  node.regular = finite;
}

const std::array<EdgeNode, 2>& EdgeBounds::Split(const EdgeNode& node) const
{
  if (const auto* made = node.children.load(std::memory_order_acquire))
  {
    return *made;
  }
  const std::scoped_lock lock(Growing);
  if (const auto* made = node.children.load(std::memory_order_acquire))
  {
    return *made;
  }
  const int direction = node.direction;
  const double middle = 0.5 * (node.box.lower[direction] + node.box.upper[direction]);
  auto halves = std::make_unique<std::array<EdgeNode, 2>>();
  for (std::size_t k = 0; k < 2; ++k)
  {
    EdgeNode& half = (*halves)[k];
    half.box = node.box;
    (k == 0 ? half.box.upper : half.box.lower)[direction] = middle;
    half.halvings = node.halvings + 1;
    Fill(half, node.values);
  }
  node.children.store(halves.get(), std::memory_order_release);
  return *halves.release();
}

const EdgeNode& EdgeBounds::LeafAt(const Vec3& eta) const
{
  const EdgeNode* node = &Whole();
  while (!node->regular && node->halvings < Deepest[0])
  {
    const auto& halves = Split(*node);
    const int d = node->direction;
    node = &halves[eta[d] <= halves[0].box.upper[d] ? 0 : 1];
  }
  return *node;
}
} // namespace pixelexact
