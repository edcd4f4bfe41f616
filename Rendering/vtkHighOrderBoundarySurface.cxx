// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderBoundarySurface.h"

#include "Surfaces/MeshSurfaces.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHighOrderBoundarySurface);

//------------------------------------------------------------------------------
vtkHighOrderBoundarySurface::vtkHighOrderBoundarySurface()
  : Choice(std::make_unique<pixelexact::BoundaryChoice>())
{
}

//------------------------------------------------------------------------------
vtkHighOrderBoundarySurface::~vtkHighOrderBoundarySurface() = default;

//------------------------------------------------------------------------------
void vtkHighOrderBoundarySurface::SelectAll()
{
  if (*this->Choice != pixelexact::BoundaryChoice())
  {
    *this->Choice = {};
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderBoundarySurface::AddAttribute(int attribute)
{
  this->Choice->attributes.push_back(attribute);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkHighOrderBoundarySurface::GetNumberOfAttributes()
{
  return static_cast<int>(this->Choice->attributes.size());
}

//------------------------------------------------------------------------------
int vtkHighOrderBoundarySurface::GetAttribute(int index)
{
  return index >= 0 && index < this->GetNumberOfAttributes()
    ? this->Choice->attributes[static_cast<std::size_t>(index)]
    : -1;
}

//------------------------------------------------------------------------------
void vtkHighOrderBoundarySurface::AddElement(vtkIdType element)
{
  this->Choice->elements.push_back(element);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkHighOrderBoundarySurface::GetNumberOfElements()
{
  return static_cast<int>(this->Choice->elements.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderBoundarySurface::GetElement(int index)
{
  return index >= 0 && index < this->GetNumberOfElements()
    ? this->Choice->elements[static_cast<std::size_t>(index)]
    : -1;
}

//------------------------------------------------------------------------------
void vtkHighOrderBoundarySurface::SetInnerFaces(bool inner)
{
  if (this->Choice->inner != inner)
  {
    this->Choice->inner = inner;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHighOrderBoundarySurface::GetInnerFaces()
{
  return this->Choice->inner;
}

//------------------------------------------------------------------------------
std::shared_ptr<const pixelexact::Surface> vtkHighOrderBoundarySurface::MakeSurface(
  const std::shared_ptr<const pixelexact::HighOrderModel>& model,
  const pixelexact::SurfaceSearch& /*search*/)
{
  return pixelexact::MakeBoundary(model, *this->Choice);
}

//------------------------------------------------------------------------------
void vtkHighOrderBoundarySurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Attributes:";
  for (const int attribute : this->Choice->attributes)
  {
    os << " " << attribute;
  }
  os << "\n" << indent << "Elements:";
  for (const std::int64_t element : this->Choice->elements)
  {
    os << " " << element;
  }
  os << "\n" << indent << "InnerFaces: " << this->Choice->inner;
  os << (*this->Choice == pixelexact::BoundaryChoice() ? " (the boundary of the mesh)\n" : "\n");
}
