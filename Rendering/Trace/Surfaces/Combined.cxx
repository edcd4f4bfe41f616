// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Combined.h"

#include "Core/Base/CheckedOut.h"
#include "Trace/Surfaces/Arguments.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
struct PartHit
{
  double t;
  Vec3 position;
  HitStatus status;
  std::int32_t part;
  std::int32_t piece; ///< of the part
};

struct CombinedScratch
{
  std::vector<HitSlots> ofParts;
  std::vector<PartHit> found;
  std::vector<bool> inside;
};

/// Largest count of parts near one chord. All orders in which they may be crossed are checked.
constexpr std::size_t kMaxCrossed = 4;

/// Converts a hit of the whole to a hit of its part.
SurfacePoint OfPart(const SurfacePoint& point)
{
  SurfacePoint ofPart = point;
  ofPart.piece = static_cast<std::int32_t>(point.parameters[0]);
  return ofPart;
}

/// No point of the surface lies within `beside` of a straight line. Tests balls along the line,
/// smaller ones where the surface is nearer.
bool IsClearAlong(
  const Surface& surface, const Vec3& from, const Vec3& to, double beside, int subdivisions = 5)
{
  const Vec3 middle = 0.5 * from + 0.5 * to;
  return surface.IsClearOf(middle, 0.5 * glm::distance(from, to) + beside) ||
    (subdivisions > 0 && IsClearAlong(surface, from, middle, beside, subdivisions - 1) &&
      IsClearAlong(surface, middle, to, beside, subdivisions - 1));
}

/// A point inside an interval of a ray that may be infinite.
double Middle(double from, double to)
{
  return to < kFarthest ? 0.5 * from + 0.5 * to : 2.0 * from + 1.0;
}
} // namespace

Combined::Combined(std::vector<Part> parts, Rule rule)
  : Parts(std::move(parts))
  , IsInside(std::move(rule))
{
  if (Parts.empty())
  {
    Refuse("combined surface", "there are no parts");
  }
}

bool Combined::MayMeet(const Outline& part, double slack, EdgeWork* work) const
{
  return std::ranges::any_of(
    Parts, [&](const Part& one) { return one.surface->MayMeet(part, slack, work); });
}

void Combined::Meet(const RayLanes& rays, HitSlots& hits) const
{
  const CheckedOut<CombinedScratch> scratch;
  std::vector<HitSlots>& ofParts = (*scratch).ofParts;
  std::vector<PartHit>& found = (*scratch).found;
  std::vector<bool>& inside = (*scratch).inside;
  ofParts.resize(Parts.size());
  for (std::size_t p = 0; p < Parts.size(); ++p)
  {
    ofParts[p].Begin(rays.count);
    Parts[p].surface->Meet(rays, ofParts[p]);
  }
  inside.resize(Parts.size());
  for (int i = 0; i < rays.count; ++i)
  {
    found.clear();
    for (std::size_t p = 0; p < Parts.size(); ++p)
    {
      const HitSlots& slots = ofParts[p];
      for (int k = 0; k < slots.Count() && slots.T(k)[i] < kNoHit; ++k)
      {
        const SurfacePoint point = slots.PointOf(k, i);
        found.push_back({ slots.T(k)[i], point.position, slots.StatusOf(k, i),
          static_cast<std::int32_t>(p), point.piece });
      }
    }
    if (found.empty())
    {
      continue;
    }
    std::ranges::stable_sort(found, {}, &PartHit::t);
    const Vec3 origin(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]);
    const Vec3 direction(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
    const auto isInside = [&](double from, double to)
    {
      const Vec3 x = origin + Middle(from, to) * direction;
      std::transform(Parts.begin(), Parts.end(), inside.begin(),
        [&x](const Part& part) { return part.side(x) < 0.0; });
      return IsInside(inside);
    };
    int k = 0;
    bool before = isInside(rays.tNear[i], found[0].t);
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      const bool last = n + 1 == found.size();
      // If several hits have the same t, only the last one counts.
      if (!last && found[n + 1].t == found[n].t)
      {
        continue;
      }
      const bool after = isInside(found[n].t, last ? rays.tFar[i] : found[n + 1].t);
      if (before != after)
      {
        const HitLanes slot = hits.Slot(k);
        const PieceLanes piece = hits.Pieces(k);
        slot.t[i] = found[n].t;
        for (int d = 0; d < 3; ++d)
        {
          slot.position[d][i] = found[n].position[d];
        }
        piece.piece[i] = found[n].part;
        piece.parameters[0][i] = found[n].piece;
        if (found[n].status != HitStatus::Certain)
        {
          hits.Status(k)[i] = found[n].status;
        }
        ++k;
      }
      before = after;
    }
  }
}

