// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Interval.h"
#include "Trace/Camera.h"
#include "Trace/Contours/LayerSight.h"
#include "Trace/Scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
class Plane;

/// A part of a pixel's edge, between two samples.
struct EdgePart
{
  int edge = 0;
  int from = 0; ///< number of a sample
  int to = 0;
};

/// Compares the interval on a part with the iso-values.
enum class PartVerdict : std::uint8_t
{
  Out = 0,      ///< proven: no iso-value occurs on it
  Possible = 1, ///< an iso-value lies in the interval
  Unproven = 2  ///< there is no finite interval
};

/// Intervals of a scene's field on parts of pixels' edges.
///
/// A part has an interval if the scene has a single layer, this layer is a Plane, and both ends lie
/// in the same element: the edge is then straight in the world. Parts of a Plane with both ends
/// outside the mesh are Out where MissesMesh proves it, or where both ends are clipped by the same
/// plane. All other parts are Unproven, as in the paper. A part's verdict depends on that part
/// alone.
class IntervalParts
{
public:
  /// `values`: of each layer, in ascending order. All arguments must outlive the object.
  IntervalParts(
    const Scene& scene, const Camera& camera, std::span<const std::vector<double>> values);

  void Classify(std::span<const EdgeSample> samples, std::span<const EdgePart> parts,
    std::vector<PartVerdict>& verdicts) const;

private:
  void ClassifyInElement(std::span<const EdgeSample> samples, std::span<const EdgePart> parts,
    std::span<const int> chosen, std::vector<PartVerdict>& verdicts) const;
  [[nodiscard]] bool IsStraight(const EdgeSample& from, const EdgeSample& to) const;
  [[nodiscard]] bool IsBesideMesh(const EdgeSample& from, const EdgeSample& to) const;
  /// Dot product of the ray's direction at `at` and the plane's normal.
  [[nodiscard]] double Slope(const ImagePosition& at) const;
  [[nodiscard]] double SlackOf(const Vec3& position, const ImagePosition& at) const;

  const Scene& scene_;
  const Camera& camera_;
  std::span<const std::vector<double>> Values;
  const Plane* plane_ = nullptr; ///< null: the scene is not a single plane
};
} // namespace pixelexact
