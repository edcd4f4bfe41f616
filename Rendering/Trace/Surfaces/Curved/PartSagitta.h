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
/// How far a surface made of faces, or an iso-surface, is off chords: Surface::Sagitta. What is
/// known of an element is made when somebody first asks, and kept. Safe to use from several
/// threads.
class PartSagitta
{
public:
  /// Index and field must outlive the object.
  PartSagitta(
    const ElementIndex& index, const CurvedEquation& equation, std::span<const CurvedPart> parts);

  [[nodiscard]] double Of(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const;

  /// Whether some point of the surface may be in a region; false: proven that none is.
  [[nodiscard]] bool MayMeet(const WideOutline& region, EdgeWork* work) const;

private:
  /// A hit, and the sheets of its element that it is on.
  struct End
  {
    SheetPoint point;
    const EdgeBounds* bounds = nullptr;
    std::array<Sheet, 6> sheets; ///< where several faces meet: as many as an element has
    std::size_t count = 0;

    [[nodiscard]] std::span<const Sheet> Sheets() const { return { sheets.data(), count }; }
  };
  /// How far towards another ray a sheet is proven.
  struct Reach
  {
    double part = 0.0; ///< of the chord to there
    Vec3 end{ 0.0 };
    double off = std::numeric_limits<double>::infinity(); ///< from that chord
  };
  [[nodiscard]] static Reach ReachOf(
    const End& from, const Sheet& sheet, const SheetPoint& towards);
  [[nodiscard]] End EndOf(const Ray& ray, const SurfacePoint& at) const;
  /// Of those of the surface in the order of elements.
  [[nodiscard]] std::span<const CurvedPart> FacesOf(int element) const;
  [[nodiscard]] const EdgeBounds& BoundsOf(int element) const;

  const ElementIndex& Index;
  CurvedEquation Equation;
  std::vector<CurvedPart> Faces; ///< in order; of an iso-surface none
  MadeOnDemand<EdgeBounds> Bounds;
};
} // namespace pixelexact
