// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/SearchedSurface.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Index/Segment.h"
#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Arguments.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr int kMaxSteps = 200;
constexpr int kEdgeSteps = 30;
constexpr int kMaxRounds = 4; ///< of samples in gaps that the search met
constexpr double kTolerance = 4.0 * kUnitRoundoff;
constexpr double kJump = 1e-9;

/// A parameter on a ray's segment, 0 at its begin and 1 at its end, and the value there.
struct PlaceValue
{
  double s, f;
};

/// An interval between a place where f is finite and one where it is not.
struct Edge
{
  int ray;
  PlaceValue last; ///< f is finite here
  double beyond;   ///< f is not finite here

  [[nodiscard]] double Next() const { return last.s + 0.5 * (beyond - last.s); }
  void Narrow(double f)
  {
    if (std::isfinite(f))
    {
      last = { Next(), f };
    }
    else
    {
      beyond = Next();
    }
  }
};

/// An interval with a change of sign; places as in PlaceValue.
struct Bracket
{
  int ray;
  double a, fa; ///< the latest point
  double b, fb; ///< across the change from it
  double c, fc; ///< the one before
  double share = 0.5;
  bool done = false;
  bool meetsGap = false; ///< f is not finite at a

  /// Takes the value at Next().
  void Narrow(double f, double tolerance)
  {
    const double s = Next();
    if (!std::isfinite(f))
    {
      a = s;
      meetsGap = done = true;
      return;
    }
    if ((f > 0.0) == (fa > 0.0))
    {
      c = std::exchange(a, s);
      fc = std::exchange(fa, f);
    }
    else
    {
      c = std::exchange(b, a);
      fc = std::exchange(fb, fa);
      a = s;
      fa = f;
    }
    const double width = std::fabs(b - a);
    done = f == 0.0 || !(width > tolerance);
    // Inverse quadratic interpolation is safe here.
    const double x = (a - b) / (c - b);
    const double y = (fa - fb) / (fc - fb);
    const double least = 0.5 * tolerance / width;
    share = 0.5;
    if (y * y < x && (1.0 - y) * (1.0 - y) < 1.0 - x)
    {
      share = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
      share = std::clamp(share, std::min(least, 0.5), std::max(1.0 - least, 0.5));
    }
  }
  [[nodiscard]] double Next() const { return a + share * (b - a); }
  [[nodiscard]] double Best() const { return std::fabs(fa) <= std::fabs(fb) ? a : b; }
  [[nodiscard]] double Left() const { return std::min(std::fabs(fa), std::fabs(fb)); }
};

/// The largest value and slope of f at the samples of a ray.
struct Sizes
{
  double largest = 0.0;
  double steepest = 0.0; ///< per s

  void Add(const PlaceValue& before, const PlaceValue& here)
  {
    constexpr double kMinStep = 1e-6; // below it differences may be rounding
    largest = std::max({ largest, std::fabs(before.f), std::fabs(here.f) });
    if (here.s - before.s > kMinStep)
    {
      steepest = std::max(steepest, std::fabs((here.f - before.f) / (here.s - before.s)));
    }
  }
};

struct SearchScratch
{
  std::vector<std::optional<Segment>> segments;
  std::vector<std::vector<double>> places; ///< sampled places, per ray
  std::vector<Vec3> points;
  std::vector<double> values;
  std::vector<PlaceValue> samples; ///< of all rays, one after the other
  std::vector<Edge> edges;         ///< by ray and place
  std::vector<Bracket> brackets;
  std::vector<Sizes> sizes; ///< per ray
  std::vector<int> slots;   ///< count of used slots, per ray

  [[nodiscard]] Vec3 At(int ray, double s) const
  {
    const Segment& segment = *segments[static_cast<std::size_t>(ray)];
    return segment.from + s * (segment.to - segment.from);
  }
};

/// The places of one ray, ascending: evenly spaced ones and those that f requests.
void FindPlaces(
  const SampledFunction& f, const Segment& segment, int samples, std::vector<double>& places)
{
  for (int k = 0; k < samples; ++k)
  {
    places.push_back(k / (samples - 1.0));
  }
  const std::size_t even = places.size();
  f.AddPlaces(segment, places);
  if (places.size() > even)
  {
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }
}

