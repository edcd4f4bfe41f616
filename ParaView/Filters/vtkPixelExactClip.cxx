// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactClip.h"

#include "CutDescription.h"

#include "Core/Base/Error.h"

#include "vtkImplicitFunction.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkPixelExactClip);

//------------------------------------------------------------------------------
vtkPixelExactClip::vtkPixelExactClip()
  : MeshFilter(pixelexact::MeshScope::PartByBlock)
{
}

//------------------------------------------------------------------------------
vtkPixelExactClip::~vtkPixelExactClip() = default;

//------------------------------------------------------------------------------
void vtkPixelExactClip::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "ClipFunction: " << (this->ClipFunction ? this->ClipFunction->GetClassName() : "(none)")
     << "\n";
  os << indent << "InsideOut: " << this->InsideOut << "\n";
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPixelExactClip::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ClipFunction ? std::max(own, this->ClipFunction->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkPixelExactClip::SetClipFunction(vtkImplicitFunction* function)
{
  if (this->ClipFunction != function)
  {
    this->ClipFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPixelExactClip::Make(vtkDataObject* mesh, vtkDataObject* output)
{
  if (this->ClipFunction == nullptr)
  {
    throw pixelexact::InvalidData("there is no clip function; choose a Clip Type.");
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(output);
  grid->ShallowCopy(mesh);
  pixelexact::AddCuts(grid, pixelexact::kClips, { { this->ClipFunction, !this->InsideOut } });
  return true;
}
