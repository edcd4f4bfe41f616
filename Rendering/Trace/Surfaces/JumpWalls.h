// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"

namespace pixelexact
{
/// The parts of faces between elements across which a component of a field jumps from below a value
/// to above it: what an iso-surface lacks there to be the boundary between less and more.
///
/// A hit is Certain where the proven enclosures of the values on both sides lie on different sides
/// of the value, none where they lie on the same side or meet each other, so that no jump is
/// proven; else, or where what lies behind the face is not known, Undecided. Values are those of
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
  void NormalsOf(
    const CurvedPart& part, std::span<const Vec3> xi, std::span<Vec3> normals) const override;

private:
  JumpWalls(const Locator& locator, std::vector<CurvedPart> parts, const Field& field,
    int component, double value);
  /// Enclosures of what is compared (of a magnitude, its square) at points of an element.
  [[nodiscard]] std::vector<Interval> EnclosuresAt(
    int element, std::span<const Vec3> xi, std::span<const Vec3> x) const;

  const Locator& Behind;
  const Field& TheField;
  int Component;
  Interval Compared; ///< the value, or its square
};
} // namespace pixelexact
