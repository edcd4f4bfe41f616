// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderTriangleSurface.h"

#include "SurfaceInput.h"
#include "VtkTriangles.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderTriangleSurface);

//------------------------------------------------------------------------------
vtkHighOrderTriangleSurface::vtkHighOrderTriangleSurface()
  : Input(vtkSmartPointer<pixelexact::SurfaceInput>::New())
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
void vtkHighOrderTriangleSurface::SetInputConnection(vtkAlgorithmOutput* output)
{
  this->Input->SetInputConnection(output);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHighOrderTriangleSurface::GetInput()
{
  return vtkPolyData::SafeDownCast(this->Input->Data());
}

//------------------------------------------------------------------------------
void vtkHighOrderTriangleSurface::Update()
{
  this->Input->Update();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHighOrderTriangleSurface::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Input->GetMTime());
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
  os << indent << "Input: ";
  if (vtkPolyData* input = this->GetInput())
  {
    os << input->GetNumberOfPolys() << " polygons, " << input->GetNumberOfStrips() << " strips\n";
  }
  else
  {
    os << "(none)\n";
  }
}
