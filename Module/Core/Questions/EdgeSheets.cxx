// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeBounds.h"
#include "Core/Questions/PointValues.h"
#include "Core/Questions/Questions.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// Rays c + tau D through the points c(u) = a + u (b - a) of a chord, seen from a point of a sheet
// f = 0: with W about J^-1 and g about f' there, w = W D, q = w / (g . w), P = I - q g^T,
//
//   N(xi) = xi - P W (Phi(xi) - c) - q f(xi)
//
// has as fixed points those in which the ray meets the sheet: g . (xi - N) is f, because g P = 0;
// and what P takes to 0 is along w, so that Phi(xi) - c is along D. Neither W nor g has to be
// exact. q of a ray between two is a mean of theirs, as long as g . w has the same sign for both.
//
//   N' = -P (W J - I) - q (f' - g)
//
// is small near the point, by the node's bounds of W Phi'' and f''. Where N takes a box about a
// point of the path xi(u) to itself, the ray meets the sheet in it (Brouwer); by
// W (Phi(xi) - c) = tau w, the way there along the ray is tau = g . W (Phi(xi) - c) / (g . w).
namespace pixelexact
{
using namespace edges;

namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kRounds = 6;
/// Of Newton's iteration towards where a sheet leaves its element.
constexpr int kSteps = 8;
/// Halvings of a node for a chord.
constexpr int kSmaller = 6;
/// Covers the rounding of some dozen products and sums.
constexpr double kRoundoffs = 32.0 * kUnitRoundoff;
/// Row sums of |W J - I|, of rounding: beyond, the map is too nearly singular.
constexpr double kSingular = 1e-3;
/// A ray is not known to cross the sheet where g . w is so much smaller than its terms; then q is
/// good to kSteep.
constexpr double kGrazing = 1e-6;
constexpr double kSteep = 1e-8;
/// In xi, after a step: far less than what exits are beside the element.
constexpr double kArrived = 1e-12;
/// In xi: more than rays and hits are off by rounding, in thin elements seen from afar.
constexpr double kMostRounding = 1e-7;
/// In xi: what no bound has to be below.
constexpr double kTiny = 1e-15;

struct Numbers
{
  double at[3]{};

  double& operator[](std::size_t k) { return at[k]; }
  double operator[](std::size_t k) const { return at[k]; }
  [[nodiscard]] double Largest() const { return std::max({ at[0], at[1], at[2] }); }
  [[nodiscard]] double Sum() const { return at[0] + at[1] + at[2]; }
};

Numbers Magnitudes(const Vec3& v)
{
  return { { std::fabs(v.x), std::fabs(v.y), std::fabs(v.z) } };
}
} // namespace

/// A sheet of an element.
class EdgeBounds::OnSheet
{
public:
  OnSheet(const EdgeBounds& bounds, const Sheet& sheet)
    : Of(bounds)
    , TheSheet(sheet)
  {
    if (sheet.face >= 0)
    {
      const ShapeFace& face = FacesOf(bounds.Map.space.shape)[static_cast<std::size_t>(sheet.face)];
      Own = 2 * static_cast<std::size_t>(face.direction) + (face.upper ? 1U : 0U);
    }
  }

  struct Values
  {
    Vec3 y{ 0.0 }; ///< of the map, in the element's units
    Mat3 jacobian{ 0.0 };
    double f = 0.0; ///< 0 on the sheet
    Vec3 gradient{ 0.0 };
    double size = 0.0; ///< of the component
  };
  template <std::size_t N>
  [[nodiscard]] std::array<Values, N> At(const std::array<Vec3, N>& xi) const;

  /// N's numbers at a point, for all rays between two.
  struct Pencil
  {
    Mat3 inverse{ 0.0 }; ///< W
    Numbers miss;        ///< row sums of |W J - I|
    Numbers towards;     ///< |q|
    double project[3][3]{};
    double across = kInfinity; ///< |g . w|, the least
  };
  [[nodiscard]] std::optional<Pencil> PencilOf(
    const Values& at, const Vec3& first, const Vec3& last) const;

