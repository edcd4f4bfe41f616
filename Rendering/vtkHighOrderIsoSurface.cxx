// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderIsoSurface.h"

#include "Surfaces/MeshSurfaces.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHighOrderIsoSurface);

//------------------------------------------------------------------------------
vtkHighOrderIsoSurface::vtkHighOrderIsoSurface() = default;

//------------------------------------------------------------------------------
vtkHighOrderIsoSurface::~vtkHighOrderIsoSurface() = default;

//------------------------------------------------------------------------------
void vtkHighOrderIsoSurface::SetFieldName(const char* name)
{
  // In VTK 9.1, vtkSetStdStringFromCharMacro calls Modified also for an unchanged name.
  const std::string wanted = name != nullptr ? name : "";
  if (this->FieldName != wanted)
  {
    this->FieldName = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const pixelexact::Surface> vtkHighOrderIsoSurface::MakeSurface(
  const std::shared_ptr<const pixelexact::HighOrderModel>& model,
  const pixelexact::SurfaceSearch& /*search*/)
{
  return pixelexact::MakeIsoSurface(
    model, { this->FieldName, this->Component, this->Value, this->MayBeEmpty });
}

//------------------------------------------------------------------------------
void vtkHighOrderIsoSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldName: " << (this->FieldName.empty() ? "(first)" : this->FieldName) << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "MayBeEmpty: " << this->MayBeEmpty << "\n";
}
