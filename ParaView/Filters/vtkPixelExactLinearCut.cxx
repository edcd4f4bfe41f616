// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactLinearCut.h"

#include "InputCut.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkPixelExactLinearCut);

//------------------------------------------------------------------------------
vtkPixelExactLinearCut::vtkPixelExactLinearCut()
  : Cut(std::make_unique<pixelexact::InputCut>())
{
}

//------------------------------------------------------------------------------
vtkPixelExactLinearCut::~vtkPixelExactLinearCut() = default;

//------------------------------------------------------------------------------
void vtkPixelExactLinearCut::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseInputCut: " << this->Cut->ofInput << "\n";
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPixelExactLinearCut::GetMTime()
{
  return this->Cut->Latest(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
void vtkPixelExactLinearCut::SetCutFunction(vtkImplicitFunction* function)
{
  this->Cut->chosen = function;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactLinearCut::SetUseInputCut(bool use)
{
  if (this->Cut->ofInput != use)
  {
    this->Cut->ofInput = use;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPixelExactLinearCut::Make(vtkDataObject* mesh, Output* output)
{
  this->Superclass::SetCutFunction(this->Cut->In(mesh));
  return this->Superclass::Make(mesh, output);
}
