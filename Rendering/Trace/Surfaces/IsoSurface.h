// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Index/ElementIndex.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"
#include "Trace/Surfaces/Curved/PartSagitta.h"

namespace pixelexact
{
/// What makes an iso-surface of a component of a field, or of its magnitude (kMagnitude; of a
/// scalar field: the scalar). Throws Error for a component that is not there, for a value that is
/// not a finite number or, of a magnitude, not positive; Unsupported for mapped fields (H(curl),
/// H(div), density).
CurvedEquation IsoEquation(const Mesh& mesh, const Field& field, int component, double value);

class ValueIndex;

/// Where a component of a field has a value. Elements whose certified range does not hold it are
/// not looked at. Where the field jumps between elements, the surface ends: its walls are a surface
/// of their own (JumpWalls).
/// Hits are what CurvedSurface says, and tell their element and xi.
class IsoSurface final : public CurvedSurface
{
public:
  /// `component`: of the field, or kMagnitude. Index and field must outlive the surface. Throws
  /// Error, naming the field's range, where no element may hold the value, and for what is not a
  /// finite number or, of a magnitude, not positive; Unsupported for mapped fields (H(curl),
  /// H(div), density). With `mayBeEmpty` no element has to hold the value.
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
