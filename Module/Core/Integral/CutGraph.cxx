// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/CutGraph.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Bernstein/RootFinder.h"
#include "Core/Integral/ElementIntegral.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
/// A box is clipped only if its width falls below this fraction; otherwise new polynomials cost
/// more than they gain.
constexpr double kWorthClipping = 0.8;
/// Clipped ends lie outside the surface by this fraction of the width, so that the surface does not
/// cross them and they are no limits.
constexpr double kRoom = 0.05;
/// Boxes are not clipped below this width, in the piece's units.
constexpr double kNarrowestClip = 0x1p-34;
constexpr int kClippings = 4;
/// Strips exceed the roots in them by this fraction of the box.
constexpr double kStrip = 0x1p-40;

double At(const PieceBox& box, int direction, double s)
{
  return s <= -1.0 ? box.lower[direction]
    : s >= 1.0
    ? box.upper[direction]
    : box.lower[direction] + 0.5 * (s + 1.0) * (box.upper[direction] - box.lower[direction]);
}

/// Finds the part of [-1, 1] along each direction outside of which an affine enclosure has no zero.
/// Returns false where it has none in the box.
bool Clip(const AffineForm& f, Vec3& from, Vec3& to)
{
  double all = 0.0;
  for (const double b : f.b)
  {
    all = rounding::Above(all + std::fabs(b));
  }
  const Interval constant = Interval(f.a) + f.e;
  if (!(constant + Interval(-all, all)).Contains(0.0))
  {
    return false;
  }
  for (int d = 0; d < 3; ++d)
  {
    const double b = f.b[static_cast<std::size_t>(d)];
    from[d] = -1.0;
    to[d] = 1.0;
    if (b == 0.0)
    {
      continue;
    }
    double others = 0.0;
    for (int o = 0; o < 3; ++o)
    {
      others =
        o == d ? others : rounding::Above(others + std::fabs(f.b[static_cast<std::size_t>(o)]));
    }
    const Interval s = -(constant + Interval(-others, others)) / Interval(b);
    const double room = kRoom * (s.upper - s.lower);
    from[d] = std::clamp(s.lower - room, -1.0, 1.0);
    to[d] = std::clamp(s.upper + room, -1.0, 1.0);
  }
  return true;
}

/// The sign of a function's values that are not within the tolerance of zero.
enum class Sign : std::uint8_t
{
  Negative,
  Positive,
  Zero, ///< within the tolerance throughout
  Mixed
};
Sign SignOf(const Interval& hull, double tolerance)
{
  // Without a tolerance, zero has neither sign.
  const bool notPositive = tolerance > 0.0 ? hull.upper <= tolerance : hull.upper < 0.0;
  const bool notNegative = tolerance > 0.0 ? hull.lower >= -tolerance : hull.lower > 0.0;
  return notPositive ? (notNegative ? Sign::Zero : Sign::Negative)
                     : (notNegative ? Sign::Positive : Sign::Mixed);
}

/// A crossing of the graph with an end of its direction: phi >= 0 is inside.
struct Crossing2
{
  BoxPolynomial phi;
  bool upper = false;
};

BoxPolynomial Times(double sign, BoxPolynomial f)
{
  for (double& b : f.b)
  {
    b *= sign;
  }
  return f;
}

class GraphSearch
{
public:
  GraphSearch(
    const ElementFunctions& functions, const BoxPolynomial& cut, double tolerance, CutInBox& found)
    : Functions(functions)
    , Cut(cut)
    , Tolerance(tolerance)
    , Found(found)
  {
  }

