// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/BezierPatch.h"
#include "Trace/Surfaces/BezierSeams.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"

#include <memory>
#include <span>

namespace pixelexact
{
/// A surface of tensor-product Bezier patches, such as bicubic ones (paper, section 5.1.1). Hits
/// have the properties of CurvedSurface's. No ray passes between patches that share an edge with
/// the same points up to some roundings. Each patch is the face of an element without thickness.
class BezierPatches final : public CurvedSurface
{
public:
  static constexpr int kHighestDegree = 16;

  /// Throws Error without patches, for degrees outside 1 to 16, for a number of points that does
  /// not match the degrees, and for points that are not finite; the message names the patch.
  explicit BezierPatches(std::span<const BezierPatch> patches);
  ~BezierPatches() override;
  BezierPatches(const BezierPatches&) = delete;
  BezierPatches& operator=(const BezierPatches&) = delete;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] bool HasSagitta() const override { return true; }

  /// The arrays that the surface views.
  struct Storage;

protected:
  [[nodiscard]] bool TellsElements() const override { return false; }

private:
  explicit BezierPatches(std::unique_ptr<const Storage> storage);

  std::unique_ptr<const Storage> Arrays;
  BezierSeams Seams;
};
} // namespace pixelexact
