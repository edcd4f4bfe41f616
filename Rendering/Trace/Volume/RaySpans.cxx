// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Volume/RaySpans.h"

#include "Core/Element/Kernels.h"
#include "Core/Math/Rounding.h"
#include "Trace/Volume/InsideSearch.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace pixelexact
{
namespace
{
/// Numbers of points that interpolants have.
constexpr std::array<int, 14> kPointCounts{ 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 21,
  kMaxRayPoints };
/// The number of points in a leaf without a proof.
constexpr int kSampledPoints = 18;
} // namespace

void RaySpans::Find(std::span<const VolumeRay> rays, double part, double tau)
{
  rays_ = rays;
  part_ = part;
  tau_ = tau;
  found_.clear();
  rayOf_.clear();
  series_.clear();
  lost_.assign(rays.size(), 0);
  const ElementIndex& index = leaves_.Index();
  std::map<int, std::vector<int>> raysOf;
  std::vector<int> elements;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const VolumeRay& ray = rays[i];
    if (ray.isDone || !(ray.tNear < ray.tFar))
    {
      continue;
    }
    const auto segment =
      ClipRay(index.Bounds(), ray.ray.origin, ray.ray.direction, ray.tNear, ray.tFar);
    if (!segment)
    {
      continue;
    }
    elements.clear();
    index.FindAlong(*segment, elements);
    for (const int element : elements)
    {
      raysOf[element].push_back(static_cast<int>(i));
    }
  }
  for (const auto& [element, some] : raysOf)
  {
    FindNearParts(element, some);
    for (const VolumeLeaf& leaf : leaves_.Of(element))
    {
      Gather(element, leaf);
      if (!passages_.empty())
      {
        Evaluate(element, leaf);
      }
    }
  }
  std::vector<std::size_t> order(found_.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order,
    [this](std::size_t a, std::size_t b)
    {
      return std::tie(rayOf_[a], found_[a].from, found_[a].to, a) <
        std::tie(rayOf_[b], found_[b].from, found_[b].to, b);
    });
  spans_.clear();
  spans_.reserve(order.size());
  first_.assign(rays.size() + 1, 0);
  for (const std::size_t k : order)
  {
    spans_.push_back(found_[k]);
    ++first_[static_cast<std::size_t>(rayOf_[k]) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

void RaySpans::FindNearParts(int element, std::span<const int> rays)
{
  near_.clear();
  const Box3& box = leaves_.Index().ElementBox(element);
  for (const int i : rays)
  {
    const VolumeRay& ray = rays_[static_cast<std::size_t>(i)];
    const auto inBox = ClipRay(box, ray.ray.origin, ray.ray.direction, ray.tNear, ray.tFar);
    if (!inBox)
    {
      continue;
    }
    const double tNear = glm::dot(inBox->from - ray.ray.origin, ray.ray.direction);
    const double tFar = glm::dot(inBox->to - ray.ray.origin, ray.ray.direction);
    // More than rounding.
    const double more = 1e-9 * (tFar - tNear) + 1e-14 * std::fabs(tFar);
    const NearPart part{ i, std::max(ray.tNear, tNear - more), std::min(ray.tFar, tFar + more) };
    if (part.tNear < part.tFar)
    {
      near_.push_back(part);
    }
  }
}

void RaySpans::Gather(int element, const VolumeLeaf& leaf)
{
  passages_.clear();
  const Mesh& mesh = leaves_.Index().GetMesh();
  const auto e = static_cast<std::size_t>(element);
  const Vec3 centre(mesh.centre[3 * e], mesh.centre[3 * e + 1], mesh.centre[3 * e + 2]);
  const double scale = 1.0 / mesh.size[e];
  const XiInverse& inverse = leaf.inverse;
  const Vec3 origin(inverse.origin[0], inverse.origin[1], inverse.origin[2]);
  // Where the frame is of no use, whole elements are sampled.
  const double norm = inverse.Norm() * scale * Gamma(8);
  const bool isFramed = std::isfinite(inverse.deviation.x + inverse.slack);
  for (const auto& [i, tNear, tFar] : near_)
  {
    const VolumeRay& ray = rays_[static_cast<std::size_t>(i)];
    const double length = tFar - tNear;
    // z = z0 + t dz, about the middle of the passage so far.
    const double t0 = 0.5 * (tNear + tFar);
    const Vec3 x0 = ray.ray.origin + t0 * ray.ray.direction;
    const Vec3 z0 = inverse.Apply((x0 - centre) * scale - origin);
    const Vec3 dz = inverse.Apply(ray.ray.direction * scale);
    double from = tNear - t0;
    double to = tFar - t0;
    if (isFramed)
    {
      const double rounding =
        norm * (glm::length(ray.ray.origin) + glm::length(centre) + std::fabs(t0) + length);
      for (const LeafSide& side : leaf.sides)
      {
        const Vec3 size = glm::abs(side.slope);
        const double more = glm::dot(size, inverse.deviation) +
          (size.x + size.y + size.z) * (inverse.slack + rounding) + 1e-12;
        const double at = side.constant + glm::dot(side.slope, z0) + more;
        const double slope = glm::dot(side.slope, dz);
        if (slope > 0.0)
        {
          from = std::max(from, -at / slope);
        }
        else if (slope < 0.0)
        {
          to = std::min(to, -at / slope);
        }
        else if (at < 0.0)
        {
          to = from - 1.0;
        }
        if (!(to > from))
        {
          break;
        }
      }
    }
    if (!(to > from))
    {
      continue;
    }
    // More than the rounding of the ends.
    const double more = 1e-9 * (to - from);
    from = std::max(from - more, ray.tNear - t0);
    to = std::min(to + more, ray.tFar - t0);
    Passage passage{ i, t0 + 0.5 * (from + to), 0.5 * (to - from), z0 + 0.5 * (from + to) * dz,
      0.5 * (to - from) * dz, kSampledPoints, kInfinity, kInfinity };
    if (inverse.IsProven())
    {
      const double place =
        leaves_.GetTolerances().place * part_ / std::max(1.0, 2.0 * tau_ * passage.half);
      const double value = leaves_.GetTolerances().value * part_;
      const RayEllipses ellipses(inverse, passage.z, passage.dz);
      int needed = ellipses.PointsFor(kDiscRadii, place);
      for (const DiscBounds& bounds : leaf.fieldBounds)
      {
        needed = std::max(needed, ellipses.PointsFor(bounds, value));
      }
      passage.points = *std::ranges::find_if(kPointCounts, [needed](int n) { return n >= needed; });
      passage.placeError = ellipses.Error(kDiscRadii, passage.points);
      passage.valueError = 0.0;
      for (const DiscBounds& bounds : leaf.fieldBounds)
      {
        passage.valueError = std::max(passage.valueError, ellipses.Error(bounds, passage.points));
      }
    }
    passages_.push_back(passage);
  }
}

void RaySpans::Evaluate(int element, const VolumeLeaf& leaf)
{
  const Mesh& mesh = leaves_.Index().GetMesh();
  const auto e = static_cast<std::size_t>(element);
  int count = 0;
  for (const Passage& passage : passages_)
  {
    count += passage.points;
  }
  const auto stride = static_cast<std::size_t>(PaddedCount(count));
  const auto components = static_cast<std::size_t>(leaves_.Components());
  // x, starts, xi, Phi, status, margin, residual, values
  lanes_.assign(stride * (15 + components), 0.0);
  double* const data = lanes_.data();
  const auto row = [&](std::size_t k) { return data + k * stride; };
  std::size_t at = 0;
  for (const Passage& passage : passages_)
  {
    const VolumeRay& ray = rays_[static_cast<std::size_t>(passage.ray)];
    const double* nodes = RayCosines(passage.points).data() + passage.points;
    for (int i = 0; i < passage.points; ++i, ++at)
    {
      const double node = nodes[i];
      const Vec3 x = ray.ray.origin + (passage.middle + passage.half * node) * ray.ray.direction;
      const Vec3 s = glm::clamp(passage.z + node * passage.dz, Vec3(-1.5), Vec3(1.5));
      const Vec3 xi = leaf.inverse.centre + leaf.inverse.halfWidth * s;
      for (int d = 0; d < 3; ++d)
      {
        row(static_cast<std::size_t>(d))[at] = x[d];
        row(3 + static_cast<std::size_t>(d))[at] = std::isfinite(xi[d]) ? xi[d] : 0.0;
      }
    }
  }
  for (; at < stride; ++at)
  {
    for (std::size_t k = 0; k < 6; ++k)
    {
      row(k)[at] = row(k)[at - 1];
    }
  }
  InverseProblem problem = MakeInverseProblem(mesh, element, leaves_.Index().BoundsOf(element));
  problem.from = { row(3), row(4), row(5) };
  const LanePoints x{ { row(0), row(1), row(2) }, count };
  KernelsFor(problem.space)
    .invert(problem, x, { { row(6), row(7), row(8) }, row(12), row(13), row(14) });
  const LanePoints xi{ { row(6), row(7), row(8) }, count };
  std::array<double*, 3> phi{ row(9), row(10), row(11) };
  KernelsFor(problem.space).value(problem.space, mesh.map.Coefficients(element), 3, xi, phi.data());
  std::vector<double*> values(components);
  for (std::size_t c = 0; c < components; ++c)
  {
    values[c] = row(15 + c);
  }
  const Space& space = leaves_.FieldSpace(element);
  KernelsFor(space).value(
    space, leaves_.FieldCoefficients(element), leaves_.Components(), xi, values.data());
  // z - A^-1 (Phi(xi) - a_0) takes the place of Phi.
  const Vec3 centre(mesh.centre[3 * e], mesh.centre[3 * e + 1], mesh.centre[3 * e + 2]);
  const double scale = 1.0 / mesh.size[e];
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
  {
    const Vec3 y = (Vec3(row(0)[k], row(1)[k], row(2)[k]) - centre) * scale;
    const Vec3 miss = leaf.inverse.Apply(Vec3(phi[0][k], phi[1][k], phi[2][k]) - y);
    for (int d = 0; d < 3; ++d)
    {
      phi[static_cast<std::size_t>(d)][k] = miss[d];
      double& place = row(6 + static_cast<std::size_t>(d))[k];
      place = (place - leaf.inverse.centre[d]) / leaf.inverse.halfWidth[d];
    }
  }
  at = 0;
  for (const Passage& passage : passages_)
  {
    Interpolate(element, leaf, passage, at, stride);
    at += static_cast<std::size_t>(passage.points);
  }
}

void RaySpans::Interpolate(
  int element, const VolumeLeaf& leaf, const Passage& passage, std::size_t at, std::size_t stride)
{
  const double* const data = lanes_.data() + at;
  const auto row = [&](std::size_t k) { return data + k * stride; };
  const auto n = static_cast<std::size_t>(passage.points);
  Vec3 reach(0.0);
  double miss = 0.0;
  double allS = 0.0;
  bool converged = true;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      const int axis = static_cast<int>(d);
      reach[axis] = std::max(reach[axis], std::fabs(row(6 + d)[i]));
      miss = std::max(miss, std::fabs(row(9 + d)[i]));
      allS += row(6 + d)[i];
    }
    converged = converged && row(12)[i] != static_cast<double>(NewtonStatus::NotConverged);
  }
  converged = converged && std::isfinite(allS) && miss < 1e-3;
  const auto components = static_cast<std::size_t>(leaves_.Components());
  double largest = 0.0;
  for (std::size_t c = 0; c < components; ++c)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const double value = std::fabs(row(15 + c)[i]);
      largest = value >= largest || std::isnan(value) ? value : largest;
    }
  }
  if (!converged || !std::isfinite(largest))
  {
    lost_[static_cast<std::size_t>(passage.ray)] = 1;
    return;
  }

  const Mesh& mesh = leaves_.Index().GetMesh();
  const auto e = static_cast<std::size_t>(element);
  const VolumeRay& ray = rays_[static_cast<std::size_t>(passage.ray)];
  const XiInverse& inverse = leaf.inverse;
  // How far z may be off in a point: rounding of x and y, the kernel's miss, series and kernels.
  const double far = glm::length(ray.ray.origin) + std::fabs(passage.middle) + passage.half +
    std::fabs(mesh.centre[3 * e]) + std::fabs(mesh.centre[3 * e + 1]) +
    std::fabs(mesh.centre[3 * e + 2]);
  const double growth = GrowthOutside(inverse.degree, reach);
  const double off =
    (miss + inverse.slack * growth + inverse.Norm() * Gamma(12) * far / mesh.size[e]) * kInsideUp;
  double r = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    r = std::max(r, std::fabs(passage.z[d]) + std::fabs(passage.dz[d]));
  }
  const XiInverse::Slope slope = inverse.SlopeAt(r * kInsideUp, off);
  const bool isKnown = slope.disc >= 0;
  const auto disc = static_cast<std::size_t>(isKnown ? slope.disc : 0);
  // The points must be the roots that the proof is about.
  const double farthest = std::max({ reach.x, reach.y, reach.z });
  const bool isSame = isKnown && farthest <= kDiscRadii[disc];
  const double placeOff = slope.factor * off;
  const double lebesgue = ChebyshevLebesgue(passage.points);
  const double placeError = isSame
    ? (passage.placeError + lebesgue * placeOff + Gamma(4 * passage.points) * 64.0) * kInsideUp
    : kInfinity;
  RaySpan whole{ element, 0.0, 0.0, 0.0, 0.0, passage.middle, passage.half, passage.points,
    series_.size(), passage.valueError, isSame && std::isfinite(passage.valueError) };
  series_.resize(series_.size() + components * n);
  const std::array<int, 3> degree{ leaves_.FieldSpace(element).order[0],
    leaves_.FieldSpace(element).order[1], leaves_.FieldSpace(element).order[2] };
  const double fieldGrowth = GrowthOutside(degree, reach);
  double valueOff = 0.0;
  for (std::size_t c = 0; c < components; ++c)
  {
    ToCoefficients(row(15 + c), passage.points, &series_[whole.series + c * n]);
    // Cauchy's estimate from the points to the polydiscs around them.
    double slopeOfField = kInfinity;
    for (std::size_t k = 0; k < kDiscRadii.size(); ++k)
    {
      const double room = kDiscRadii[k] - farthest;
      slopeOfField =
        room > 0.0 ? std::min(slopeOfField, leaf.fieldBounds[c][k] / room) : slopeOfField;
    }
    const double bySlope = isSame ? slopeOfField * placeOff : kInfinity;
    valueOff = std::max(valueOff, bySlope + leaf.fieldNoise[c] * fieldGrowth);
  }
  whole.error =
    (passage.valueError + lebesgue * valueOff + Gamma(4 * passage.points) * 64.0 * largest) *
    kInsideUp;
  whole.isProven = whole.isProven && std::isfinite(whole.error) && std::isfinite(placeError);

  std::array<std::array<double, kMaxRayPoints>, 3> place{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    ToCoefficients(row(6 + d), passage.points, place[d].data());
  }
  AddSpans(leaf, whole, passage.ray, place, whole.isProven ? placeError : 1e-9);
}