  [[nodiscard]] double Sagitta(const EdgeNode& node, const Pencil& pencil, const SheetPoint& a,
    const SheetPoint& b, const std::array<Values, 3>& at) const;
  [[nodiscard]] std::optional<SheetExit> ExitOf(
    const SheetPoint& from, const SheetPoint& towards) const;

private:
  /// |f''| over a node, mixed ones twice: as far from the path's first point as that, if f is a
  /// norm.
  struct Bent
  {
    double at[6]{};
  };
  [[nodiscard]] Bent BentOf(const EdgeNode& node, const Values& at, const Numbers& near) const;
  [[nodiscard]] double SlopeErrorOf(const EdgeNode& node, const Values& at) const;
  [[nodiscard]] double ErrorOf(const Values& at) const;

  /// The boxes about the points of a path, all of them 4 u (1 - u) `middle` + `end` to each side.
  struct Tube
  {
    Numbers middle;
    Numbers end;
    double rise = 0.0; ///< of g . W (Phi - c), from the path to the sheet
  };
  [[nodiscard]] std::optional<Tube> Contain(const EdgeNode& node, const Pencil& pencil,
    const Values& at, const Numbers& length, const Numbers& middle, const Numbers& end) const;
  [[nodiscard]] bool IsInside(
    const EdgeNode& node, const Vec3& a, const Vec3& b, const Tube& tube) const;
  /// Of g . W Phi(xi(u)) - f(xi(u)), by u.
  [[nodiscard]] double BendAlong(const EdgeNode& node, const Pencil& pencil, const Values& at,
    const Vec3& d, const Bent& f) const;
  [[nodiscard]] bool IsNorm() const { return TheSheet.face < 0 && Of.Components > 1; }

  const EdgeBounds& Of;
  Sheet TheSheet;
  std::size_t Own = 6; ///< the element's end that the face is
};

template <std::size_t N>
std::array<EdgeBounds::OnSheet::Values, N> EdgeBounds::OnSheet::At(
  const std::array<Vec3, N>& xi) const
{
  std::array<Values, N> all;
  const PointValues map(Of.Map.space, Of.Map.values.data(), 3, xi);
  const double scale = std::ldexp(1.0, Of.Map.exponent);
  for (std::size_t i = 0; i < N; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      all[i].y[c] = scale * map.values[c][i];
      for (int j = 0; j < 3; ++j)
      {
        all[i].jacobian[j][c] = scale * map.slopes[3 * c + j][i];
      }
    }
    if (Own < 6)
    {
      const EdgeNodeEnd& end = Of.Ends[Own];
      all[i].f = end.DepthOf(xi[i]);
      all[i].gradient = -Vec3(end.normal[0], end.normal[1], end.normal[2]);
    }
  }
  if (Own < 6)
  {
    return all;
  }
  const double unit = std::ldexp(1.0, Of.Component.exponent);
  for (int c = 0; c < Of.Components; ++c)
  {
    const PointValues component(Of.Component.space,
      Of.Component.values.data() +
        static_cast<std::ptrdiff_t>(c) * static_cast<std::ptrdiff_t>(Of.Component.width),
      1, xi);
    for (std::size_t i = 0; i < N; ++i)
    {
      const double value = unit * component.values[0][i];
      const Vec3 slope =
        unit * Vec3(component.slopes[0][i], component.slopes[1][i], component.slopes[2][i]);
      all[i].size = IsNorm() ? std::hypot(all[i].size, value) : value;
      all[i].gradient += (IsNorm() ? value : 1.0) * slope;
    }
  }
  for (Values& at : all)
  {
    at.gradient /= IsNorm() ? at.size : 1.0;
    at.f = at.size - TheSheet.value;
    at.size = std::fabs(at.size);
  }
  return all;
}

