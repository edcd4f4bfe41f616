// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceNumbers.h"
#include "Core/Index/ElementIndex.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"
#include "Trace/Surfaces/Curved/PartSagitta.h"

#include <span>

namespace pixelexact
{
/// Curved faces of a mesh's elements (paper, section 5.1.1). Hits are what CurvedSurface says, and
/// tell their element and xi: values are those on this element's side of the face.
class ElementFaces final : public CurvedSurface
{
public:
  /// The index must outlive the surface. Throws Error without faces, and for faces that do not
  /// exist.
  ElementFaces(const ElementIndex& index, std::span<const ElementFace> faces);

  [[nodiscard]] const std::vector<ElementFace>& Faces() const { return TheFaces; }

  [[nodiscard]] bool IsOfMesh() const override { return true; }
  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override
  {
    return Chords.Of(a, atA, b, atB);
  }
  [[nodiscard]] bool HasSagitta() const override { return true; }

protected:
  void NormalsOf(
    const CurvedPart& part, std::span<const Vec3> xi, std::span<Vec3> normals) const override;

private:
  std::vector<ElementFace> TheFaces;
  PartSagitta Chords;
};
} // namespace pixelexact
