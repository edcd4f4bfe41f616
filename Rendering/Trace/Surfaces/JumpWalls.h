// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/BehindFace.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"
#include "Trace/Surfaces/Curved/JumpFaces.h"

namespace pixelexact
{
/// The parts of faces between elements across which a component of a field jumps from below a value
/// to above it: what an iso-surface lacks there to be the boundary between less and more.
///
/// A hit is Certain where the proven enclosures of the values on both sides lie on different sides
/// of the value, none where both values lie on the same side of it, or where their enclosures meet
/// each other, so that no jump is proven; else, or where what lies behind the face is not known,
/// Undecided. Values are those of
/// the element that hits tell: of two elements the one with the lower number.
///
/// Faces on which both sides agree to 1e-12 of the field's largest value near them, at points that
/// tell their polynomials apart, are left out at once. No faces: nothing is met.
class JumpWalls final : public CurvedSurface
{
public:
  /// Throws Unsupported for mapped fields (H(curl), H(div), density). `component`: of the field, or
  /// kMagnitude. Locator and field must outlive the surface; the table is not used afterwards.
  JumpWalls(const Locator& locator, const FaceTable& table, const Field& field, int component,
    double value);

  [[nodiscard]] bool IsOfMesh() const override { return true; }

protected:
  void Review(
    const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const override;

private:
  JumpWalls(const Locator& locator, const JumpFaces& faces, const CurvedEquation& equation);
  struct OneHit;
  /// What lies behind hits of a part, from number `first` on.
  [[nodiscard]] std::vector<BehindFace> BehindHits(
    const CurvedPart& part, const std::vector<CurvedHit>& hits, std::size_t first) const;
  /// On which side of the sought value an element's are: -1 below, 1 above, 0 too near to tell
  /// without a proof.
  [[nodiscard]] std::vector<int> SidesAt(int element, std::span<const Vec3> xi) const;
  /// Enclosures of what is compared (of a magnitude, its square) at points of an element.
  [[nodiscard]] std::vector<Interval> EnclosuresAt(
    int element, std::span<const Vec3> xi, std::span<const Vec3> x) const;

  const Locator& Behind;
  CurvedEquation Sought;
  std::vector<AcrossFace> Across; ///< by part
};
} // namespace pixelexact
