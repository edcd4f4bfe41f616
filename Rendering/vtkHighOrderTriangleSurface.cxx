// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderTriangleSurface.h"

#include "Surfaces/SurfaceInput.h"
#include "Surfaces/VtkTriangles.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHighOrderTriangleSurface);

//------------------------------------------------------------------------------
vtkHighOrderTriangleSurface::vtkHighOrderTriangleSurface()
{
  this->Input->Accept({ "vtkPolyData" });
}

//------------------------------------------------------------------------------
vtkHighOrderTriangleSurface::~vtkHighOrderTriangleSurface() = default;

//------------------------------------------------------------------------------
void vtkHighOrderTriangleSurface::SetInputData(vtkPolyData* data)
{
  this->Input->SetData(data);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHighOrderTriangleSurface::GetInput()
{
  return vtkPolyData::SafeDownCast(this->Input->Data());
}

//------------------------------------------------------------------------------
std::shared_ptr<const pixelexact::Surface> vtkHighOrderTriangleSurface::MakeSurface(
  const std::shared_ptr<const pixelexact::HighOrderModel>& /*model*/,
  const pixelexact::SurfaceSearch& /*search*/)
{
  return pixelexact::ToTriangles(this->Input->DataOf<vtkPolyData>(this));
}

//------------------------------------------------------------------------------
void vtkHighOrderTriangleSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
