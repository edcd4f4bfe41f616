// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Surfaces/Triangles.h"
#include "Trace/Tracer.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// Triangles with a value at each corner, linear in between, as linear pipelines pass them to a
/// rasteriser.
class LinearSurface
{
public:
  /// `values`: one triple per triangle. Without triangles, no ray meets the surface. Throws Error
  /// as Triangles.
  LinearSurface(
    std::vector<Triangles::Triangle> triangles, std::vector<std::array<double, 3>> values);

  /// The value where each ray first meets the surface; NaN without a hit. Parallel; each value
  /// depends on its ray alone. `corners`: samples lie at pixels' corners, (width + 1) x (height +
  /// 1), else at their centres; lower-left first. Returns an empty array if `progress` aborts.
  [[nodiscard]] std::vector<double> Trace(
    const Camera& camera, bool corners, const Progress& progress = {}) const;

  [[nodiscard]] std::size_t Count() const { return Values.size(); }

private:
  void TraceRow(const Camera& camera, int row, double offset, std::span<double> values) const;

  std::unique_ptr<const Triangles> Shapes;
  std::vector<std::array<double, 3>> Values;
};
} // namespace pixelexact
