// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/Mat.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/OnSheet.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pixelexact
{
using namespace edges;

namespace
{
constexpr int kChordRounds = 6;
/// The largest rounding of rays and hits, in xi, in thin elements seen from afar.
constexpr double kMaxRounding = 1e-7;
/// No bound in xi needs to be below this.
constexpr double kTiny = 1e-15;
} // namespace

OnSheet::Bent OnSheet::BentOf(const EdgeNode& node, const Values& at, const Numbers& near) const
{
  Bent bent;
  if (sheet_.face >= 0)
  {
    return bent;
  }
  // |F| is convex: its second derivative is at most |F''| plus |F'|^2 / |F|.
  double least = kInfinity;
  if (IsNorm())
  {
    least = at.size - Of.ValueError();
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

std::optional<OnSheet::Tube> OnSheet::Contain(const EdgeNode& node, const Pencil& pencil,
  const Values& at, const Numbers& length, const Numbers& middle, const Numbers& end) const
{
  const double slopeError = SlopeErrorOf(node, at);
  Tube tube;
  for (std::size_t k = 0; k < 3; ++k)
  {
    tube.middle[k] = 2.0 * middle[k] + kTiny;
    tube.end[k] = 2.0 * end[k] + kTiny;
  }
  for (int round = 0; round < kChordRounds; ++round)
  {
    Numbers near;
    for (std::size_t k = 0; k < 3; ++k)
    {
      near[k] = (length[k] + tube.middle[k] + tube.end[k]) * kUp;
    }
    const Bent bent = BentOf(node, at, near);
    double rise = 0.0;
    // Bounds the distance between N's images of the path and of a point that is off the path by v.
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

/// Whether the tube lies in the node enlarged by kOverlap, and its ends are as narrow as rounding
/// (kMaxRounding).
bool OnSheet::IsInside(const EdgeNode& node, const Vec3& a, const Vec3& b, const Tube& tube) const
{
  if (tube.end.Largest() > kMaxRounding)
  {
    return false;
  }
  constexpr double kOverlaps[3] = { kOverlap, kOverlap, kOverlap };
  for (std::size_t k = 0; k < 6; ++k)
  {
    const EdgeNodeEnd& end = node.wideEnds[k];
    if (k == Own)
    {
      // On the face nothing leaves the box: g . (N - xi) is -f.
      if (!end.ofElement)
      {
        return false;
      }
      continue;
    }
    // This far outside a box its bounds still hold, up to kSteep. On a collapsed edge all boxes
    // meet.
    const double beside = end.Across(kOverlaps);
    const double depths[2] = { end.DepthOf(a) + beside, end.DepthOf(b) + beside };
    // 4 u (1 - u) is at most 4 times the distance from the deeper end. A NaN counts as outside.
    if (!(std::min(depths[0], depths[1]) >= 0.0 &&
          std::max(depths[0], depths[1]) >= 4.0 * end.Across(tube.middle.at) * kUp))
    {
      return false;
    }
  }
  return true;
}

double OnSheet::BendAlong(
  const EdgeNode& node, const Pencil& pencil, const Values& at, const Vec3& d, const Bent& f) const
{
  // In world coordinates: n = g W. Middles of ranges, and bounds of their errors.
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

double OnSheet::Sagitta(const EdgeNode& node, const Pencil& pencil, const SheetPoint& a,
  const SheetPoint& b, const std::array<Values, 3>& at) const
{
  if (!node.regular)
  {
    return kInfinity;
  }
  // The path is the straight line in xi. Bounds the distance of its ends from the rays and from the
  // sheet.
  Numbers miss;
  double off = std::max(a.off, b.off);
  double f = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const SheetPoint& end = i == 0 ? a : b;
    const Vec3 y = Of.InUnits(end.x);
    const Vec3 rounding = Of.RoundingInUnits(end.x);
    for (int c = 0; c < 3; ++c)
    {
      const auto axis = static_cast<std::size_t>(c);
      miss[axis] = std::max(miss[axis],
        std::fabs(y[c] - at[i].y[c]) + Of.Uncertainty()[axis] + off / Of.Size() + rounding[c]);
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
      roundings += std::fabs(at[0].gradient[static_cast<int>(k)]) * size * Of.Uncertainty()[axis];
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
  // Distances at the middle from the straight line, as evaluated, and from the lines to the middle.
  const Vec3 sag = pencil.inverse * (at[2].y - 0.5 * (at[0].y + at[1].y));
  rise += std::fabs(glm::dot(at[0].gradient, sag) - at[2].f + 0.5 * (at[0].f + at[1].f)) +
    2.0 * roundings + BendAlong(node, pencil, at[0], d, bent) / 32.0 + tube->rise;
  return (rise / pencil.across * Of.Size() + off) * (1.0 + kSteep);
}
} // namespace pixelexact