std::optional<EdgeBounds::OnSheet::Pencil> EdgeBounds::OnSheet::PencilOf(
  const Values& at, const Vec3& first, const Vec3& last) const
{
  Pencil pencil;
  pencil.inverse = glm::inverse(at.jacobian);
  const Mat3& W = pencil.inverse;
  const Mat3 product = W * at.jacobian;
  for (int k = 0; k < 3; ++k)
  {
    double sum = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      double size = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        size +=
          std::fabs(W[c][k]) * (kRoundoffs * std::fabs(at.jacobian[j][c]) + Of.SlopeErrors[0]);
      }
      sum += std::fabs(product[j][k] - (j == k ? 1.0 : 0.0)) + size;
    }
    pencil.miss[static_cast<std::size_t>(k)] = sum * kUp;
  }
  // Written so that a NaN is not known.
  if (!(pencil.miss[0] <= kSingular && pencil.miss[1] <= kSingular && pencil.miss[2] <= kSingular))
  {
    return std::nullopt;
  }
  const bool rises = glm::dot(at.gradient, W * first) > 0.0;
  for (const Vec3& direction : { first, last })
  {
    const Vec3 w = W * direction;
    const double across = glm::dot(at.gradient, w);
    double size = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        size += std::fabs(at.gradient[k] * W[c][k] * direction[c]);
      }
    }
    if (!(std::fabs(across) > kGrazing * size && (across > 0.0) == rises))
    {
      return std::nullopt;
    }
    pencil.across = std::min(pencil.across, std::fabs(across) - kRoundoffs * size);
    for (int k = 0; k < 3; ++k)
    {
      const auto row = static_cast<std::size_t>(k);
      const double q = w[k] / across;
      pencil.towards[row] =
        std::max(pencil.towards[row], std::fabs(q) + kSteep * glm::length(w) / std::fabs(across));
      for (int j = 0; j < 3; ++j)
      {
        const double back = q * at.gradient[j];
        double& entry = pencil.project[row][static_cast<std::size_t>(j)];
        entry = std::max(
          entry, std::fabs((j == k ? 1.0 : 0.0) - back) + kSteep * (1.0 + std::fabs(back)));
      }
    }
  }
  return pencil;
}

EdgeBounds::OnSheet::Bent EdgeBounds::OnSheet::BentOf(
  const EdgeNode& node, const Values& at, const Numbers& near) const
{
  Bent bent;
  if (TheSheet.face >= 0)
  {
    return bent;
  }
  // Of |F|, which is convex: |F''| and |F'|^2 / |F| besides.
  double least = kInfinity;
  if (IsNorm())
  {
    least = at.size - Of.ValueError;
    for (std::size_t k = 0; k < 3; ++k)
    {
      least -= node.slope[k] * near[k] * kUp;
    }
  }
  for (std::size_t p = 0; p < 6; ++p)
  {
    const double twice = kRows[p] == kColumns[p] ? 1.0 : 2.0;
    const double turn = IsNorm() ? node.slope[kRows[p]] * node.slope[kColumns[p]] / least : 0.0;
    bent.at[p] = least > 0.0 ? twice * (node.second[3][p].Magnitude() + turn) * kUp : kInfinity;
  }
  return bent;
}

double EdgeBounds::OnSheet::ErrorOf(const Values& at) const
{
  return Own < 6 ? kRoundoffs : Of.ValueError + kRoundoffs * (at.size + std::fabs(TheSheet.value));
}

double EdgeBounds::OnSheet::SlopeErrorOf(const EdgeNode& node, const Values& at) const
{
  if (Own < 6)
  {
    return 0.0;
  }
  const double most = std::max({ node.slope[0], node.slope[1], node.slope[2] });
  return Of.SlopeErrors[1] + kRoundoffs * most +
    (IsNorm() ? 2.0 * most * Of.ValueError / at.size : 0.0);
}