/// Evaluates f at the next places of all searches that are not done, until all are done or after
/// `steps` steps.
template <class Searches, class IsDone, class Narrow>
void Search(const SampledFunction& f, SearchScratch& scratch, Searches& searches, int steps,
  const IsDone& isDone, const Narrow& narrow)
{
  for (int step = 0; step < steps; ++step)
  {
    scratch.points.clear();
    for (const auto& one : searches)
    {
      if (!isDone(one))
      {
        scratch.points.push_back(scratch.At(one.ray, one.Next()));
      }
    }
    if (scratch.points.empty())
    {
      return;
    }
    scratch.values.resize(scratch.points.size());
    f.Evaluate(scratch.points, scratch.values);
    const double* value = scratch.values.data();
    for (auto& one : searches)
    {
      if (!isDone(one))
      {
        narrow(one, *value++);
      }
    }
  }
}

/// Samples f along the rays.
void TakeSamples(const SampledFunction& f, SearchScratch& scratch)
{
  scratch.points.clear();
  for (std::size_t i = 0; i < scratch.places.size(); ++i)
  {
    for (const double s : scratch.places[i])
    {
      scratch.points.push_back(scratch.At(static_cast<int>(i), s));
    }
  }
  scratch.values.resize(scratch.points.size());
  f.Evaluate(scratch.points, scratch.values);
  const double* value = scratch.values.data();
  scratch.samples.clear();
  for (const auto& places : scratch.places)
  {
    for (const double s : places)
    {
      scratch.samples.push_back({ s, *value++ });
    }
  }
}

/// Finds the last points where f is finite.
void FindEdges(const SampledFunction& f, SearchScratch& scratch)
{
  scratch.edges.clear();
  const PlaceValue* sample = scratch.samples.data();
  for (std::size_t i = 0; i < scratch.places.size(); ++i)
  {
    for (std::size_t k = 1; k < scratch.places[i].size(); ++k)
    {
      const bool before = std::isfinite(sample[k - 1].f);
      if (before != std::isfinite(sample[k].f))
      {
        scratch.edges.push_back(
          { static_cast<int>(i), sample[before ? k - 1 : k], sample[before ? k : k - 1].s });
      }
    }
    sample += scratch.places[i].size();
  }
  Search(
    f, scratch, scratch.edges, kEdgeSteps, [](const Edge&) { return false; },
    [](Edge& edge, double value) { edge.Narrow(value); });
}

/// Collects the changes of sign and the sizes on one ray, from consecutive places where f is
/// finite.
class SignChanges
{
public:
  SignChanges(int ray, std::vector<Bracket>& found, Sizes& sizes)
    : Ray(ray)
    , Found(found)
    , SizesOfRay(sizes)
  {
  }

  void Add(const PlaceValue& here)
  {
    if (Places > 0 && here.s == Before.s)
    {
      return;
    }
    if (Places > 0)
    {
      SizesOfRay.Add(Before, here);
    }
    // A zero belongs to the interval that ends at it, or else begins the first interval.
    const bool zero = here.f == 0.0 || (Places == 1 && Before.f == 0.0);
    const bool crossed = (Before.f < 0.0 && here.f > 0.0) || (Before.f > 0.0 && here.f < 0.0);
    if (Places > 0 && (zero || crossed))
    {
      Found.push_back({ Ray, here.s, here.f, Before.s, Before.f, here.s, here.f, 0.5, zero });
    }
    Before = here;
    ++Places;
  }
  /// f is not finite after the latest place.
  void End() { Places = 0; }

private:
  int Ray;
  std::vector<Bracket>& Found;
  Sizes& SizesOfRay;
  PlaceValue Before{};
  int Places = 0;
};

void FindBrackets(SearchScratch& scratch)
{
  scratch.brackets.clear();
  scratch.sizes.assign(scratch.places.size(), {});
  const PlaceValue* sample = scratch.samples.data();
  auto edge = scratch.edges.begin();
  for (std::size_t i = 0; i < scratch.places.size(); ++i)
  {
    SignChanges changes(static_cast<int>(i), scratch.brackets, scratch.sizes[i]);
    for (std::size_t k = 0; k < scratch.places[i].size(); ++k, ++sample)
    {
      const bool inside = std::isfinite(sample->f);
      if (k > 0 && inside != std::isfinite(sample[-1].f))
      {
        changes.Add(edge++->last);
      }
      if (inside)
      {
        changes.Add(*sample);
      }
      else
      {
        changes.End();
      }
    }
  }
}
/// Adds the places where brackets met gaps as samples. Returns false if there are none.
bool SampleGaps(SearchScratch& scratch)
{
  bool any = false;
  for (const Bracket& bracket : scratch.brackets)
  {
    if (bracket.meetsGap)
    {
      auto& places = scratch.places[static_cast<std::size_t>(bracket.ray)];
      places.insert(std::ranges::upper_bound(places, bracket.a), bracket.a);
      any = true;
    }
  }
  return any;
}

