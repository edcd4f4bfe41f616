// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeBounds.h"

#include "Core/Element/Ranges.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Covers the rounding of sums and products of some dozen terms that are not negative.
constexpr double kUp = 1.0 + 1e-13;
/// Of a box's sides, on either side.
constexpr double kMargin = 0.25;
/// Row sums of |M J - I| up to which a box is regular.
constexpr double kMostTurn = 0.7;
/// Halvings of boxes on which the map is not regular, and of those where it is: of functions with
/// few coefficients. Nodes of many cost more, and there are fewer of them.
constexpr int kMostHalvings[2] = { 15, 17 };
constexpr double kFewCoefficients = 216.0;
/// By how much a path may leave the element, in xi: far less than would be seen, and more than
/// rounding makes of an edge in a face.
constexpr double kBeside = 1e-10;
/// What the expansion's error may be of the distance.
constexpr double kCoarse = 0.25;
constexpr int kRounds = 6;
/// Of Newton's iteration towards a segment's middle.
constexpr int kSteps = 2;
constexpr std::size_t kRows[6] = { 0, 0, 0, 1, 1, 2 };
constexpr std::size_t kColumns[6] = { 0, 1, 2, 1, 2, 2 };

/// sum of m_ij s_i s_j.
double Quadratic(const double (&m)[6], const double (&s)[3])
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k)
  {
    sum += m[k] * s[kRows[k]] * s[kColumns[k]];
  }
  return sum;
}

/// Bounds of the solution of (I + E) v = w from those of w.
void Solve(const double (&turn)[3], double (&v)[3])
{
  const double largest = std::max({ v[0], v[1], v[2] });
  const double most = std::max({ turn[0], turn[1], turn[2] });
  for (std::size_t k = 0; k < 3; ++k)
  {
    v[k] = (v[k] + turn[k] * largest / (1.0 - most)) * kUp;
  }
}

Interval Union(const Interval& a, const Interval& b)
{
  return { std::min(a.lower, b.lower), std::max(a.upper, b.upper) };
}
constexpr Interval Nothing()
{
  return { kInfinity, -kInfinity };
}

/// A xi of a box, not far from the nearest one.
Vec3 MovedInto(Shape shape, const EdgeNode& node, const Vec3& xi)
{
  const EtaBox& box = node.wide;
  Vec3 moved = xi;
  for (int round = 0; round < 3; ++round)
  {
    for (const EdgeNodeEnd& end : node.wideEnds)
    {
      const double depth = end.DepthOf(moved);
      if (depth < 0.0)
      {
        const Vec3 normal(end.normal[0], end.normal[1], end.normal[2]);
        moved += normal * (depth / glm::dot(normal, normal));
      }
    }
  }
  // What is left, in eta: of a NaN, any point.
  return TensorToReference(
    shape, glm::clamp(ReferenceToTensor(shape, moved), box.lower, box.upper));
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

bool Holds(const EtaBox& box, const Vec3& eta)
{
  return Box3{ box.lower, box.upper }.Contains(eta);
}
} // namespace

bool ValueSet::Meets(double from, double to) const
{
  const auto at = std::ranges::lower_bound(values, from);
  return from <= lower || to >= upper || (at != values.end() && *at <= to);
}

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
  double error = 0.0;
  ForEachPiece({},
    [&](const PieceForm::Piece& piece, const Box3& /*within*/)
    {
      double sum = 0.0;
      for (int c = 0; c < Components; ++c)
      {
        const RangeIngredient ingredient{ &Component, c, Part::Value };
        sum +=
          PieceForm::Of(Component.space, Level).ErrorBound(Part::Value, piece, ingredient.Modes());
      }
      error = std::max(error, sum);
    });
  // The same sums as the kernels make, but for the order of the factors; `error` is the bound of
  // their rounding (accuracy.md).
  ValueError = std::ldexp(4.0 * error * (1.0 + rounding / kUnitRoundoff), Component.exponent);
}

EdgeBounds::~EdgeBounds() = default;

/// The map at a point.
struct EdgeBounds::View
{
  Vec3 xi;
  Vec3 y;
  Mat3 inverse; ///< of J
};

