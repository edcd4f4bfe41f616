// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Locator.h"
#include "Trace/Surfaces/SearchedSurface.h"

namespace pixelexact
{
/// A component of a field minus a value, at points of the mesh; NaN elsewhere. For fields without
/// polynomial form, whose iso-surface is a SearchedSurface.
class FieldSamples final : public SampledFunction
{
public:
  /// `component`: of the field, or kMagnitude. Locator and field must outlive the object. Throws
  /// Unsupported if the field has no gradient.
  FieldSamples(const Locator& locator, const Field& field, int component, double value);

  void Evaluate(std::span<const Vec3> x, std::span<double> values) const override;
  void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override;

  /// Where a field jumps between elements, it does not take the values between.
  [[nodiscard]] bool JumpsAreHits() const override { return false; }
  /// Adds evenly spaced places in the box of each element that the segment meets.
  void AddPlaces(const Segment& segment, std::vector<double>& places) const override;

private:
  const Locator& MeshLocator;
  const Field& SampledField;
  int Component;
  double Value;
};
} // namespace pixelexact
