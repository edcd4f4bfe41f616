// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/BehindFace.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"
#include "Trace/Surfaces/Curved/JumpFaces.h"

namespace pixelexact
{
/// The parts of faces between elements across which a field's component jumps from below a value to
/// above it. Together with the iso-surface they are the complete boundary between smaller and
/// larger values.
///
/// A hit is Certain if the proven enclosures of the values on both sides lie on different sides of
/// the value. There is no hit if both values lie on the same side, or if their enclosures overlap,
/// so that no jump is proven. Otherwise, or if what lies behind the face is unknown, the hit is
/// Undecided. Values are those of the element that the hit stores: of two elements, the one with
/// the lower number.
///
/// Faces are omitted if both sides agree to 1e-12 of the field's largest value near them, at points
/// that determine their polynomials. Without faces, no ray meets the surface.
class JumpWalls final : public CurvedSurface
{
public:
  /// `component`: of the field, or kMagnitude. Locator and field must outlive the surface; the
  /// table is not used after construction. Throws Unsupported for mapped fields (H(curl), H(div),
  /// density).
  JumpWalls(const Locator& locator, const FaceTable& table, const Field& field, int component,
    double value);

  [[nodiscard]] bool IsOfMesh() const override { return true; }

protected:
  void Review(
    const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const override;

private:
  JumpWalls(const Locator& locator, const JumpFaces& faces, const CurvedEquation& equation);
  struct OneHit;
  /// FindBehind's results at hits of a part, from number `first` on.
  [[nodiscard]] std::vector<BehindFace> BehindHits(
    const CurvedPart& part, const std::vector<CurvedHit>& hits, std::size_t first) const;
  /// The side of the sought value on which an element's values lie: -1 below, 1 above, 0 too close
  /// to decide without an enclosure.
  [[nodiscard]] std::vector<int> SidesAt(int element, std::span<const Vec3> xi) const;
  /// Enclosures of the compared quantity (for a magnitude, its square) at points of an element.
  [[nodiscard]] std::vector<Interval> EnclosuresAt(
    int element, std::span<const Vec3> xi, std::span<const Vec3> x) const;

  const Locator& Behind;
  CurvedEquation Sought;
  std::vector<AcrossFace> Across; ///< by part
};
} // namespace pixelexact
