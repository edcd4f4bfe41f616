// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactCertifier.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPixelExactCertifier);

//------------------------------------------------------------------------------
void vtkPixelExactCertifier::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkPixelExactCertifier::SetFieldName(std::string name)
{
  this->Superclass::SetFieldName(name == "None" ? "" : name);
}