  void Search(const AffineForm& affine)
  {
    std::array<int, 3> order{ 0, 1, 2 };
    const auto slope = [&affine](int d)
    { return std::fabs(affine.b[static_cast<std::size_t>(d)]); };
    std::ranges::sort(order, [&](int a, int b) { return slope(a) > slope(b); });
    std::vector<std::pair<int, std::vector<Crossing2>>> left;
    for (const int c : order)
    {
      const Interval derivative = Derivative(Cut, c).Hull();
      if (derivative.Contains(0.0))
      {
        continue;
      }
      auto crossed = Crossed(c, derivative.lower > 0.0 ? 1.0 : -1.0);
      if (!crossed)
      {
        Found.empty = true;
        Found.decided = true;
        return;
      }
      if (crossed->empty())
      {
        const int b = slope((c + 1) % 3) > slope((c + 2) % 3) ? (c + 1) % 3 : (c + 2) % 3;
        Found.decided = true;
        Found.graphs.push_back({ Found.box, { 3 - b - c, b, c } });
        return;
      }
      left.emplace_back(c, std::move(*crossed));
    }
    for (const auto& [c, crossed] : left)
    {
      for (const int b : order)
      {
        if (b != c && Split({ 3 - b - c, b, c }, crossed))
        {
          Found.decided = true;
          return;
        }
      }
    }
  }

private:
  [[nodiscard]] double ToleranceAt(int direction, bool upper) const
  {
    return Functions.IsOnCube(Found.box, direction, upper) ? Tolerance : 0.0;
  }

  /// The ends along c that the graph may cross; none where there is no graph.
  [[nodiscard]] std::optional<std::vector<Crossing2>> Crossed(int c, double sign) const
  {
    std::vector<Crossing2> crossed;
    for (const bool upper : { false, true })
    {
      BoxPolynomial phi = Times(upper ? sign : -sign, Cut.AtEnd(c, upper));
      const double tolerance = ToleranceAt(c, upper);
      switch (SignOf(phi.Hull(), tolerance))
      {
        case Sign::Negative:
          return std::nullopt;
        case Sign::Mixed:
          crossed.push_back({ std::move(phi), upper });
          break;
        default:
          break;
      }
    }
    return crossed;
  }

  /// An edge of an end of c, along a, with its sign where it has one.
  struct Edge
  {
    BoxPolynomial phi;
    Sign sign = Sign::Mixed;
    std::vector<Interval> roots; ///< of a, in [-1, 1]
  };

  /// Returns whether each crossed end is proven to be crossed once along b; if so, finds the
  /// graphs.
  bool Split(const std::array<int, 3>& axes, const std::vector<Crossing2>& crossed)
  {
    const auto [a, b, c] = axes;
    std::vector<double> sense;
    std::vector<std::array<Edge, 2>> edges;
    std::vector<Interval> changes;
    for (const Crossing2& crossing : crossed)
    {
      const Interval slope = Derivative(crossing.phi, b).Hull();
      if (slope.Contains(0.0) || (!sense.empty() && (slope.lower > 0.0) == (sense.front() > 0.0)))
      {
        return false;
      }
      sense.push_back(slope.lower > 0.0 ? 1.0 : -1.0);
      edges.emplace_back();
      for (const bool upper : { false, true })
      {
        Edge& edge = edges.back()[upper ? 1 : 0];
        edge.phi = crossing.phi.AtEnd(b, upper);
        edge.sign = SignOf(edge.phi.Hull(), ToleranceAt(b, upper));
        if (edge.sign == Sign::Zero)
        {
          // Takes the sign in the box next to the edge.
          edge.sign = (sense.back() > 0.0) != upper ? Sign::Positive : Sign::Negative;
        }
        if (edge.sign == Sign::Mixed && !FindRoots(a, edge, changes))
        {
          return false;
        }
      }
    }
    std::ranges::sort(changes, {}, &Interval::lower);
    std::vector<CutGraph> graphs;
    std::vector<CutGraph> rest;
    double from = -1.0;
    for (std::size_t i = 0; i <= changes.size(); ++i)
    {
      const double to = i < changes.size() ? changes[i].lower : 1.0;
      if (to > from)
      {
        CutGraph graph{ Part(a, from, to), axes };
        bool none = false;
        for (std::size_t k = 0; k < crossed.size(); ++k)
        {
          if (!Limit(a, crossed[k], edges[k], 0.5 * (from + to), graph, none))
          {
            return false;
          }
        }
        if (!none)
        {
          graphs.push_back(graph);
        }
      }
      if (i < changes.size())
      {
        const double end = std::max(from, changes[i].upper);
        rest.push_back({ Part(a, std::max(from, changes[i].lower), end), axes });
        from = end;
      }
    }
    Found.graphs = std::move(graphs);
    Found.rest = std::move(rest);
    return true;
  }

