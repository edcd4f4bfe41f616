// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactClip.h"

#include "CutDescription.h"

#include "vtkImplicitFunction.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPixelExactClip);

//------------------------------------------------------------------------------
vtkPixelExactClip::vtkPixelExactClip() = default;

//------------------------------------------------------------------------------
vtkPixelExactClip::~vtkPixelExactClip() = default;

//------------------------------------------------------------------------------
void vtkPixelExactClip::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InsideOut: " << this->InsideOut << "\n";
}

//------------------------------------------------------------------------------
void vtkPixelExactClip::Describe(vtkImplicitFunction* function, vtkUnstructuredGrid* grid)
{
  pixelexact::AddCuts(grid, pixelexact::kClips, { { function, !this->InsideOut } });
}
