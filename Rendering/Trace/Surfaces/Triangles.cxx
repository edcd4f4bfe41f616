// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Triangles.h"

#include "Core/Base/CheckedOut.h"
#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/Curved/BundleKernels.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"
#include "Trace/Surfaces/SurfaceKernels.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// p.x q.y - p.y q.x, twice the area of the triangle with the origin. Its sign is exact, it is 0
/// only if the exact value is, and exchanging p and q negates it to the bit.
double Across(const std::array<double, 2>& p, const std::array<double, 2>& q)
{
  const double a = p[0] * q[1];
  const double b = p[1] * q[0];
  // Exact if the products are close; otherwise their rounding errors do not matter.
  return (a - b) + (std::fma(p[0], q[1], -a) - std::fma(p[1], q[0], -b));
}

/// The relative error is some roundings times the longest edge over the height on it.
Vec3 NormalOf(const Triangles::Triangle& triangle)
{
  const double size =
    std::max(LargestOf(triangle[1] - triangle[0]), LargestOf(triangle[2] - triangle[0]));
  const Vec3 p = (triangle[1] - triangle[0]) / size;
  const Vec3 q = (triangle[2] - triangle[0]) / size;
  const Vec3 across(Across({ p.y, p.z }, { q.y, q.z }), Across({ p.z, p.x }, { q.z, q.x }),
    Across({ p.x, p.y }, { q.x, q.y }));
  return across / glm::length(across);
}

/// The hit of a ray with a triangle.
struct Found
{
  std::int32_t triangle;
  int before; ///< index of another hit of the same ray; -1: none
  double t;
  Vec3 position;
  double weight[2];              ///< of the second and the third corner
  std::array<bool, 3> hasCorner; ///< the corner's weight is not zero
};

bool Before(const Vec3& a, const Vec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// The corner, edge or triangle that a hit lies on: its corners, sorted.
struct Feature
{
  int corners = 0; ///< 3: the hit is inside the triangle
  std::array<Vec3, 3> at{};

  Feature(const Triangles::Triangle& triangle, const Found& found)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (found.hasCorner[k])
      {
        at[static_cast<std::size_t>(corners++)] = triangle[k];
      }
    }
    if (corners == 2 && Before(at[1], at[0]))
    {
      std::swap(at[0], at[1]);
    }
  }
  bool operator==(const Feature& other) const
  {
    return corners == other.corners && corners < 3 && at[0] == other.at[0] &&
      (corners == 1 || at[1] == other.at[1]);
  }
};

/// The lanes of a slot of hits.
struct SlotLanes
{
  HitLanes to;
  PieceLanes piece;

  SlotLanes(HitSlots& hits, int slot)
    : to(hits.Slot(slot))
    , piece(hits.Pieces(slot))
  {
  }
  void Write(const Found& found, int ray) const
  {
    to.t[ray] = found.t;
    for (int d = 0; d < 3; ++d)
    {
      to.position[d][ray] = found.position[d];
    }
    piece.piece[ray] = found.triangle;
    piece.parameters[0][ray] = found.weight[0];
    piece.parameters[1][ray] = found.weight[1];
  }
};

/// Approximate distance of neighbouring rays at the surface; infinite for a single ray.
double SpacingOf(const RayBundle& bundle)
{
  double spacing = bundle.Count() < 2 ? std::numeric_limits<double>::infinity() : 0.0;
  for (const RayBundle::Numbers& place : bundle.place)
  {
    spacing = std::max(spacing, std::fabs(place[1] - place[0]));
  }
  return spacing;
}

/// Triangles smaller than kFine distances between rays are searched ray by ray, because a beam
/// would meet more triangles than its rays do.
constexpr double kFine = 2.0;
/// Rays of a beam: neighbours in the image.
constexpr int kBeam = 64;
} // namespace

/// Hits of a beam.
struct Triangles::Beam
{
  RayBundle bundle;
  TriangleLanes lanes;
  std::vector<Found> found;
  std::array<int, kBeam> last; ///< of each ray, in `found`; -1: none
  std::vector<const Found*> some;
  std::vector<int> near;

  void Begin()
  {
    found.clear();
    last.fill(-1);
  }
  void Add(int ray, std::int32_t triangle)
  {
    const auto i = static_cast<std::size_t>(ray);
    Found& one = found.emplace_back();
    one.triangle = triangle;
    one.before = last[i];
    one.t = lanes.t[i];
    one.weight[0] = lanes.weight[0][i];
    one.weight[1] = lanes.weight[1][i];
    for (std::size_t k = 0; k < 3; ++k)
    {
      one.position[static_cast<int>(k)] = lanes.position[k][i];
      one.hasCorner[k] = !lanes.across[k].Has(ray);
    }
    last[i] = static_cast<int>(found.size()) - 1;
  }
  /// A ray's hits in order of t. Of hits on a shared corner or edge, only the first is kept.
  std::span<const Found* const> Of(int ray, const std::vector<Triangle>& all)
  {
    some.clear();
    for (int k = last[static_cast<std::size_t>(ray)]; k >= 0; k = some.back()->before)
    {
      some.push_back(&found[static_cast<std::size_t>(k)]);
    }
    if (some.size() > 1)
    {
      std::ranges::sort(some, {}, &Found::triangle);
      std::size_t kept = 0;
      for (const Found* one : some)
      {
        const auto featureOf = [&all](const Found* of)
        { return Feature(all[static_cast<std::size_t>(of->triangle)], *of); };
        const auto end = some.begin() + static_cast<std::ptrdiff_t>(kept);
        if (std::none_of(some.begin(), end,
              [&](const Found* other) { return featureOf(other) == featureOf(one); }))
        {
          some[kept++] = one;
        }
      }
      some.resize(kept);
      std::ranges::stable_sort(some, {}, &Found::t);
    }
    return some;
  }
};