  [[nodiscard]] PieceBox Part(int a, double from, double to) const
  {
    PieceBox part = Found.box;
    part.lower[a] = At(Found.box, a, from);
    part.upper[a] = At(Found.box, a, to);
    return part;
  }

  /// The sign of an edge at a place away from its roots.
  static Sign SignAt(const Edge& edge, int a, double s)
  {
    if (edge.sign != Sign::Mixed)
    {
      return edge.sign;
    }
    std::array<double, 3> place{ 0.0, 0.0, 0.0 };
    place[static_cast<std::size_t>(a)] = s;
    return SignOf(edge.phi.At(place), 0.0);
  }

  static bool Limit(int a, const Crossing2& crossing, const std::array<Edge, 2>& edges, double s,
    CutGraph& graph, bool& none)
  {
    const Sign below = SignAt(edges[0], a, s);
    const Sign above = SignAt(edges[1], a, s);
    if (below == Sign::Mixed || above == Sign::Mixed)
    {
      return false;
    }
    const GraphLimit limit = crossing.upper ? GraphLimit::ThroughUpper : GraphLimit::ThroughLower;
    if (below == Sign::Negative && above == Sign::Negative)
    {
      none = true;
    }
    else if (below == Sign::Negative)
    {
      graph.low = limit;
    }
    else if (above == Sign::Negative)
    {
      graph.high = limit;
    }
    return true;
  }

  /// Returns false where not all roots are known.
  static bool FindRoots(int a, Edge& edge, std::vector<Interval>& changes)
  {
    const TensorPolynomial line{ { edge.phi.degree[static_cast<std::size_t>(a)], 0, 0 }, edge.phi.b,
      edge.phi.error };
    const RootSearchResult found =
      pixelexact::FindRoots(PolynomialSystem(1, std::span(&line, 1)), { .budget = 200 });
    if (!found.IsComplete())
    {
      return false;
    }
    for (const IsolatedRoot& root : found.roots)
    {
      const Interval t = root.enclosure[0];
      const double from = std::clamp(2.0 * t.lower - 1.0 - kStrip, -1.0, 1.0);
      const double to = std::clamp(2.0 * t.upper - 1.0 + kStrip, -1.0, 1.0);
      if (from < to)
      {
        changes.emplace_back(from, to);
      }
    }
    return true;
  }

  const ElementFunctions& Functions;
  const BoxPolynomial& Cut;
  double Tolerance;
  CutInBox& Found;
};
} // namespace

CutInBox LookAtCut(ElementFunctions& functions, const PieceBox& box, double tolerance)
{
  CutInBox found{ .box = box, .graphs = {}, .rest = {} };
  BoxPolynomial cut = functions.Cut(box);
  AffineForm affine = cut.Affine();
  for (int clipping = 0;; ++clipping)
  {
    Vec3 from(-1.0);
    Vec3 to(1.0);
    if (!cut.Hull().Contains(0.0) || !Clip(affine, from, to))
    {
      found.empty = true;
      found.decided = true;
      return found;
    }
    bool worth = false;
    PieceBox clipped = found.box;
    for (int d = 0; d < 3; ++d)
    {
      const double width = found.box.upper[d] - found.box.lower[d];
      if (to[d] - from[d] < 2.0 * kWorthClipping &&
        0.5 * (to[d] - from[d]) * width > kNarrowestClip)
      {
        clipped.lower[d] = At(found.box, d, from[d]);
        clipped.upper[d] = At(found.box, d, to[d]);
        worth = true;
      }
    }
    if (!worth || clipping == kClippings)
    {
      break;
    }
    found.box = clipped;
    cut = functions.Cut(clipped);
    affine = cut.Affine();
  }
  bool isOnCube = false;
  for (int d = 0; d < 3; ++d)
  {
    isOnCube =
      isOnCube || functions.IsOnCube(found.box, d, false) || functions.IsOnCube(found.box, d, true);
  }
  // Uses the box's own tolerance if it is smaller.
  GraphSearch(functions, cut,
    isOnCube ? std::min(tolerance, CutTolerance(functions, found.box)) : tolerance, found)
    .Search(affine);
  return found;
}
} // namespace pixelexact
