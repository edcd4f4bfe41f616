// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderPatchSurface.h"

#include "Surfaces/SurfaceInput.h"
#include "Surfaces/VtkPatches.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"

vtkStandardNewMacro(vtkHighOrderPatchSurface);

//------------------------------------------------------------------------------
vtkHighOrderPatchSurface::vtkHighOrderPatchSurface()
{
  this->Input->Accept({ "vtkPolyData", "vtkUnstructuredGrid" });
}

//------------------------------------------------------------------------------
vtkHighOrderPatchSurface::~vtkHighOrderPatchSurface() = default;

//------------------------------------------------------------------------------
void vtkHighOrderPatchSurface::SetInputData(vtkPointSet* data)
{
  this->Input->SetData(data);
}

//------------------------------------------------------------------------------
vtkPointSet* vtkHighOrderPatchSurface::GetInput()
{
  return vtkPointSet::SafeDownCast(this->Input->Data());
}

//------------------------------------------------------------------------------
std::shared_ptr<const pixelexact::Surface> vtkHighOrderPatchSurface::MakeSurface(
  const std::shared_ptr<const pixelexact::HighOrderModel>& /*model*/,
  const pixelexact::SurfaceSearch& /*search*/)
{
  return pixelexact::SurfaceOf(pixelexact::ToPatches(this->Input->DataOf<vtkPointSet>(this)));
}

//------------------------------------------------------------------------------
void vtkHighOrderPatchSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
