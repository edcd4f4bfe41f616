// SPDX-License-Identifier: BSD-3-Clause
// What ParaView's properties set.
#include "RepresentationInternals.h"

#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTransform.h"

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  if (!visible)
  {
    this->Data->Actor->VisibilityOff(); // on again where there is something to draw
  }
  this->Data->Notes.SetVisible(visible);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetSurface(int surface)
{
  if (this->Data->Surface != surface)
  {
    this->Data->Surface = surface;
    this->MarkModified(); // processes ask each other about boundaries alone
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetCutFunction(vtkImplicitFunction* function)
{
  this->Data->Cut = function;
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::AddBoundaryAttribute(int attribute)
{
  this->Data->Boundary->AddAttribute(attribute);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::RemoveAllBoundaryAttributes()
{
  this->Data->Boundary->SelectAll();
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetIsoArray(int, int, int, int, const char* name)
{
  this->Data->Iso->SetFieldName(name);
  this->Data->Walls->SetFieldName(name);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetIsoComponent(int component)
{
  this->Data->Iso->SetComponent(component);
  this->Data->Walls->SetComponent(component);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetIsoValue(double value)
{
  this->Data->Iso->SetValue(value);
  this->Data->Walls->SetValue(value);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetJumpWalls(bool walls)
{
  this->Data->HasWalls = walls;
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetJumpWallColor(double red, double green, double blue)
{
  this->Data->WallLayer->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetSurfaceFile(const char* file)
{
  const std::string name = file != nullptr ? file : "";
  if (this->Data->SurfaceFile != name)
  {
    this->Data->SurfaceFile = name;
    this->Data->OfFile = nullptr;
    this->Data->FailedFile.reset();
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetVerdictLegend(bool show)
{
  this->Data->Notes.ShowLegend(show);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetValueUnderPointer(bool show)
{
  this->Data->Notes.ShowPointer(show);
}

//------------------------------------------------------------------------------
// Settings that the mapper takes as they are, by Rendering/Settings/generate.py.
#include "SettingForwarders.inc"

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetContourValue(int i, double value)
{
  this->Data->Mapper->SetContourValue(i, value);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetNumberOfContours(int number)
{
  const bool had = this->Data->HasLines();
  this->Data->Mapper->SetNumberOfContours(number);
  this->AskOthersAgain(had);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetContourCount(int count)
{
  const bool had = this->Data->HasLines();
  this->Data->Mapper->SetContourCount(count);
  this->AskOthersAgain(had);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::AskOthersAgain(bool hadLines)
{
  if (this->Data->HasLines() != hadLines && Internals::HasSeveralProcesses())
  {
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetEdgeVisibility(bool visible)
{
  const bool had = this->Data->HasLines();
  this->Data->Actor->GetProperty()->SetEdgeVisibility(visible);
  this->AskOthersAgain(had);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetInputArrayToProcess(
  int idx, int port, int connection, int association, const char* name)
{
  this->Superclass::SetInputArrayToProcess(idx, port, connection, association, name);
  Internals& my = *this->Data;
  my.ColorArray = name != nullptr ? name : "";
  my.ColorsCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  my.Mapper->SetFieldName(my.ColorArray.c_str());
  my.Mapper->SetScalarVisibility(!my.ColorArray.empty());
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetLookupTable(vtkScalarsToColors* table)
{
  this->Data->Mapper->SetLookupTable(table);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetMapScalars(bool map)
{
  this->Data->Mapper->SetColorMode(
    map ? VTK_COLOR_MODE_MAP_SCALARS : VTK_COLOR_MODE_DIRECT_SCALARS);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetAmbientColor(double red, double green, double blue)
{
  this->Data->Actor->GetProperty()->SetAmbientColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetDiffuseColor(double red, double green, double blue)
{
  this->Data->Actor->GetProperty()->SetDiffuseColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetSpecularColor(double red, double green, double blue)
{
  this->Data->Actor->GetProperty()->SetSpecularColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetEdgeColor(double red, double green, double blue)
{
  this->Data->Actor->GetProperty()->SetEdgeColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetAmbient(double ambient)
{
  this->Data->Actor->GetProperty()->SetAmbient(ambient);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetDiffuse(double diffuse)
{
  this->Data->Actor->GetProperty()->SetDiffuse(diffuse);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetSpecular(double specular)
{
  this->Data->Actor->GetProperty()->SetSpecular(specular);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetSpecularPower(double power)
{
  this->Data->Actor->GetProperty()->SetSpecularPower(power);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetLineWidth(double width)
{
  this->Data->Actor->GetProperty()->SetLineWidth(width);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetOpacity(double opacity)
{
  this->Data->Actor->GetProperty()->SetOpacity(opacity);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetInterpolation(int interpolation)
{
  this->Data->Actor->GetProperty()->SetInterpolation(interpolation);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetOrientation(double x, double y, double z)
{
  this->Data->Actor->SetOrientation(x, y, z);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetOrigin(double x, double y, double z)
{
  this->Data->Actor->SetOrigin(x, y, z);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetPosition(double x, double y, double z)
{
  this->Data->Actor->SetPosition(x, y, z);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetScale(double x, double y, double z)
{
  this->Data->Actor->SetScale(x, y, z);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  this->Data->Actor->SetUserTransform(transform);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetPickable(bool pickable)
{
  this->Data->Actor->SetPickable(pickable);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::AddBlockSelector(const char* selector)
{
  this->Data->Selectors.insert(selector);
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::RemoveAllBlockSelectors()
{
  this->Data->Selectors.clear();
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetBlockColor(const char*, double, double, double)
{
  this->Data->HasBlockColors = true;
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::RemoveAllBlockColors()
{
  this->Data->HasBlockColors = false;
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetBlockOpacity(const char*, double)
{
  this->Data->HasBlockOpacities = true;
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::RemoveAllBlockOpacities()
{
  this->Data->HasBlockOpacities = false;
}

//------------------------------------------------------------------------------
vtkHighOrderMapper* vtkPixelExactRepresentation::GetMapper()
{
  return this->Data->Mapper;
}

//------------------------------------------------------------------------------
vtkActor* vtkPixelExactRepresentation::GetActor()
{
  return this->Data->Actor;
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Data->Surface << "\n";
  os << indent << "Mapper:\n";
  this->Data->Mapper->PrintSelf(os, indent.GetNextIndent());
}