namespace
{
/// Room for one point's lanes.
constexpr std::size_t kRoom = 16;

/// `components` functions and their derivatives by xi at a point: values, then slopes, of
/// `components` times 3.
struct Evaluated
{
  double values[3][kRoom];
  double slopes[9][kRoom];

  Evaluated(const Space& space, const double* modes, int components, const Vec3& xi)
  {
    double at[3][kRoom];
    for (int d = 0; d < 3; ++d)
    {
      std::fill_n(at[d], kRoom, xi[d]);
    }
    double* const out[3] = { values[0], values[1], values[2] };
    double* gradient[9];
    for (std::size_t k = 0; k < 9; ++k)
    {
      gradient[k] = slopes[k];
    }
    KernelsFor(space).gradient(
      space, modes, components, { { at[0], at[1], at[2] }, 1 }, out, gradient);
  }
};
} // namespace

EdgeBounds::View EdgeBounds::ViewAt(const Vec3& xi) const
{
  const Evaluated map(Map.space, Map.values.data(), 3, xi);
  const double scale = std::ldexp(1.0, Map.exponent);
  View view{ xi, Vec3(0.0), Mat3(0.0) };
  Mat3 jacobian;
  for (int c = 0; c < 3; ++c)
  {
    view.y[c] = scale * map.values[c][0];
    for (int j = 0; j < 3; ++j)
    {
      jacobian[j][c] = scale * map.slopes[3 * c + j][0];
    }
  }
  view.inverse = glm::inverse(jacobian);
  return view;
}

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
  constexpr Part kBy[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };
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
  node.origin = ViewAt(node.centre).y;
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

std::optional<EdgeRange> EdgeBounds::Along(
  const LocatedPoint& a, const LocatedPoint& b, double sagitta) const
{
  if (!Component.finite)
  {
    return std::nullopt;
  }
  const EdgeNode* node = &LeafAt(a.eta);
  if (!node->regular || !Holds(node->wide, b.eta))
  {
    node = &LeafAt(b.eta);
    if (!node->regular || !Holds(node->wide, a.eta))
    {
      return std::nullopt;
    }
  }
  const double s[3] = { std::fabs(a.xi.x - b.xi.x), std::fabs(a.xi.y - b.xi.y),
    std::fabs(a.xi.z - b.xi.z) };
  double off[3];
  double beside[3];
  EdgeRange range{ Quadratic(node->curve, s) / 8.0, ValueError };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double besides = node->shift[k] + node->lean[k] * sagitta / Size;
    off[k] = (Quadratic(node->bend[k], s) / 8.0 + besides) * kUp;
    beside[k] = kBeside + 2.0 * node->shift[k];
    range.error += node->slope[k] * node->shift[k];
    range.deviation += node->slope[k] * (besides + 2.0 * beside[k]);
  }
  for (const EdgeNodeEnd& end : node->wideEnds)
  {
    const double depth = std::min(end.DepthOf(a.xi), end.DepthOf(b.xi)) - end.Across(off) +
      (end.ofElement ? end.Across(beside) : 0.0);
    // Written so that a NaN is not covered.
    if (!(depth >= 0.0))
    {
      return std::nullopt;
    }
  }
  if (Components > 1)
  {
    // Of the norm of a vector that changes linearly, by at most `change`: it is convex, and its
    // second derivative is at most the change's square over the norm.
    double change = 2.0 * ValueError;
    for (std::size_t k = 0; k < 3; ++k)
    {
      change += node->slope[k] * (s[k] + 2.0 * node->shift[k]);
    }
    const double least = std::max(a.value, b.value) - change;
    range.deviation += least > 0.25 * change ? change * change / (8.0 * least) : 0.5 * change;
  }
  range.deviation = (range.deviation + ValueError) * kUp;
  range.error *= kUp;
  return range;
}

