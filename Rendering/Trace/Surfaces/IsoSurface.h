// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Index/ElementIndex.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"
#include "Trace/Surfaces/Curved/PartSagitta.h"

namespace pixelexact
{
/// The equation of an iso-surface of a field's component, or of its magnitude (kMagnitude; for a
/// scalar field, the scalar). Throws Error for a component that does not exist and for a value that
/// is not finite or, of a magnitude, not positive. Throws Unsupported for mapped fields (H(curl),
/// H(div), density).
CurvedEquation IsoEquation(const Mesh& mesh, const Field& field, int component, double value);

class ValueIndex;

/// The points where a field's component has a value. Elements whose certified range excludes the
/// value are skipped. Where the field jumps between elements, the surface ends; its walls are a
/// surface of their own (JumpWalls). Hits have the properties of CurvedSurface's, and store element
/// and xi.
class IsoSurface final : public CurvedSurface
{
public:
  /// `component`: of the field, or kMagnitude. Index and field must outlive the surface. Throws
  /// Error, with the field's range, if no element may take the value, and for a value that is not
  /// finite or, of a magnitude, not positive. Throws Unsupported for mapped fields (H(curl),
  /// H(div), density). `mayBeEmpty`: no element has to take the value.
  IsoSurface(const ElementIndex& index, const Field& field, int component, double value,
    bool mayBeEmpty = false);

  [[nodiscard]] bool IsOfMesh() const override { return true; }
  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override
  {
    return Chords.Of(a, atA, b, atB);
  }
  [[nodiscard]] bool HasSagitta() const override { return true; }
  [[nodiscard]] bool MayMeet(const Outline& part, double slack, EdgeWork* work) const override
  {
    return Chords.MayMeet({ part, slack }, work);
  }
  [[nodiscard]] std::optional<double> HeldValue(const Field& field, int component) const override;

protected:
  void NormalsOf(
    std::int32_t part, std::span<const Vec3> xi, std::span<Vec3> normals) const override;

private:
  struct Elements;
  IsoSurface(const ElementIndex& index, const CurvedEquation& equation, const Elements& elements);

  const Field& field_;
  PartSagitta Chords;
};
} // namespace pixelexact
