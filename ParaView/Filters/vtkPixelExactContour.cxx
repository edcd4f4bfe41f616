// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactContour.h"

#include "InputCut.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkPixelExactContour);

//------------------------------------------------------------------------------
vtkPixelExactContour::vtkPixelExactContour()
  : Cut(std::make_unique<pixelexact::InputCut>())
{
}

//------------------------------------------------------------------------------
vtkPixelExactContour::~vtkPixelExactContour() = default;

//------------------------------------------------------------------------------
void vtkPixelExactContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseInputCut: " << this->Cut->ofInput << "\n";
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPixelExactContour::GetMTime()
{
  return this->Cut->Latest(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
void vtkPixelExactContour::SetCutFunction(vtkImplicitFunction* function)
{
  this->Cut->chosen = function;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactContour::SetUseInputCut(bool use)
{
  if (this->Cut->ofInput != use)
  {
    this->Cut->ofInput = use;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPixelExactContour::Make(vtkDataObject* mesh, Output* output)
{
  this->Superclass::SetCutFunction(this->Cut->In(mesh));
  return this->Superclass::Make(mesh, output);
}
