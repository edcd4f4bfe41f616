// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderPatchSurface.h"

#include "SurfaceInput.h"
#include "VtkPatches.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderPatchSurface);

//------------------------------------------------------------------------------
vtkHighOrderPatchSurface::vtkHighOrderPatchSurface()
  : Input(vtkSmartPointer<pixelexact::SurfaceInput>::New())
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
void vtkHighOrderPatchSurface::SetInputConnection(vtkAlgorithmOutput* output)
{
  this->Input->SetInputConnection(output);
}

//------------------------------------------------------------------------------
vtkPointSet* vtkHighOrderPatchSurface::GetInput()
{
  return vtkPointSet::SafeDownCast(this->Input->Data());
}

//------------------------------------------------------------------------------
void vtkHighOrderPatchSurface::Update()
{
  this->Input->Update();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHighOrderPatchSurface::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Input->GetMTime());
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
  os << indent << "Input: ";
  if (vtkPointSet* input = this->GetInput())
  {
    os << input->GetNumberOfPoints() << " points, " << input->GetNumberOfCells() << " cells\n";
  }
  else
  {
    os << "(none)\n";
  }
}