std::optional<EdgeBounds::OnSheet::Tube> EdgeBounds::OnSheet::Contain(const EdgeNode& node,
  const Pencil& pencil, const Values& at, const Numbers& length, const Numbers& middle,
  const Numbers& end) const
{
  const double slopeError = SlopeErrorOf(node, at);
  Tube tube;
  for (std::size_t k = 0; k < 3; ++k)
  {
    tube.middle[k] = 2.0 * middle[k] + kTiny;
    tube.end[k] = 2.0 * end[k] + kTiny;
  }
  for (int round = 0; round < kRounds; ++round)
  {
    Numbers near;
    for (std::size_t k = 0; k < 3; ++k)
    {
      near[k] = (length[k] + tube.middle[k] + tube.end[k]) * kUp;
    }
    const Bent bent = BentOf(node, at, near);
    double rise = 0.0;
    // By how much N moves what is off by v, from where it moves the path.
    const auto moved = [&](const Numbers& v)
    {
      Numbers e;
      for (std::size_t k = 0; k < 3; ++k)
      {
        e[k] = Bilinear(node.bend[k], near.at, v.at);
      }
      const double most = e.Largest() + v.Largest();
      const double h = Bilinear(bent.at, near.at, v.at) + slopeError * v.Sum();
      Numbers to;
      rise += h;
      for (std::size_t k = 0; k < 3; ++k)
      {
        e[k] += pencil.miss[k] * most;
        rise += std::fabs(at.gradient[static_cast<int>(k)]) * e[k];
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        to[k] = pencil.towards[k] * h;
        for (std::size_t j = 0; j < 3; ++j)
        {
          to[k] += pencil.project[k][j] * e[j];
        }
      }
      return to;
    };
    const Numbers middleMoves = moved(tube.middle);
    const Numbers endMoves = moved(tube.end);
    bool contained = true;
    Tube wider;
    for (std::size_t k = 0; k < 3; ++k)
    {
      wider.middle[k] = (middle[k] + middleMoves[k]) * kUp;
      wider.end[k] = (end[k] + endMoves[k]) * kUp;
      contained = contained && wider.middle[k] <= tube.middle[k] && wider.end[k] <= tube.end[k];
    }
    if (contained)
    {
      tube.rise = rise * kUp;
      return tube;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      tube.middle[k] = std::max(tube.middle[k], 1.5 * wider.middle[k]);
      tube.end[k] = std::max(tube.end[k], 1.5 * wider.end[k]);
    }
  }
  return std::nullopt;
}

/// As far as a path that lies in the element may be beside it, and up to rounding, which is the
/// tube's ends.
bool EdgeBounds::OnSheet::IsInside(
  const EdgeNode& node, const Vec3& a, const Vec3& b, const Tube& tube) const
{
  if (tube.end.Largest() > kMostRounding)
  {
    return false;
  }
  constexpr double kBesides[3] = { kBeside, kBeside, kBeside };
  for (std::size_t k = 0; k < 6; ++k)
  {
    const EdgeNodeEnd& end = node.wideEnds[k];
    if (k == Own)
    {
      // On the face nothing leaves it: g . (N - xi) is -f.
      if (!end.ofElement)
      {
        return false;
      }
      continue;
    }
    // So far beside a box its bounds hold, too, up to kSteep. On a collapsed edge all boxes meet.
    const double beside = end.Across(kBesides);
    const double depths[2] = { end.DepthOf(a) + beside, end.DepthOf(b) + beside };
    // 4 u (1 - u) is at most 4 times the distance from the end that is deeper. A NaN is outside.
    if (!(std::min(depths[0], depths[1]) >= 0.0 &&
          std::max(depths[0], depths[1]) >= 4.0 * end.Across(tube.middle.at) * kUp))
    {
      return false;
    }
  }
  return true;
}

double EdgeBounds::OnSheet::BendAlong(
  const EdgeNode& node, const Pencil& pencil, const Values& at, const Vec3& d, const Bent& f) const
{
  // By the world: n = g W. Middles of ranges and how far what they stand for is off.
  double middle = 0.0;
  double off = 0.0;
  const Vec3 n = at.gradient * pencil.inverse;
  const Vec3 sizes = glm::abs(at.gradient) *
    Mat3(glm::abs(pencil.inverse[0]), glm::abs(pencil.inverse[1]), glm::abs(pencil.inverse[2]));
  for (std::size_t p = 0; p < 6; ++p)
  {
    double entry = 0.0;
    double radius = 0.0;
    const auto add = [&](double factor, double size, const Interval& range)
    {
      const double centre = 0.5 * (range.lower + range.upper);
      entry += factor * centre;
      radius += size * (0.5 * (range.upper - range.lower) + kRoundoffs * std::fabs(centre));
    };
    for (int c = 0; c < 3; ++c)
    {
      add(n[c], sizes[c], node.second[static_cast<std::size_t>(c)][p]);
    }
    if (!IsNorm())
    {
      add(-1.0, 1.0, node.second[3][p]);
    }
    const double twice = kRows[p] == kColumns[p] ? 1.0 : 2.0;
    const double product = twice * d[static_cast<int>(kRows[p])] * d[static_cast<int>(kColumns[p])];
    middle += entry * product;
    off += radius * std::fabs(product);
  }
  return (std::fabs(middle) + off + (IsNorm() ? Quadratic(f.at, Magnitudes(d).at) : 0.0)) * kUp;
}

