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
constexpr int kMostSteps = 200;

/// A change of sign, in s: 0 and 1 are the ends of a ray's segment.
struct Bracket
{
  int ray;
  double a, fa; ///< the latest point
  double b, fb; ///< across the change from it
  double c, fc; ///< the one before
  double share = 0.5;
  bool done = false;

  /// Takes the value at Next().
  void Narrow(double f, double tolerance)
  {
    const double s = Next();
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
    // Where inverse quadratic interpolation is safe.
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
};

struct SearchScratch
{
  std::vector<std::optional<Segment>> segments;
  std::vector<Vec3> points;
  std::vector<double> values;
  std::vector<Bracket> brackets;
  std::vector<int> slots; ///< used, per ray
};

Vec3 At(const Segment& segment, double s)
{
  return segment.from + s * (segment.to - segment.from);
}

Bracket BetweenSamples(int ray, double a, double fa, double b, double fb)
{
  Bracket bracket{ ray, b, fb, a, fa, a, fa };
  if (fa == 0.0 || fb == 0.0)
  {
    bracket.done = true;
  }
  return bracket;
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
  const CheckedOut<SearchScratch> scratch;
  auto& [segments, points, values, brackets, slots] = *scratch;
  segments.clear();
  points.clear();
  brackets.clear();
  slots.assign(static_cast<std::size_t>(rays.count), 0);
  const auto vector = [](const double* const lanes[3], int i)
  { return Vec3(lanes[0][i], lanes[1][i], lanes[2][i]); };
  const double last = Samples - 1.0;
  for (int i = 0; i < rays.count; ++i)
  {
    segments.push_back(
      ClipRay(Box, vector(rays.origin, i), vector(rays.direction, i), rays.tNear[i], rays.tFar[i]));
    for (int k = 0; segments.back() && k < Samples; ++k)
    {
      points.push_back(At(*segments.back(), k / last));
    }
  }
  values.resize(points.size());
  F->Evaluate(points, values);
  const double* value = values.data();
  for (int i = 0; i < rays.count; ++i)
  {
    if (!segments[static_cast<std::size_t>(i)])
    {
      continue;
    }
    for (int k = 1; k < Samples; ++k)
    {
      const double fa = value[k - 1];
      const double fb = value[k];
      // A zero belongs to the interval that ends there, or begins the first one.
      const bool zero = fb == 0.0 || (k == 1 && fa == 0.0);
      if (std::isfinite(fa) && std::isfinite(fb) &&
        (zero || (fa < 0.0 && fb > 0.0) || (fa > 0.0 && fb < 0.0)))
      {
        brackets.push_back(BetweenSamples(i, (k - 1) / last, fa, k / last, fb));
      }
    }
    value += Samples;
  }

  const double tolerance = 4.0 * kUnitRoundoff;
  for (int step = 0; step < kMostSteps; ++step)
  {
    points.clear();
    for (const Bracket& bracket : brackets)
    {
      if (!bracket.done)
      {
        points.push_back(At(*segments[static_cast<std::size_t>(bracket.ray)], bracket.Next()));
      }
    }
    if (points.empty())
    {
      break;
    }
    values.resize(points.size());
    F->Evaluate(points, values);
    value = values.data();
    for (Bracket& bracket : brackets)
    {
      if (!bracket.done)
      {
        bracket.Narrow(*value++, tolerance);
      }
    }
  }

  for (const Bracket& bracket : brackets)
  {
    const int i = bracket.ray;
    const Vec3 x = At(*segments[static_cast<std::size_t>(i)], bracket.Best());
    const Vec3 direction = vector(rays.direction, i);
    const double t =
      glm::dot(x - vector(rays.origin, i), direction) / glm::dot(direction, direction);
    if (!(t >= rays.tNear[i] && t <= rays.tFar[i]))
    {
      continue;
    }
    const int k = slots[static_cast<std::size_t>(i)]++;
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
