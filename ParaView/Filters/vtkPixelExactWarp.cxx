// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactWarp.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPixelExactWarp);

//------------------------------------------------------------------------------
void vtkPixelExactWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Displacement: " << this->Displacement << "\n";
  os << indent << "Expression: " << this->Expression << "\n";
}

//------------------------------------------------------------------------------
void vtkPixelExactWarp::SetDisplacement(const char* field)
{
  this->Displacement = field != nullptr ? field : "";
  this->ChooseField();
}

//------------------------------------------------------------------------------
void vtkPixelExactWarp::SetExpression(const char* expression)
{
  this->Expression = expression != nullptr ? expression : "";
  this->ChooseField();
}

//------------------------------------------------------------------------------
void vtkPixelExactWarp::ChooseField()
{
  this->SetFieldName(this->Expression.empty() ? this->Displacement : this->Expression);
}
