// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Index/ElementIndex.h"
#include "Core/Questions/EdgeBounds.h"
#include "Trace/Camera.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/HitSlots.h"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace pixelexact
{
/// Bounds the distance of a surface made of faces, or of an iso-surface, from chords:
/// Surface::Sagitta. Bounds of an element are computed on first use and kept. Safe to use from
/// several threads.
class PartSagitta
{
public:
  /// Index and field must outlive the object.
  PartSagitta(
    const ElementIndex& index, const CurvedEquation& equation, std::span<const CurvedPart> parts);

  [[nodiscard]] double Of(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const;

  /// Some point of the surface may lie in a region; false if it is proven that none does.
  [[nodiscard]] bool MayMeet(const WideOutline& region, EdgeWork* work) const;

private:
  /// A hit, and the sheets of its element that it lies on.
  struct End
  {
    SheetPoint point;
    const EdgeBounds* bounds = nullptr;
    std::array<Sheet, 6> sheets; ///< several where faces meet; at most an element's faces
    std::size_t count = 0;

    [[nodiscard]] std::span<const Sheet> Sheets() const { return { sheets.data(), count }; }
  };
  /// The extent to which a sheet is proven towards another ray.
  struct Reach
  {
    double part = 0.0; ///< part of the chord up to `end`
    Vec3 end{ 0.0 };
    double off = std::numeric_limits<double>::infinity(); ///< largest distance from that chord
  };
  [[nodiscard]] static Reach ReachOf(
    const End& from, const Sheet& sheet, const SheetPoint& towards);
  [[nodiscard]] End EndOf(const Ray& ray, const SurfacePoint& at) const;
  /// The surface's faces of an element.
  [[nodiscard]] std::span<const CurvedPart> FacesOf(int element) const;
  [[nodiscard]] const EdgeBounds& BoundsOf(int element) const;

  const ElementIndex& Index;
  CurvedEquation Equation;
  std::vector<CurvedPart> Faces; ///< in the order of elements; none for an iso-surface
  MadeOnDemand<EdgeBounds> Bounds;
};
} // namespace pixelexact
