// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderLayer.h"

#include "ContourList.h"
#include "vtkHighOrderSurface.h"

#include "vtkImplicitFunction.h"
#include "vtkObjectFactory.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderLayer);

//------------------------------------------------------------------------------
vtkHighOrderLayer::vtkHighOrderLayer()
  : Contours(std::make_unique<pixelexact::ContourList>())
{
}

//------------------------------------------------------------------------------
vtkHighOrderLayer::~vtkHighOrderLayer() = default;

//------------------------------------------------------------------------------
void vtkHighOrderLayer::SetCutFunction(vtkImplicitFunction* function)
{
  if (this->CutFunction != function)
  {
    this->CutFunction = function;
    this->Surface = function != nullptr ? nullptr : this->Surface;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkHighOrderLayer::GetCutFunction()
{
  return this->CutFunction;
}

//------------------------------------------------------------------------------
void vtkHighOrderLayer::SetSurface(vtkHighOrderSurface* surface)
{
  if (this->Surface != surface)
  {
    this->Surface = surface;
    this->CutFunction = surface != nullptr ? nullptr : this->CutFunction;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHighOrderSurface* vtkHighOrderLayer::GetSurface()
{
  return this->Surface;
}

//------------------------------------------------------------------------------
void vtkHighOrderLayer::SetFieldName(const char* name)
{
  // In VTK 9.1, vtkSetStdStringFromCharMacro calls Modified also for an unchanged name.
  const std::string wanted = name != nullptr ? name : "";
  if (this->FieldName != wanted)
  {
    this->FieldName = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderLayer::SetLookupTable(vtkScalarsToColors* table)
{
  if (this->LookupTable != table)
  {
    this->LookupTable = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkHighOrderLayer::GetLookupTable()
{
  return this->LookupTable;
}

//------------------------------------------------------------------------------
void vtkHighOrderLayer::SetContourValue(int i, double value)
{
  if (i < 0)
  {
    vtkErrorMacro("SetContourValue: contours are counted from 0, and this is " << i);
    return;
  }
  if (this->Contours->Set(i, value))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkHighOrderLayer::GetContourValue(int i)
{
  return this->Contours->At(i);
}

//------------------------------------------------------------------------------
void vtkHighOrderLayer::SetNumberOfContours(int number)
{
  if (this->Contours->Resize(number))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHighOrderLayer::GetNumberOfContours()
{
  return this->Contours->Size();
}

//------------------------------------------------------------------------------
void vtkHighOrderLayer::GenerateContourValues(int number, double lower, double upper)
{
  if (this->Contours->Generate(number, lower, upper))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHighOrderLayer::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->CutFunction != nullptr)
  {
    time = std::max(time, this->CutFunction->GetMTime());
  }
  if (this->Surface != nullptr)
  {
    time = std::max(time, this->Surface->GetMTime());
  }
  return this->LookupTable != nullptr ? std::max(time, this->LookupTable->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkHighOrderLayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CutFunction: "
     << (this->CutFunction != nullptr ? this->CutFunction->GetClassName() : "(none)") << "\n";
  os << indent
     << "Surface: " << (this->Surface != nullptr ? this->Surface->GetClassName() : "(none)")
     << "\n";
  os << indent << "FieldName: " << (this->FieldName.empty() ? "(the mapper's)" : this->FieldName)
     << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "LookupTable: "
     << (this->LookupTable != nullptr ? this->LookupTable->GetClassName() : "(the mapper's)")
     << "\n";
  os << indent << "ScalarVisibility: " << (this->ScalarVisibility ? "on" : "off") << "\n";
  os << indent << "Color: " << this->Color[0] << ", " << this->Color[1] << ", " << this->Color[2]
     << "\n";
  os << indent << "ContourVisibility: " << (this->ContourVisibility ? "on" : "off") << "\n";
  os << indent << "Contours: " << this->GetNumberOfContours() << "\n";
  os << indent << "ContourCount: " << this->ContourCount << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "SinglePrecision: " << (this->SinglePrecision ? "on" : "off") << "\n";
  os << indent << "Lighting: " << (this->Lighting ? "on" : "off") << "\n";
  os << indent << "LightFlat: " << (this->LightFlat ? "on" : "off") << "\n";
  os << indent << "Visibility: " << (this->Visibility ? "on" : "off") << "\n";
}