bool EdgeBounds::Misses(const EdgeNode& node, const Vec3& from, const Vec3& to, double slack) const
{
  for (int d = 0; d < 3; ++d)
  {
    if (std::max(from[d], to[d]) + slack < node.bounds.lower[d] ||
      std::min(from[d], to[d]) - slack > node.bounds.upper[d])
    {
      return true;
    }
  }
  if (!node.regular)
  {
    return false;
  }
  // Every preimage in `wide` of a point of the segment is within `off` of the line between these
  // two: T(xi) = M (Phi(xi) - origin) - (xi - centre) changes by `turn` at most.
  const Vec3 ends[2] = { ToXi(node, from), ToXi(node, to) };
  const double most = std::max({ node.reach[0], node.reach[1], node.reach[2] });
  double off[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    off[k] = (node.turn[k] * most + node.shift[k] + node.lean[k] * slack / Size) * kUp + 1e-13;
  }
  double first = 0.0;
  double last = 1.0;
  for (const EdgeNodeEnd& end : node.boxEnds)
  {
    const double wider = end.Across(off);
    const double a = end.DepthOf(ends[0]) + wider;
    const double b = end.DepthOf(ends[1]) + wider;
    if (a < 0.0 && b < 0.0)
    {
      return true;
    }
    if (a < 0.0)
    {
      first = std::max(first, a / (a - b));
    }
    if (b < 0.0)
    {
      last = std::min(last, a / (a - b));
    }
  }
  return first > last + 1e-12;
}

Vec3 EdgeBounds::ToXi(const EdgeNode& node, const Vec3& x) const
{
  const Vec3 y = (x - Centre) / Size - node.origin;
  Vec3 xi = node.centre;
  for (int k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    xi[k] += row[0] * y.x + row[1] * y.y + row[2] * y.z;
  }
  return xi;
}

/// In a regular node, from the second-order expansion about a point of it near the segment.
EdgeBounds::Meeting EdgeBounds::MeetNode(const EdgeNode& node, const ValueSet& wanted,
  const Vec3& from, const Vec3& to, double slack) const
{
  const Shape shape = Map.space.shape;
  const Vec3 ends[2] = { (from - Centre) / Size, (to - Centre) / Size };
  const Vec3 middle = 0.5 * (ends[0] + ends[1]);
  View view = ViewAt(MovedInto(shape, node, ToXi(node, 0.5 * (from + to))));
  for (int step = 0; step < kSteps; ++step)
  {
    const Vec3 half = 0.5 * (view.inverse * (ends[1] - ends[0]));
    const Vec3 next = MovedInto(shape, node, view.xi + view.inverse * (middle - view.y));
    const Vec3 moved = next - view.xi;
    // Written so that a NaN ends it.
    if (!(glm::dot(moved, moved) > glm::dot(half, half)))
    {
      break;
    }
    view = ViewAt(next);
  }

  // |xi - view.xi| of the preimages in `wide` of the segment's points.
  double away[3];
  double besides[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    const auto along = [&](const Vec3& y)
    {
      const Vec3 d = y - view.y;
      return std::fabs(row[0] * d.x + row[1] * d.y + row[2] * d.z);
    };
    besides[k] = node.shift[k] + node.lean[k] * (slack / Size) + 1e-14;
    away[k] = std::max(along(ends[0]), along(ends[1])) * kUp + besides[k];
  }
  Solve(node.turn, away);
  const Vec3 steps[2] = { view.inverse * (ends[0] - view.y), view.inverse * (ends[1] - view.y) };
  // They are where the expansion puts them, up to `off`, and so no farther away than that.
  double off[3];
  for (int round = 0; round < kRounds; ++round)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      off[k] = (Quadratic(node.bend[k], away) / 2.0 + besides[k]) * kUp;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int d = static_cast<int>(k);
      away[k] = std::min(
        away[k], (std::max(std::fabs(steps[0][d]), std::fabs(steps[1][d])) + off[k]) * kUp);
    }
  }
  double first = 0.0;
  double last = 1.0;
  for (const EdgeNodeEnd& end : node.boxEnds)
  {
    const double wider = end.Across(off);
    const double a = end.DepthOf(view.xi + steps[0]) + wider;
    const double b = end.DepthOf(view.xi + steps[1]) + wider;
    if (a < 0.0 && b < 0.0)
    {
      return Meeting::None;
    }
    if (a < 0.0)
    {
      first = std::max(first, a / (a - b) - 1e-12);
    }
    if (b < 0.0)
    {
      last = std::min(last, a / (a - b) + 1e-12);
    }
  }
  if (first > last)
  {
    return Meeting::None;
  }
  const Interval linear = LinearValues(
    view.xi, steps[0] + first * (steps[1] - steps[0]), steps[0] + last * (steps[1] - steps[0]));
  double most = Quadratic(node.curve, away) / 2.0 + 2.0 * ValueError;
  for (std::size_t k = 0; k < 3; ++k)
  {
    most += node.slope[k] * besides[k];
  }
  most = most * kUp + 1e-14 * (std::fabs(linear.lower) + std::fabs(linear.upper));
  if (!wanted.Meets(rounding::Below(linear.lower - most), rounding::Above(linear.upper + most)))
  {
    return Meeting::None;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (off[k] > kCoarse * away[k] + 2.0 * besides[k])
    {
      return Meeting::Coarse;
    }
  }
  return Meeting::Near;
}