double EdgeBounds::OnSheet::Sagitta(const EdgeNode& node, const Pencil& pencil, const SheetPoint& a,
  const SheetPoint& b, const std::array<Values, 3>& at) const
{
  if (!node.regular)
  {
    return kInfinity;
  }
  // The path is the straight line in xi. How far its ends are from the rays, and off the sheet:
  Numbers miss;
  double off = std::max(a.off, b.off);
  double f = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const SheetPoint& end = i == 0 ? a : b;
    const Vec3 y = (end.x - Of.Centre) / Of.Size;
    for (int c = 0; c < 3; ++c)
    {
      const auto axis = static_cast<std::size_t>(c);
      miss[axis] = std::max(miss[axis],
        std::fabs(y[c] - at[i].y[c]) + Of.Uncertainty[axis] + off / Of.Size +
          kRoundoffs * (std::fabs(end.x[c]) + std::fabs(Of.Centre[c])) / Of.Size);
    }
    f = std::max(f, std::fabs(at[i].f) + ErrorOf(at[i]));
  }
  const Vec3 d = b.xi - a.xi;
  const Numbers length = Magnitudes(d);
  const Bent bent = BentOf(node, at[0], length);
  const double curve = Quadratic(bent.at, length.at) / 8.0;
  Numbers middle;
  Numbers end;
  double rise = f;
  double roundings = ErrorOf(at[2]);
  Numbers bend;
  Numbers shift;
  for (std::size_t k = 0; k < 3; ++k)
  {
    bend[k] = Quadratic(node.bend[k], length.at) / 8.0;
    for (int c = 0; c < 3; ++c)
    {
      const auto axis = static_cast<std::size_t>(c);
      const double size = std::fabs(pencil.inverse[c][static_cast<int>(k)]);
      shift[k] += size * miss[axis];
      roundings += std::fabs(at[0].gradient[static_cast<int>(k)]) * size * Of.Uncertainty[axis];
    }
    rise += std::fabs(at[0].gradient[static_cast<int>(k)]) * shift[k];
  }
  const double most = bend.Largest();
  for (std::size_t k = 0; k < 3; ++k)
  {
    middle[k] = pencil.towards[k] * curve;
    end[k] = pencil.towards[k] * f;
    for (std::size_t j = 0; j < 3; ++j)
    {
      middle[k] += pencil.project[k][j] * (bend[j] + pencil.miss[j] * most);
      end[k] += pencil.project[k][j] * shift[j];
    }
    middle[k] *= kUp;
    end[k] *= kUp;
  }
  const auto tube = Contain(node, pencil, at[0], length, middle, end);
  if (!tube || !IsInside(node, a.xi, b.xi, *tube))
  {
    return kInfinity;
  }
  // Off the straight line at the middle, as evaluated, and off those to the middle.
  const Vec3 sag = pencil.inverse * (at[2].y - 0.5 * (at[0].y + at[1].y));
  rise += std::fabs(glm::dot(at[0].gradient, sag) - at[2].f + 0.5 * (at[0].f + at[1].f)) +
    2.0 * roundings + BendAlong(node, pencil, at[0], d, bent) / 32.0 + tube->rise;
  return (rise / pencil.across * Of.Size + off) * (1.0 + kSteep);
}

