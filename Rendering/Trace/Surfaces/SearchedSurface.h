// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Index/Segment.h"
#include "Trace/Surfaces/Surface.h"

#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// A function f of position that is known only by its values. Called from several threads at once,
/// except as Surface::NeedsCallingThread states. May throw.
class SampledFunction
{
public:
  virtual ~SampledFunction() = default;
  virtual void Evaluate(std::span<const Vec3> x, std::span<double> values) const = 0;
  /// Gradients of any length. Where one is zero or not finite, the surface has no normal.
  virtual void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const = 0;
  [[nodiscard]] virtual bool NeedsCallingThread() const { return false; }
  /// The surface includes the points where f jumps from one sign to the other.
  [[nodiscard]] virtual bool JumpsAreHits() const { return true; }
  /// Appends parameters on a segment at which f must be sampled, from 0 (begin) to 1 (end).
  virtual void AddPlaces(const Segment& /*segment*/, std::vector<double>& /*places*/) const {}
};

/// The points where f changes its sign, found by a search along each ray's part in a box. f is
/// sampled at evenly spaced points and at the places that f requests. Between two samples of
/// different sign, the change is found to 4 roundings of the box's size, or where f is 0 (T. R.
/// Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear
/// function without using derivatives, Advances in Engineering Software 28, 1997). Where f is not
/// finite there is no surface. Between a finite sample and one that is not, the last finite point
/// counts as a sample (found to 1e-9 of their distance).
///
/// Every hit is Numeric. Pairs of sheets closer to each other than the samples may be missed. So
/// may a surface that f touches without changing its sign, unless a sample is exactly 0. A jump is
/// distinguished from a steep slope by the value of f where the search ends. It exceeds 1e-9 of the
/// ray's largest sample, and the change over 64 roundings of the place at the steepest slope
/// between the ray's samples.
class SearchedSurface final : public Surface
{
public:
  static constexpr int kDefaultSamples = 128;

  /// Throws Error for a box that is empty or not finite, and for fewer than 2 samples.
  SearchedSurface(
    std::shared_ptr<const SampledFunction> f, const Box3& box, int samples = kDefaultSamples);

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  /// Along the gradient; zero if there is none.
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;
  void Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const override;
  [[nodiscard]] bool NeedsCallingThread() const override { return F->NeedsCallingThread(); }

private:
  std::shared_ptr<const SampledFunction> F;
  Box3 Box;
  int Samples;
};
} // namespace pixelexact