/// The value of f where the search ended exceeds what rounding explains.
bool IsJump(const Bracket& bracket, const SearchScratch& scratch)
{
  const auto ray = static_cast<std::size_t>(bracket.ray);
  const Segment& segment = *scratch.segments[ray];
  const Vec3 far = glm::max(glm::abs(segment.from), glm::abs(segment.to));
  const double length = glm::distance(segment.from, segment.to);
  const double rounding = 64.0 * kUnitRoundoff * (1.0 + std::max({ far.x, far.y, far.z }) / length);
  const Sizes& sizes = scratch.sizes[ray];
  return bracket.Left() > std::max(kJump * sizes.largest, rounding * sizes.steepest);
}
} // namespace

SearchedSurface::SearchedSurface(
  std::shared_ptr<const SampledFunction> f, const Box3& box, int samples)
  : F(std::move(f))
  , Box(box)
  , Samples(samples)
{
  if (!F)
  {
    Refuse("searched surface", "there is no function");
  }
  const bool sound = IsFinite(box.lower) && IsFinite(box.upper) && box.lower.x <= box.upper.x &&
    box.lower.y <= box.upper.y && box.lower.z <= box.upper.z;
  if (!sound)
  {
    Refuse("searched surface", "the box to search in is empty or not finite");
  }
  if (samples < 2)
  {
    Refuse("searched surface", "a ray needs at least 2 samples");
  }
}

void SearchedSurface::Meet(const RayLanes& rays, HitSlots& hits) const
{
  const CheckedOut<SearchScratch> borrowed;
  SearchScratch& scratch = *borrowed;
  scratch.segments.clear();
  scratch.places.resize(static_cast<std::size_t>(rays.count));
  scratch.slots.assign(static_cast<std::size_t>(rays.count), 0);
  const auto vector = [](const double* const lanes[3], int i)
  { return Vec3(lanes[0][i], lanes[1][i], lanes[2][i]); };
  for (int i = 0; i < rays.count; ++i)
  {
    scratch.segments.push_back(
      ClipRay(Box, vector(rays.origin, i), vector(rays.direction, i), rays.tNear[i], rays.tFar[i]));
    auto& places = scratch.places[static_cast<std::size_t>(i)];
    places.clear();
    if (scratch.segments.back())
    {
      FindPlaces(*F, *scratch.segments.back(), Samples, places);
    }
  }
  for (int round = 0; round == 0 || (round < kMaxRounds && SampleGaps(scratch)); ++round)
  {
    TakeSamples(*F, scratch);
    FindEdges(*F, scratch);
    FindBrackets(scratch);
    Search(
      *F, scratch, scratch.brackets, kMaxSteps, [](const Bracket& bracket) { return bracket.done; },
      [](Bracket& bracket, double f) { bracket.Narrow(f, kTolerance); });
  }

  for (const Bracket& bracket : scratch.brackets)
  {
    const int i = bracket.ray;
    if (bracket.meetsGap || (!F->JumpsAreHits() && IsJump(bracket, scratch)))
    {
      continue;
    }
    const Vec3 x = scratch.At(i, bracket.Best());
    const Vec3 direction = vector(rays.direction, i);
    const double t =
      glm::dot(x - vector(rays.origin, i), direction) / glm::dot(direction, direction);
    if (!(t >= rays.tNear[i] && t <= rays.tFar[i]))
    {
      continue;
    }
    const int k = scratch.slots[static_cast<std::size_t>(i)]++;
    const HitLanes slot = hits.Slot(k);
    slot.t[i] = t;
    for (int d = 0; d < 3; ++d)
    {
      slot.position[d][i] = x[d];
    }
    hits.Status(k)[i] = HitStatus::Numeric;
  }
}

Vec3 SearchedSurface::Normal(const SurfacePoint& point) const
{
  Vec3 normal;
  Normals({ &point, 1 }, { &normal, 1 });
  return normal;
}

void SearchedSurface::Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const
{
  const CheckedOut<SearchScratch> scratch;
  std::vector<Vec3>& positions = (*scratch).points;
  positions.clear();
  for (const SurfacePoint& point : points)
  {
    positions.push_back(point.position);
  }
  F->Gradients(positions, normals);
  for (Vec3& normal : normals)
  {
    normal = UnitOrZero(normal);
  }
}
} // namespace pixelexact
