// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactCut.h"

#include "Core/Base/Error.h"

#include "vtkImplicitFunction.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkPixelExactCut::vtkPixelExactCut()
  : MeshFilter(pixelexact::MeshScope::PartByBlock)
{
}

//------------------------------------------------------------------------------
vtkPixelExactCut::~vtkPixelExactCut() = default;

//------------------------------------------------------------------------------
void vtkPixelExactCut::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "CutFunction: " << (this->CutFunction ? this->CutFunction->GetClassName() : "(none)")
     << "\n";
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPixelExactCut::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->CutFunction ? std::max(own, this->CutFunction->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkPixelExactCut::SetCutFunction(vtkImplicitFunction* function)
{
  if (this->CutFunction != function)
  {
    this->CutFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPixelExactCut::Make(vtkDataObject* mesh, vtkDataObject* output)
{
  if (this->CutFunction == nullptr)
  {
    throw pixelexact::InvalidData("there is no cut function; choose a Slice Type or Clip Type.");
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(output);
  grid->ShallowCopy(mesh);
  this->Describe(this->CutFunction, grid);
  return true;
}