Triangles::Triangles(std::vector<Triangle> triangles)
  : All(std::move(triangles))
{
  if (All.empty())
  {
    Refuse("triangles", "there are none");
  }
  for (std::size_t i = 0; i < All.size(); ++i)
  {
    if (!std::ranges::all_of(All[i], IsFinite))
    {
      Refuse("triangles",
        ("a corner of triangle " + std::to_string(i) + " is not finite; remove it or mend it")
          .c_str());
    }
  }
  double sum = 0.0;
  bounds_ = { All[0][0], All[0][0] };
  for (const Triangle& one : All)
  {
    for (const Vec3& x : one)
    {
      bounds_ = { glm::min(bounds_.lower, x), glm::max(bounds_.upper, x) };
    }
    sum += std::max(LargestOf(one[1] - one[0]), LargestOf(one[2] - one[0]));
  }
  Extent = sum / static_cast<double>(All.size());
  NormalOfEach.reserve(All.size());
  for (const Triangle& one : All)
  {
    NormalOfEach.push_back(NormalOf(one));
  }
}

std::vector<Box3> Triangles::Boxes() const
{
  std::vector<Box3> boxes;
  boxes.reserve(All.size());
  for (const auto& [a, b, c] : All)
  {
    boxes.push_back({ glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)) });
  }
  return boxes;
}

Triangles::~Triangles() = default;

void Triangles::Meet(const RayLanes& rays, HitSlots& hits) const
{
  const CheckedOut<Beam> beam;
  for (int first = 0; first < rays.count; first += kBeam)
  {
    MeetBeam(rays, first, std::min(kBeam, rays.count - first), *beam, hits);
  }
}

void Triangles::MeetBeam(
  const RayLanes& rays, int first, int count, Beam& beam, HitSlots& hits) const
{
  beam.Begin();
  const TriangleKernels& kernels = GetTriangleKernels();
  for (unsigned ways = GetBundleKernels().ways(rays, first, count); ways != 0; ways &= ways - 1)
  {
    beam.bundle.Begin(rays, first, count, std::countr_zero(ways), bounds_);
    const RaySet all = GetPieceKernels().meetBox(beam.bundle, bounds_, RaySet::First(count));
    const auto meet = [&](int k, const RaySet& near)
    {
      const auto i = static_cast<std::size_t>(k);
      kernels.meet(beam.bundle, rays, near, All[i], NormalOfEach[i], beam.lanes)
        .ForEach([&](int ray) { beam.Add(ray, k); });
    };
    if (Extent > kFine * SpacingOf(beam.bundle))
    {
      ForBeams().ForEach(beam.bundle, [&](int k, const Box3& /*box*/) { meet(k, all); });
      continue;
    }
    all.ForEach(
      [&](int ray)
      {
        RaySet one;
        one.Add(ray);
        const int i = first + ray;
        const auto vector = [i](const double* const(&x)[3])
        { return Vec3(x[0][i], x[1][i], x[2][i]); };
        const auto segment = ClipRay(
          bounds_, vector(rays.origin), vector(rays.direction), rays.tNear[i], rays.tFar[i]);
        if (segment)
        {
          ForRays().QueryAlong(*segment, beam.near);
          for (const int k : beam.near)
          {
            meet(k, one);
          }
        }
      });
  }
  if (beam.found.empty())
  {
    return;
  }
  const SlotLanes nearest(hits, 0);
  for (int ray = 0; ray < count; ++ray)
  {
    int slot = 0;
    for (const Found* one : beam.Of(ray, All))
    {
      if (slot == 0)
      {
        nearest.Write(*one, first + ray);
      }
      else
      {
        SlotLanes(hits, slot).Write(*one, first + ray);
      }
      ++slot;
    }
  }
}

const BundleHierarchy& Triangles::ForBeams() const
{
  return Together.Get(0, [this] { return std::make_unique<const BundleHierarchy>(Boxes()); });
}

const Bvh& Triangles::ForRays() const
{
  return Single.Get(0, [this] { return std::make_unique<const Bvh>(Boxes(), bounds_); });
}

Vec3 Triangles::Normal(const SurfacePoint& point) const
{
  return NormalOfEach[static_cast<std::size_t>(point.piece)];
}

std::vector<SurfacePatch> Triangles::Implicit() const
{
  std::vector<SurfacePatch> patches;
  for (const Triangle& triangle : All)
  {
    if (auto patch = TrianglePatch(triangle))
    {
      patches.push_back(std::move(*patch));
    }
  }
  return patches;
}
} // namespace pixelexact
