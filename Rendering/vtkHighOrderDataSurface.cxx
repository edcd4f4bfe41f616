// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderDataSurface.h"

#include "Surfaces/SurfaceInput.h"

#include "vtkDataSet.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkHighOrderDataSurface::vtkHighOrderDataSurface()
  : Input(vtkSmartPointer<pixelexact::SurfaceInput>::New())
{
}

//------------------------------------------------------------------------------
vtkHighOrderDataSurface::~vtkHighOrderDataSurface() = default;

//------------------------------------------------------------------------------
void vtkHighOrderDataSurface::SetInputConnection(vtkAlgorithmOutput* output)
{
  this->Input->SetInputConnection(output);
}

//------------------------------------------------------------------------------
void vtkHighOrderDataSurface::Update()
{
  this->Input->Update();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHighOrderDataSurface::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Input->GetMTime());
}

//------------------------------------------------------------------------------
void vtkHighOrderDataSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Input: ";
  if (auto* input = vtkDataSet::SafeDownCast(this->Input->Data()))
  {
    os << input->GetNumberOfPoints() << " points, " << input->GetNumberOfCells() << " cells\n";
  }
  else
  {
    os << "(none)\n";
  }
}