std::optional<SheetExit> EdgeBounds::OnSheet::ExitOf(
  const SheetPoint& from, const SheetPoint& towards) const
{
  const Vec3 chord = (towards.x - from.x) / Of.Size;
  const auto directionAt = [&](double part)
  {
    return glm::normalize(
      (1.0 - part) * from.distance * from.direction + part * towards.distance * towards.direction);
  };
  SheetExit exit;
  exit.point.xi = from.xi;
  for (int step = 0; step < kSteps; ++step)
  {
    const Values at = At(std::array{ exit.point.xi })[0];
    const Mat3 W = glm::inverse(at.jacobian);
    const Vec3 w = W * directionAt(exit.part);
    const Vec3 q = w / glm::dot(at.gradient, w);
    // Where the ray through c(u) meets the sheet, to first order: base + u along.
    const Vec3 back = W * (at.y - (from.x - Of.Centre) / Of.Size);
    const Vec3 forth = W * chord;
    const Vec3 base = exit.point.xi - back + q * (glm::dot(at.gradient, back) - at.f);
    const Vec3 along = forth - q * glm::dot(at.gradient, forth);
    double part = 1.0;
    for (std::size_t k = 0; k < 6; ++k)
    {
      const EdgeNodeEnd& end = Of.Ends[k];
      const double outwards =
        end.normal[0] * along.x + end.normal[1] * along.y + end.normal[2] * along.z;
      // Half of what a path may be beside the element, for the neighbour's to overlap.
      constexpr double kHalf[3] = { 0.5 * kBeside, 0.5 * kBeside, 0.5 * kBeside };
      if (k != Own && outwards > 0.0)
      {
        part = std::min(part, (end.DepthOf(base) + end.Across(kHalf)) / outwards);
      }
    }
    const Vec3 next = base + part * along;
    const Vec3 moved = next - exit.point.xi;
    const bool arrived = glm::length(moved) <= kArrived;
    exit.point.xi = next;
    exit.part = part;
    // Written so that a NaN ends it.
    if (!(part >= 0.0 && part <= 1.0))
    {
      return std::nullopt;
    }
    if (arrived)
    {
      const Vec3 c = from.x + part * (towards.x - from.x);
      exit.point.direction = directionAt(part);
      const double tau = glm::dot(Of.Centre + Of.Size * Of.ImageOf(next) - c, exit.point.direction);
      exit.point.x = c + tau * exit.point.direction;
      exit.point.distance = (1.0 - part) * from.distance + part * towards.distance;
      exit.point.off = std::max(from.off, towards.off);
      exit.beside = std::fabs(tau);
      return exit;
    }
  }
  return std::nullopt;
}

double EdgeBounds::Sagitta(const Sheet& sheet, const SheetPoint& a, const SheetPoint& b) const
{
  if (!Component.finite)
  {
    return kInfinity;
  }
  const OnSheet on(*this, sheet);
  const auto at = on.At(std::array{ a.xi, b.xi, 0.5 * (a.xi + b.xi) });
  const auto pencil = on.PencilOf(at[0], a.direction, b.direction);
  if (!pencil)
  {
    return kInfinity;
  }
  const auto etaOf = [this](const Vec3& xi)
  { return glm::clamp(ReferenceToTensor(Map.space.shape, xi), Vec3(-1.0), Vec3(1.0)); };
  const Vec3 etas[3] = { etaOf(a.xi), etaOf(b.xi), etaOf(0.5 * (a.xi + b.xi)) };
  // Where rays nearly touch the sheet, smaller nodes tell more.
  const EdgeNode* node = &LeafAt(etas[2]);
  double sagitta = on.Sagitta(*node, *pencil, a, b, at);
  for (int k = 0; k < kSmaller && !std::isfinite(sagitta) && node->regular; ++k)
  {
    const auto& halves = Split(*node);
    const int d = node->direction;
    node = &halves[etas[2][d] <= halves[0].box.upper[d] ? 0 : 1];
    if (!node->wide.Holds(etas[0]) || !node->wide.Holds(etas[1]))
    {
      break;
    }
    sagitta = on.Sagitta(*node, *pencil, a, b, at);
  }
  return sagitta;
}

std::optional<SheetExit> EdgeBounds::ExitOf(
  const Sheet& sheet, const SheetPoint& from, const SheetPoint& towards) const
{
  return Component.finite ? OnSheet(*this, sheet).ExitOf(from, towards) : std::nullopt;
}
} // namespace pixelexact
