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

/// What the interval on a part tells of the iso-values.
enum class PartVerdict : std::uint8_t
{
  Out = 0,      ///< proven: none occurs on it
  Possible = 1, ///< one lies in the interval
  Unproven = 2  ///< there is no interval: it is infinite
};

/// Intervals of a scene's field on parts of pixels' edges.
///
/// There is one where the scene has a single layer, which is a Plane, and both ends lie in the same
/// element: the pixel's edge is then straight in the world. Parts of a Plane with both ends beside
/// the mesh are Out where MissesMesh proves it, or where they are cut away together. Of all others
/// nothing is known, as the paper says nothing of them. What a part gets depends on that part
/// alone.
class IntervalParts
{
public:
  /// `values`: of each layer, in ascending order. All must outlive the object.
  IntervalParts(
    const Scene& scene, const Camera& camera, std::span<const std::vector<double>> values);

  void Classify(std::span<const EdgeSample> samples, std::span<const EdgePart> parts,
    std::vector<PartVerdict>& verdicts) const;

private:
  void ClassifyInElement(std::span<const EdgeSample> samples, std::span<const EdgePart> parts,
    std::span<const int> chosen, std::vector<PartVerdict>& verdicts) const;
  [[nodiscard]] bool IsStraight(const EdgeSample& from, const EdgeSample& to) const;
  [[nodiscard]] bool IsBesideMesh(const EdgeSample& from, const EdgeSample& to) const;
  /// Of the ray there, against the plane.
  [[nodiscard]] double Slope(const ImagePosition& at) const;
  [[nodiscard]] double SlackOf(const Vec3& position, const ImagePosition& at) const;

  const Scene& scene_;
  const Camera& camera_;
  std::span<const std::vector<double>> Values;
  const Plane* plane_ = nullptr; ///< null: another scene
};
} // namespace pixelexact