bool Combined::HasSagitta() const
{
  return std::ranges::all_of(Parts, [](const Part& part) { return part.surface->HasSagitta(); });
}

double Combined::Sagitta(
  const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const
{
  const Chord whole{ a, atA.position, b, atB.position };
  if (atA.piece >= 0 && atA.piece == atB.piece)
  {
    // No other part changes along this part's path, so the part's effect on the whole is constant.
    const auto own = static_cast<std::size_t>(atA.piece);
    const double sagitta = Parts[own].surface->Sagitta(a, OfPart(atA), b, OfPart(atB));
    bool isAlone = std::isfinite(sagitta);
    for (std::size_t p = 0; isAlone && p < Parts.size(); ++p)
    {
      isAlone =
        p == own || IsClearAlong(*Parts[p].surface, whole.from, whole.to, sagitta + whole.Slack());
    }
    if (isAlone)
    {
      return sagitta;
    }
  }
  return ReachWithRoom(whole, [this](const Chord& chord) { return ReachOfParts(chord); });
}

double Combined::ReachOfParts(const Chord& chord) const
{
  // Within `reach` of the chord, parts that are clear of it do not change. Each ray crosses each of
  // the other parts once, at a place that is continuous in the ray. If every order of crossings
  // changes the whole in one direction only, each ray meets it once. The place is that of the first
  // or of the last of some parts; minima and maxima of continuous functions are continuous.
  std::vector<bool> isNear(Parts.size(), false);
  double reach = 0.0;
  for (bool grows = true; grows;)
  {
    grows = false;
    for (std::size_t p = 0; p < Parts.size(); ++p)
    {
      const Surface& surface = *Parts[p].surface;
      if (!isNear[p] && !IsClearAlong(surface, chord.from, chord.to, reach + chord.Slack()))
      {
        isNear[p] = true;
        reach = std::max(reach, surface.Reach(chord));
        grows = true;
      }
      if (!std::isfinite(reach))
      {
        return reach;
      }
    }
  }
  return ChangesOnce(isNear, chord.Middle(), chord.Room() * chord.a.direction)
    ? reach
    : std::numeric_limits<double>::infinity();
}

bool Combined::ChangesOnce(
  const std::vector<bool>& isNear, const Vec3& middle, const Vec3& step) const
{
  std::vector<bool> inside(Parts.size());
  std::vector<std::size_t> crossed;
  std::vector<bool> after(Parts.size());
  for (std::size_t p = 0; p < Parts.size(); ++p)
  {
    inside[p] = Parts[p].side(isNear[p] ? middle - step : middle) < 0.0;
    after[p] = isNear[p] ? Parts[p].side(middle + step) < 0.0 : inside[p];
    if (isNear[p])
    {
      crossed.push_back(p);
      // The part is too close to the end of the step.
      if (inside[p] == after[p])
      {
        return false;
      }
    }
  }
  if (crossed.empty() || crossed.size() > kMaxCrossed)
  {
    return false;
  }
  // Checks each set of crossed parts, and one further part.
  const bool before = IsInside(inside);
  const bool last = IsInside(after);
  const auto isChanged = [&](std::size_t set)
  {
    std::vector<bool> state = inside;
    for (std::size_t k = 0; k < crossed.size(); ++k)
    {
      state[crossed[k]] = (set >> k & 1U) != 0 ? after[crossed[k]] : inside[crossed[k]];
    }
    return IsInside(state) != before;
  };
  const std::size_t sets = std::size_t{ 1 } << crossed.size();
  for (std::size_t set = 0; before != last && set < sets; ++set)
  {
    for (std::size_t k = 0; k < crossed.size(); ++k)
    {
      if ((set >> k & 1U) == 0 && isChanged(set) && !isChanged(set | std::size_t{ 1 } << k))
      {
        return false;
      }
    }
  }
  return before != last;
}

Vec3 Combined::Normal(const SurfacePoint& point) const
{
  return Parts[static_cast<std::size_t>(point.piece)].surface->Normal(OfPart(point));
}
} // namespace pixelexact
