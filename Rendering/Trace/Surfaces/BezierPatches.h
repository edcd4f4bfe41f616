// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/BezierPatch.h"
#include "Trace/Surfaces/BezierSeams.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"

#include <memory>
#include <span>

namespace pixelexact
{
/// A surface of tensor-product Bezier patches, bicubic ones among them (paper, section 5.1.1). Hits
/// are what CurvedSurface says; patches that share an edge, with the same points to some roundings,
/// let no ray through between them. Each patch is the face of an element that has no thickness.
class BezierPatches final : public CurvedSurface
{
public:
  static constexpr int kHighestDegree = 16;

  /// Throws Error without patches, for degrees other than 1 to 16, for a number of points that does
  /// not go with them, and for points that are not finite; it names the patch.
  explicit BezierPatches(std::span<const BezierPatch> patches);
  ~BezierPatches() override;
  BezierPatches(const BezierPatches&) = delete;
  BezierPatches& operator=(const BezierPatches&) = delete;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] bool HasSagitta() const override { return true; }

  /// What a surface is made of, and the arrays that it is a view of.
  struct Storage;

protected:
  [[nodiscard]] bool TellsElements() const override { return false; }

private:
  explicit BezierPatches(std::unique_ptr<const Storage> storage);

  std::unique_ptr<const Storage> Arrays;
  BezierSeams Seams;
};
} // namespace pixelexact
