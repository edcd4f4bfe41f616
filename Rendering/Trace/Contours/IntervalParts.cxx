// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/IntervalParts.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Element/SegmentInterval.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/MeshMiss.h"
#include "Core/Questions/ValueSet.h"
#include "Trace/Surfaces/Plane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
static_assert(kMagnitude == kNormOfAll);

/// Roundings on the way to a sample's position: of the ray, of t and of the point on it.
constexpr double kPositionRoundings = 32.0;

double LargestOf(const Vec3& x)
{
  return std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
}
} // namespace

IntervalParts::IntervalParts(
  const Scene& scene, const Camera& camera, std::span<const std::vector<double>> values)
  : scene_(scene)
  , camera_(camera)
  , Values(values)
{
  if (scene.layers.size() == 1)
  {
    plane_ = dynamic_cast<const Plane*>(scene.layers.front().surface.get());
  }
}

void IntervalParts::Classify(std::span<const EdgeSample> samples, std::span<const EdgePart> parts,
  std::vector<PartVerdict>& verdicts) const
{
  verdicts.assign(parts.size(), PartVerdict::Unproven);
  if (std::ranges::all_of(Values, [](const auto& ofLayer) { return ofLayer.empty(); }))
  {
    std::ranges::fill(verdicts, PartVerdict::Out);
    return;
  }
  if (!plane_)
  {
    return;
  }
  std::vector<int> inside;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const EdgeSample& from = samples[static_cast<std::size_t>(parts[i].from)];
    const EdgeSample& to = samples[static_cast<std::size_t>(parts[i].to)];
    const auto both = [&](PixelVerdict verdict)
    { return from.verdict == verdict && to.verdict == verdict; };
    if (!IsStraight(from, to))
    {
      continue;
    }
    if (both(PixelVerdict::Exact) && from.element == to.element)
    {
      inside.push_back(static_cast<int>(i));
    }
    else if (both(PixelVerdict::Nothing) && IsBesideMesh(from, to))
    {
      verdicts[i] = PartVerdict::Out;
    }
  }
  const auto elementOf = [&](int i)
  { return samples[static_cast<std::size_t>(parts[static_cast<std::size_t>(i)].from)].element; };
  std::ranges::stable_sort(inside, {}, elementOf);
  for (auto begin = inside.begin(); begin != inside.end();)
  {
    const auto end =
      std::find_if(begin, inside.end(), [&](int i) { return elementOf(i) != elementOf(*begin); });
    ClassifyInElement(samples, parts, { begin, end }, verdicts);
    begin = end;
  }
}

void IntervalParts::ClassifyInElement(std::span<const EdgeSample> samples,
  std::span<const EdgePart> parts, std::span<const int> chosen,
  std::vector<PartVerdict>& verdicts) const
{
  std::vector<Vec3> xiFrom;
  std::vector<Vec3> xiTo;
  std::vector<Vec3> from;
  std::vector<Vec3> to;
  std::vector<double> slack;
  for (const int i : chosen)
  {
    const EdgePart& part = parts[static_cast<std::size_t>(i)];
    const EdgeSample& first = samples[static_cast<std::size_t>(part.from)];
    const EdgeSample& last = samples[static_cast<std::size_t>(part.to)];
    xiFrom.push_back(first.xi);
    xiTo.push_back(last.xi);
    from.push_back(first.position);
    to.push_back(last.position);
    slack.push_back(std::max(SlackOf(first.position, first.at), SlackOf(last.position, last.at)));
  }
  slack.resize(static_cast<std::size_t>(PaddedCount(static_cast<int>(chosen.size()))));
  const LaneBuffer lanes[]{ LaneBuffer(xiFrom), LaneBuffer(xiTo), LaneBuffer(from),
    LaneBuffer(to) };
  std::vector<Interval> intervals(chosen.size());
  const int element =
    samples[static_cast<std::size_t>(parts[static_cast<std::size_t>(chosen.front())].from)].element;
  const Layer& layer = scene_.layers.front();
  SegmentIntervals(scene_.locator->GetMesh(), *layer.field, layer.component, element,
    { lanes[0].View(), lanes[1].View(), lanes[2].View(), lanes[3].View(), slack.data() },
    intervals);
  for (std::size_t k = 0; k < chosen.size(); ++k)
  {
    verdicts[static_cast<std::size_t>(chosen[k])] = !intervals[k].IsFinite() ? PartVerdict::Unproven
      : ValueSet{ Values.front() }.Meets(intervals[k].lower, intervals[k].upper)
      ? PartVerdict::Possible
      : PartVerdict::Out;
  }
}

/// t is a quotient of two functions that are linear along the edge. If the denominator has the same
/// sign at both ends, it has no zero between them, and all rays between meet the plane.
bool IntervalParts::IsStraight(const EdgeSample& from, const EdgeSample& to) const
{
  return Slope(from.at) * Slope(to.at) > 0.0;
}

bool IntervalParts::IsBesideMesh(const EdgeSample& from, const EdgeSample& to) const
{
  const auto hitsOf = [&](const EdgeSample& sample)
  { return HitsOf(*plane_, camera_.At(sample.at[0], sample.at[1])); };
  const auto first = hitsOf(from);
  const auto last = hitsOf(to);
  if (first.empty() || last.empty())
  {
    return first.empty() && last.empty();
  }
  Segment chord{ first.front().position, last.front().position };
  chord.slack = std::max(SlackOf(chord.from, from.at), SlackOf(chord.to, to.at));
  const bool cutAway = std::ranges::any_of(scene_.kept,
    [&](const KeptHalfSpace& half)
    {
      const Vec3 normal{ half[0], half[1], half[2] };
      const double rounding = 3.0 * LargestOf(normal) * chord.slack;
      return glm::dot(normal, chord.from) + half[3] < -rounding &&
        glm::dot(normal, chord.to) + half[3] < -rounding;
    });
  return cutAway || MissesMesh(scene_.locator->Index(), chord);
}

double IntervalParts::SlackOf(const Vec3& position, const ImagePosition& at) const
{
  const Ray ray = camera_.At(at[0], at[1]);
  // The error of t grows towards grazing rays.
  return kPositionRoundings * kUnitRoundoff *
    (LargestOf(ray.origin) + LargestOf(plane_->Through()) + LargestOf(position) +
      glm::distance(ray.origin, position)) /
    std::fabs(Slope(at));
}

double IntervalParts::Slope(const ImagePosition& at) const
{
  return glm::dot(plane_->Normal({ Vec3(0.0) }), camera_.At(at[0], at[1]).direction);
}
} // namespace pixelexact
