// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Index/ElementIndex.h"
#include "Trace/Surfaces/Curved/CurvedSurface.h"

#include <span>

namespace pixelexact
{
/// A face of an element, numbered as in FacesOf.
struct FaceOfElement
{
  std::int32_t element = -1;
  std::int32_t face = -1;
};

/// Curved faces of a mesh's elements (paper, section 5.1.1). Hits are what CurvedSurface says, and
/// tell their element and xi: values are those on this element's side of the face.
class ElementFaces final : public CurvedSurface
{
public:
  /// The index must outlive the surface. Throws Error without faces, and for faces that do not
  /// exist.
  ElementFaces(const ElementIndex& index, std::span<const FaceOfElement> faces);

  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;
  [[nodiscard]] bool IsOfMesh() const override { return true; }
};
} // namespace pixelexact