Interval EdgeBounds::LinearValues(const Vec3& xi, const Vec3& from, const Vec3& to) const
{
  const double unit = std::ldexp(1.0, Component.exponent);
  const auto width = static_cast<std::ptrdiff_t>(Component.width);
  // Of all components: the values at both ends, and their squares and product.
  double ends[2] = {};
  double squares[2] = {};
  double product = 0.0;
  double size = 0.0;
  for (int c = 0; c < Components; ++c)
  {
    const Evaluated component(Component.space, Component.values.data() + c * width, 1, xi);
    const Vec3 slope(component.slopes[0][0], component.slopes[1][0], component.slopes[2][0]);
    const double rises[2] = { glm::dot(slope, from), glm::dot(slope, to) };
    for (std::size_t k = 0; k < 2; ++k)
    {
      ends[k] = unit * (component.values[0][0] + rises[k]);
      squares[k] += ends[k] * ends[k];
    }
    product += ends[0] * ends[1];
    size += unit * (std::fabs(component.values[0][0]) + std::fabs(rises[0]) + std::fabs(rises[1]));
  }
  const double slack = 1e-14 * size;
  if (Components == 1)
  {
    return { std::min(ends[0], ends[1]) - slack, std::max(ends[0], ends[1]) + slack };
  }
  // |p + t (q - p)|: convex, least where (p + t (q - p)) . (q - p) = 0.
  const double along = squares[0] + squares[1] - 2.0 * product;
  const double t = along > 0.0 ? std::clamp((squares[0] - product) / along, 0.0, 1.0) : 0.0;
  const double least = squares[0] - 2.0 * t * (squares[0] - product) + t * t * along;
  return { std::sqrt(std::max(0.0, least - slack * size)) - slack,
    std::sqrt(std::max(squares[0], squares[1])) + slack };
}

bool EdgeBounds::MayTake(
  const ValueSet& wanted, const Vec3& from, const Vec3& to, double slack, bool grow) const
{
  return !Component.finite || MayTakeIn(Whole(), wanted, from, to, slack, grow);
}

bool EdgeBounds::MayTakeIn(const EdgeNode& node, const ValueSet& wanted, const Vec3& from,
  const Vec3& to, double slack, bool grow) const
{
  if (!wanted.Meets(node.values.lower, node.values.upper) || Misses(node, from, to, slack))
  {
    return false;
  }
  const Meeting meeting = node.regular ? MeetNode(node, wanted, from, to, slack) : Meeting::Coarse;
  if (meeting != Meeting::Coarse)
  {
    return meeting == Meeting::Near;
  }
  if (node.halvings >= Deepest[node.regular ? 1 : 0] || (!grow && node.regular))
  {
    return true;
  }
  const auto& halves = Split(node);
  return std::ranges::any_of(
    halves, [&](const EdgeNode& half) { return MayTakeIn(half, wanted, from, to, slack, grow); });
}

double EdgeBounds::ChangeWithin(const LocatedPoint& point, double distance) const
{
  const EdgeNode& node = LeafAt(point.eta);
  if (!Component.finite || !node.regular)
  {
    return kInfinity;
  }
  double change = ValueError;
  for (std::size_t k = 0; k < 3; ++k)
  {
    change += node.slope[k] * (node.lean[k] * (distance / Size) + node.shift[k]);
  }
  return change * kUp;
}
} // namespace pixelexact
