// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/BareElements.h"

#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Core/Shape/ShapeFace.h"
#include "HighOrderModel.h"

namespace pixelexact
{
namespace
{
int FacesOfElement(const HighOrderModel& model, int element)
{
  return static_cast<int>(FacesOf(model.GetMesh().ShapeOf(element)).size());
}
} // namespace

unsigned char InnerOf(const HighOrderModel& model, int element)
{
  unsigned int bits = 0;
  for (int face = 0; face < FacesOfElement(model, element); ++face)
  {
    const FaceKind kind = model.Faces().KindOf(element, face);
    bits |= kind == FaceKind::Interior || kind == FaceKind::Hanging
      ? 1U << static_cast<unsigned int>(face)
      : 0U;
  }
  return static_cast<unsigned char>(bits);
}

std::vector<unsigned char> InnerOfAll(const HighOrderModel& model)
{
  std::vector<unsigned char> inner;
  inner.reserve(static_cast<std::size_t>(model.GetMesh().Elements()));
  for (int e = 0; e < model.GetMesh().Elements(); ++e)
  {
    inner.push_back(InnerOf(model, e));
  }
  return inner;
}

std::vector<vtkIdType> BareElements(
  const HighOrderModel& model, const std::vector<unsigned char>& inner)
{
  std::vector<vtkIdType> bare;
  for (std::size_t e = 0; e < inner.size(); ++e)
  {
    const int faces = FacesOfElement(model, static_cast<int>(e));
    if (inner[e] + 1U != 1U << static_cast<unsigned int>(faces))
    {
      bare.push_back(static_cast<vtkIdType>(e));
    }
  }
  return bare;
}

vtkBoundingBox BoxAround(const HighOrderModel& model)
{
  const Box3& box = model.GetLocator().Bounds();
  vtkBoundingBox bounds(
    box.lower.x, box.upper.x, box.lower.y, box.upper.y, box.lower.z, box.upper.z);
  bounds.Inflate(1e-6 * bounds.GetDiagonalLength());
  return bounds;
}
} // namespace pixelexact
