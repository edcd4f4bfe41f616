// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Index/Segment.h"
#include "Trace/Surfaces/Surface.h"

#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// A function f of position of which nothing is known but its values. Called from several threads
/// at once, but see Surface::NeedsCallingThread. May throw.
class SampledFunction
{
public:
  virtual ~SampledFunction() = default;
  virtual void Evaluate(std::span<const Vec3> x, std::span<double> values) const = 0;
  /// Of any length; where it is zero or not finite the surface has no normal.
  virtual void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const = 0;
  [[nodiscard]] virtual bool NeedsCallingThread() const { return false; }
  /// Whether the surface is also where f jumps from one sign to the other.
  [[nodiscard]] virtual bool JumpsAreHits() const { return true; }
  /// Appends places on a segment at which f has to be sampled: 0 is its begin, 1 its end.
  virtual void AddPlaces(const Segment& /*segment*/, std::vector<double>& /*places*/) const {}
};

/// Where f changes its sign, found by a search: f is sampled at points that lie evenly on the part
/// of the ray in a box and where f asks for it, and between two samples of different sign a change
/// is found up to 4 roundings of the box's size, or where f is 0 (T. R. Chandrupatla, A new hybrid
/// quadratic/bisection algorithm for finding the zero of a nonlinear function without using
/// derivatives, Advances in Engineering Software 28, 1997). Where f is not finite there is no
/// surface; between a sample where it is and one where it is not, the last point where it is counts
/// as a sample (found up to 1e-9 of their distance). So every hit is Numeric: sheets closer to each
/// other than the samples may be overlooked in pairs, and so is a surface that f touches without
/// changing its sign, but where a sample is exactly 0. Jumps are told from steep slopes by what is
/// left of f where the search ends: more than 1e-9 of the ray's largest sample, and more than 64
/// roundings of the place explain by the steepest slope between its samples.
class SearchedSurface final : public Surface
{
public:
  static constexpr int kDefaultSamples = 128;

  /// Throws Error for a box that is empty or not finite, and for fewer than 2 samples.
  SearchedSurface(
    std::shared_ptr<const SampledFunction> f, const Box3& box, int samples = kDefaultSamples);

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  /// Along the gradient; zero where there is none.
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;
  void Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const override;
  [[nodiscard]] bool NeedsCallingThread() const override { return F->NeedsCallingThread(); }

private:
  std::shared_ptr<const SampledFunction> F;
  Box3 Box;
  int Samples;
};
} // namespace pixelexact
