// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Volume/VolumeLeaves.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pixelexact
{
/// A part of a ray in one leaf: t from `from` to `to`. There u is the Chebyshev series of
/// x = (t - middle) / half, component by component, up to `error`.
struct RaySpan
{
  int element;
  double from;
  double to;
  double fromError; ///< how far the leaf's true end may be off
  double toError;
  double middle;
  double half;
  int points;         ///< coefficients per component
  std::size_t series; ///< index of the first coefficient
  double error;       ///< in the max norm of the components; infinite where not proven
  bool isProven;      ///< error and ends are proven
};

/// A ray of a tile, and the part of it in which the volume is wanted.
struct VolumeRay
{
  Ray ray;
  double tNear = 0.0;
  double tFar = 0.0;   ///< below tNear: nothing is wanted
  bool isDone = false; ///< no spans are wanted
};

/// The spans of a tile's rays, computed element by element, in batches of points.
class RaySpans
{
public:
  explicit RaySpans(const VolumeLeaves& leaves)
    : leaves_(leaves)
  {
  }

  /// Replaces all spans by those of these rays, by ray sorted by `from`. `part`: of the leaves'
  /// tolerances that interpolants may use. `tau`: about the largest tau; the ends of spans in thick
  /// matter are found more exactly.
  void Find(std::span<const VolumeRay> rays, double part, double tau);

  [[nodiscard]] std::span<const RaySpan> Of(std::size_t ray) const
  {
    return std::span(spans_).subspan(first_[ray], first_[ray + 1] - first_[ray]);
  }
  [[nodiscard]] const double* Series(const RaySpan& span) const
  {
    return series_.data() + span.series;
  }
  /// Some part of the ray in the mesh has no span, because no preimage was found there.
  [[nodiscard]] bool HasLost(std::size_t ray) const { return lost_[ray] != 0; }

private:
  /// A ray's passage near a leaf, before the interpolation.
  struct Passage
  {
    int ray;
    double middle;
    double half;
    Vec3 z;  ///< at the middle
    Vec3 dz; ///< of half the passage
    int points;
    double placeError;
    double valueError;
  };

  /// The part of a ray in an element's box.
  struct NearPart
  {
    int ray;
    double tNear;
    double tFar;
  };

  void FindNearParts(int element, std::span<const int> rays);
  void Gather(int element, const VolumeLeaf& leaf);
  void Evaluate(int element, const VolumeLeaf& leaf);
  void Interpolate(int element, const VolumeLeaf& leaf, const Passage& passage, std::size_t at,
    std::size_t stride);
  void AddSpans(const VolumeLeaf& leaf, const RaySpan& whole, int ray,
    const std::array<std::array<double, kMaxRayPoints>, 3>& place, double placeError);

  const VolumeLeaves& leaves_;
  std::span<const VolumeRay> rays_;
  double part_ = 1.0;
  double tau_ = 0.0;
  std::vector<RaySpan> found_;
  std::vector<int> rayOf_; ///< of found_
  std::vector<RaySpan> spans_;
  std::vector<std::size_t> first_;
  std::vector<double> series_;
  std::vector<unsigned char> lost_;
  std::vector<NearPart> near_; ///< scratch of one element
  // Scratch of one leaf.
  std::vector<Passage> passages_;
  std::vector<double> lanes_;
};
} // namespace pixelexact
