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
/// Triangles with a value at each corner, and linear in between: what linear pipelines hand to a
/// rasteriser.
class LinearSurface
{
public:
  /// As many triples of values as triangles; none at all is a surface that no ray meets. Throws
  /// Error as Triangles.
  LinearSurface(
    std::vector<Triangles::Triangle> triangles, std::vector<std::array<double, 3>> values);

  /// The value where each ray meets the surface first; NaN where it does not. Parallel; each is
  /// that of its ray alone. `corner`: samples at pixels' corners, (width + 1) x (height + 1), else
  /// at their centres; lower-left first. What `progress` aborts is empty.
  [[nodiscard]] std::vector<double> Trace(
    const Camera& camera, bool corners, const Progress& progress = {}) const;

  [[nodiscard]] std::size_t Count() const { return Values.size(); }

private:
  void TraceRow(const Camera& camera, int row, double offset, std::span<double> values) const;

  std::unique_ptr<const Triangles> Shapes;
  std::vector<std::array<double, 3>> Values;
};
} // namespace pixelexact
