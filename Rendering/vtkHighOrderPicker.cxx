// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderPicker.h"

#include "Frames/FramePick.h"
#include "vtkHighOrderMapper.h"

#include "Core/Base/Error.h"

#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHighOrderPicker);

namespace
{
// The pixel of the renderer's viewport whose lower left corner this is in the window; none if it
// lies outside.
std::optional<std::array<int, 2>> PixelIn(
  vtkRenderer* renderer, const std::array<double, 2>& corner)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const double x = corner[0] - left;
  const double y = corner[1] - bottom;
  if (!(x >= 0.0 && x < width && y >= 0.0 && y < height))
  {
    return std::nullopt;
  }
  return std::array<int, 2>{ static_cast<int>(x), static_cast<int>(y) };
}

vtkDataSet* LeafOf(vtkCompositeDataSet* data, vtkIdType flatIndex)
{
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(data->NewIterator());
  for (leaf->InitTraversal(); leaf->IsDoneWithTraversal() == 0; leaf->GoToNextItem())
  {
    if (leaf->GetCurrentFlatIndex() == flatIndex)
    {
      return vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    }
  }
  return nullptr;
}
} // namespace

//------------------------------------------------------------------------------
vtkHighOrderPicker::vtkHighOrderPicker()
{
  this->ForgetCut();
}

//------------------------------------------------------------------------------
vtkHighOrderPicker::~vtkHighOrderPicker() = default;

//------------------------------------------------------------------------------
void vtkHighOrderPicker::ForgetCut()
{
  this->Verdict = 0;
  this->Element = -1;
  std::fill_n(this->Xi, 3, vtkMath::Nan());
  this->Layer = -1;
  this->FieldName.clear();
  this->Value = vtkMath::Nan();
  this->FieldValues->Initialize();
}

//------------------------------------------------------------------------------
void vtkHighOrderPicker::ResetPickInfo()
{
  this->Superclass::ResetPickInfo();
  this->ForgetCut();
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkHighOrderPicker::GetFieldValues()
{
  return this->FieldValues;
}

//------------------------------------------------------------------------------
int vtkHighOrderPicker::Pick(
  double selectionX, double selectionY, double selectionZ, vtkRenderer* renderer)
{
  if (renderer == nullptr)
  {
    vtkErrorMacro(<< "Must specify renderer!");
    return 0;
  }
  this->Pixel = { std::floor(selectionX), std::floor(selectionY) };
  const int picked =
    this->Superclass::Pick((*this->Pixel)[0] + 0.5, (*this->Pixel)[1] + 0.5, selectionZ, renderer);
  this->Pixel.reset();
  return picked;
}

//------------------------------------------------------------------------------
double vtkHighOrderPicker::IntersectWithLine(const double p1[3], const double p2[3], double tol,
  vtkAssemblyPath* path, vtkProp3D* prop, vtkAbstractMapper3D* mapper)
{
  auto* cut = vtkHighOrderMapper::SafeDownCast(mapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (cut == nullptr || actor == nullptr)
  {
    return this->Superclass::IntersectWithLine(p1, p2, tol, path, prop, mapper);
  }
  vtkMatrix4x4* dataToWorld = this->Transform->GetMatrix();
  double t1 = 0.0;
  double t2 = 1.0;
  int plane = -1;
  if (!ClipLineWithPlanes(cut, dataToWorld, p1, p2, t1, t2, plane))
  {
    return VTK_DOUBLE_MAX;
  }
  if (this->PickClippingPlanes && plane >= 0)
  {
    return this->Superclass::IntersectWithLine(p1, p2, tol, path, prop, mapper);
  }

  pixelexact::PickRay ray;
  ray.renderer = this->Renderer;
  ray.start = glm::make_vec3(p1);
  ray.end = glm::make_vec3(p2);
  ray.dataToWorld = dataToWorld;
  ray.opacity = actor->GetProperty()->GetOpacity();
  if (this->Pixel)
  {
    ray.pixel = PixelIn(this->Renderer, *this->Pixel);
    if (!ray.pixel)
    {
      return VTK_DOUBLE_MAX;
    }
  }
  std::optional<pixelexact::PickedSample> picked;
  try
  {
    picked = cut->PickSample(ray, actor);
  }
  catch (const pixelexact::Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
  if (!picked)
  {
    return VTK_DOUBLE_MAX;
  }
  const pixelexact::Vec3 along = ray.end - ray.start;
  const double t = glm::dot(picked->position - ray.start, along) / glm::dot(along, along);
  if (!(t < this->GlobalTMin))
  {
    return t;
  }

  this->ResetPickInfo();
  this->GlobalTMin = t;
  this->SetPath(path);
  this->Mapper = cut;
  this->DataSet = cut->GetInput();
  this->CompositeDataSet = cut->GetCompositeInput();
  if (picked->block >= 0)
  {
    this->FlatBlockIndex = picked->block;
    this->DataSet = LeafOf(this->CompositeDataSet, picked->block);
  }
  this->ClippingPlaneId = plane;
  this->CellId = picked->cell;
  std::copy_n(glm::value_ptr(picked->position), 3, this->MapperPosition);
  std::copy_n(glm::value_ptr(picked->normal), 3, this->MapperNormal);
  this->Transform->TransformPoint(this->MapperPosition, this->PickPosition);
  this->Transform->TransformNormal(this->MapperNormal, this->PickNormal);
  this->Verdict = static_cast<int>(picked->verdict);
  this->Layer = picked->layer;
  this->FieldName = picked->field;
  if (picked->verdict == pixelexact::PixelVerdict::Exact)
  {
    this->Element = picked->source;
    std::copy_n(glm::value_ptr(picked->xi), 3, this->Xi);
    this->Value = picked->value;
    if (!picked->values.empty())
    {
      this->FieldValues->SetName(picked->field.c_str());
      this->FieldValues->SetNumberOfComponents(static_cast<int>(picked->values.size()));
      this->FieldValues->InsertNextTuple(picked->values.data());
    }
  }
  return t;
}

//------------------------------------------------------------------------------
void vtkHighOrderPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Verdict: " << this->Verdict << "\n";
  os << indent << "Element: " << this->Element << "\n";
  os << indent << "Xi: (" << this->Xi[0] << ", " << this->Xi[1] << ", " << this->Xi[2] << ")\n";
  os << indent << "Layer: " << this->Layer << "\n";
  os << indent << "FieldName: " << (this->FieldName.empty() ? "(none)" : this->FieldName) << "\n";
  os << indent << "Value: " << this->Value << "\n";
}