void RaySpans::AddSpans(const VolumeLeaf& leaf, const RaySpan& whole, int ray,
  const std::array<std::array<double, kMaxRayPoints>, 3>& place, double placeError)
{
  const auto count = static_cast<std::size_t>(whole.points);
  std::vector<SideSeries> sides(leaf.sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    const LeafSide& side = leaf.sides[k];
    SideSeries& along = sides[k];
    along.count = count;
    double size = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
    {
      const double slope = side.slope[static_cast<int>(d)];
      size += std::fabs(slope);
      for (std::size_t i = 0; i < count && slope != 0.0; ++i)
      {
        along.values[i] += slope * place[d][i];
      }
    }
    along.values[0] += side.constant;
    along.error = size * placeError * kInsideUp + 1e-15;
  }
  std::vector<Inside> parts;
  FindInside(sides, parts);
  if (parts.empty() && !whole.isProven)
  {
    // That the ray misses the leaf is not proven.
    lost_[static_cast<std::size_t>(ray)] = 1;
  }
  for (const Inside& part : parts)
  {
    RaySpan span = whole;
    span.from = whole.middle + whole.half * part.from;
    span.to = whole.middle + whole.half * part.to;
    span.fromError = whole.half * part.fromError * kInsideUp;
    span.toError = whole.half * part.toError * kInsideUp;
    found_.push_back(span);
    rayOf_.push_back(ray);
  }
}
} // namespace pixelexact
