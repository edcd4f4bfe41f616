// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderContourMapper.h"

#include "ContourList.h"
#include "Trace/Appearance/Appearance.h"
#include "Views/VtkColorMap.h"
#include "Views/VtkLook.h"

#include "vtkDataArray.h"

#include <array>
#include <map>
#include <set>
#include <vector>

struct vtkHighOrderContourMapper::Internals
{
  pixelexact::ContourList values;
  pixelexact::ContourList drawn;               ///< values of the last frame, with ContourCount
  std::map<int, std::array<double, 3>> colors; ///< of single contours
};

//------------------------------------------------------------------------------
vtkHighOrderContourMapper::vtkHighOrderContourMapper()
  : Contours(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkHighOrderContourMapper::~vtkHighOrderContourMapper() = default;

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::SetContourValue(int i, double value)
{
  if (i < 0)
  {
    vtkErrorMacro("SetContourValue: contours are counted from 0, and this is " << i);
    return;
  }
  if (this->Contours->values.Set(i, value))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkHighOrderContourMapper::GetContourValue(int i)
{
  return this->ShownContours().At(i);
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::SetNumberOfContours(int number)
{
  if (this->Contours->values.Resize(number))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHighOrderContourMapper::GetNumberOfContours()
{
  return this->ShownContours().Size();
}

//------------------------------------------------------------------------------
pixelexact::ContourList& vtkHighOrderContourMapper::ShownContours()
{
  return this->ContourCount > 0 ? this->Contours->drawn : this->Contours->values;
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::TakeContours(const std::vector<std::vector<double>>& drawn)
{
  std::set<double> values;
  for (const std::vector<double>& ofLayer : drawn)
  {
    values.insert(ofLayer.begin(), ofLayer.end());
  }
  this->Contours->drawn.Resize(0);
  for (const double value : values)
  {
    this->Contours->drawn.Set(this->Contours->drawn.Size(), value);
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::GenerateContourValues(int number, double lower, double upper)
{
  if (this->Contours->values.Generate(number, lower, upper))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::SetContourValues(vtkDataArray* values)
{
  const vtkIdType number = values != nullptr ? values->GetNumberOfTuples() : 0;
  this->SetNumberOfContours(static_cast<int>(number));
  for (vtkIdType i = 0; i < number; ++i)
  {
    this->SetContourValue(static_cast<int>(i), values->GetComponent(i, 0));
  }
}

//------------------------------------------------------------------------------
double* vtkHighOrderContourMapper::GetContourValues()
{
  return this->ShownContours().Data();
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::GenerateContourValues(int number, const double range[2])
{
  this->GenerateContourValues(number, range[0], range[1]);
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::SetColorOfContour(int i, double red, double green, double blue)
{
  if (i < 0)
  {
    vtkErrorMacro("SetColorOfContour: contours are counted from 0, and this is " << i);
    return;
  }
  const std::array color{ red, green, blue };
  const auto [at, isNew] = this->Contours->colors.try_emplace(i, color);
  if (isNew || at->second != color)
  {
    at->second = color;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::RemoveColorsOfContours()
{
  if (!this->Contours->colors.empty())
  {
    this->Contours->colors.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
pixelexact::ContourRule vtkHighOrderContourMapper::ContoursOfAll() const
{
  pixelexact::ContourRule contours;
  contours.count = this->ContourCount;
  contours.values = contours.count > 0 ? std::vector<double>{} : this->Contours->values.All();
  if (this->ContourScalarVisibility)
  {
    return contours;
  }
  const auto& colors = this->Contours->colors;
  const int number = contours.count > 0 ? contours.count : this->Contours->values.Size();
  contours.colors.assign(
    colors.empty() ? 1 : static_cast<std::size_t>(number), pixelexact::ToRgba(this->ContourColor));
  for (const auto& [i, color] : colors)
  {
    if (i < number)
    {
      contours.colors[static_cast<std::size_t>(i)] = pixelexact::ToRgba(color.data());
    }
  }
  return contours;
}

//------------------------------------------------------------------------------
pixelexact::ContourAppearance vtkHighOrderContourMapper::AppearanceOfContours() const
{
  pixelexact::ContourAppearance appearance;
  if (this->ContourLabels)
  {
    appearance.labels = this->ContourLabelSize;
  }
  appearance.method.interior = this->ContourInterior;
  appearance.method.SetEffort(this->ContourEffort);
  if (this->ContourSubdivisions >= 0)
  {
    appearance.method.subdivisions = this->ContourSubdivisions;
  }
  if (this->ContoursOnly)
  {
    appearance.only = pixelexact::Rgba{ 255, 255, 255, 0 };
  }
  appearance.style.width = this->ContourWidth;
  appearance.style.showUndecided = this->ShowUndecidedContours;
  appearance.style.undecided = pixelexact::ToRgba(this->UndecidedContourColor);
  return appearance;
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  if (auto* other = vtkHighOrderContourMapper::SafeDownCast(mapper))
  {
    *this->Contours = *other->Contours;
    this->SetContourCount(other->ContourCount);
    this->SetContourWidth(other->ContourWidth);
    this->SetContourColor(other->ContourColor);
    this->SetContourScalarVisibility(other->ContourScalarVisibility);
    this->SetShowUndecidedContours(other->ShowUndecidedContours);
    this->SetUndecidedContourColor(other->UndecidedContourColor);
    this->SetContourInterior(other->ContourInterior);
    this->SetContourEffort(other->ContourEffort);
    this->SetContourSubdivisions(other->ContourSubdivisions);
    this->SetContoursOnly(other->ContoursOnly);
    this->SetContourLabels(other->ContourLabels);
    this->SetContourLabelSize(other->ContourLabelSize);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderContourMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Contours: " << this->GetNumberOfContours() << "\n";
  os << indent << "ContourCount: " << this->ContourCount << "\n";
  os << indent << "ContourWidth: " << this->ContourWidth << "\n";
  os << indent << "ContourColor: " << this->ContourColor[0] << ", " << this->ContourColor[1] << ", "
     << this->ContourColor[2] << "\n";
  os << indent << "ContourScalarVisibility: " << (this->ContourScalarVisibility ? "on" : "off")
     << "\n";
  os << indent << "ShowUndecidedContours: " << (this->ShowUndecidedContours ? "on" : "off") << "\n";
  os << indent << "UndecidedContourColor: " << this->UndecidedContourColor[0] << ", "
     << this->UndecidedContourColor[1] << ", " << this->UndecidedContourColor[2] << "\n";
  os << indent << "ContourInterior: " << (this->ContourInterior ? "on" : "off") << "\n";
  os << indent << "ContourEffort: " << this->ContourEffort << "\n";
  os << indent << "ContourSubdivisions: " << this->ContourSubdivisions << "\n";
  os << indent << "ContoursOnly: " << (this->ContoursOnly ? "on" : "off") << "\n";
  os << indent << "ContourLabels: " << (this->ContourLabels ? "on" : "off") << "\n";
  os << indent << "ContourLabelSize: " << this->ContourLabelSize << "\n";
}
