// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"
#include "Trace/Surfaces/Curved/PartSagitta.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// Curved faces of a mesh's elements (paper, section 5.1.1). Hits have the properties of
/// CurvedSurface's, and store element and xi. Values are those on this element's side of the face.
class ElementFaces final : public CurvedSurface
{
public:
  /// The index must outlive the surface. Throws Error without faces, and for faces that do not
  /// exist.
  ElementFaces(const ElementIndex& index, std::span<const ElementFace> faces);
  /// `partly`: one entry per face; true: the face is partly covered by other elements. On such a
  /// face, only uncovered points are hits. FindBehind decides this for each hit, and a hit is
  /// Undecided if it cannot. The locator must outlive the surface.
  ElementFaces(
    const Locator& locator, std::span<const ElementFace> faces, std::vector<bool> partly);

  [[nodiscard]] const std::vector<ElementFace>& Faces() const { return faces_; }

  [[nodiscard]] bool IsOfMesh() const override { return true; }
  [[nodiscard]] int FaceOf(std::int32_t piece) const override
  {
    return faces_[static_cast<std::size_t>(piece)].face;
  }
  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override
  {
    // Another element may cover a face between two hits.
    return IsPartly(atA.piece) || IsPartly(atB.piece) ? kNoHit : Chords.Of(a, atA, b, atB);
  }
  [[nodiscard]] bool HasSagitta() const override { return true; }
  [[nodiscard]] bool MayMeet(const Outline& part, double slack, EdgeWork* work) const override
  {
    return Chords.MayMeet({ part, slack }, work);
  }

protected:
  void Review(
    const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const override;

private:
  [[nodiscard]] bool IsPartly(std::int32_t part) const
  {
    return part >= 0 && !Partly.empty() && Partly[static_cast<std::size_t>(part)];
  }

  const Locator* Behind = nullptr; ///< null: no face is partly covered
  std::vector<bool> Partly;
  std::vector<ElementFace> faces_;
  PartSagitta Chords;
};
} // namespace pixelexact
