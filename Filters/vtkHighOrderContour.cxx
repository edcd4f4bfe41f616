// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderContour.h"

#include "ContourList.h"
#include "Conversion/ModelSource.h"
#include "Core/Contour/RoundValues.h"
#include "Core/Contour/SurfaceAbilities.h"
#include "Cuts/ContourPolyData.h"
#include "Cuts/VtkCutFunction.h"
#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include "vtkImplicitFunction.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderContour);

namespace
{
using namespace pixelexact;

const Field& FieldIn(const HighOrderModel& model, const std::string& name)
{
  if (model.Fields().empty())
  {
    throw InvalidData("the grid carries no high-order field; there is nothing to contour.");
  }
  return name.empty() ? model.Fields().front() : model.GetField(name);
}

void RequireComponent(const Field& field, int component)
{
  const int components = field.values.components;
  if (component < -1 || component >= components)
  {
    throw InvalidData("component " + std::to_string(component) + " of field '" + field.name +
      "', which has " + std::to_string(components) + ", counted from 0; -1 is the magnitude.");
  }
}
} // namespace

vtkHighOrderContour::vtkHighOrderContour()
  : MeshFilter(MeshScope::WholeOnFirst)
  , Values(std::make_unique<ContourList>())
{
}

vtkHighOrderContour::~vtkHighOrderContour() = default;

void vtkHighOrderContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "CutFunction: " << (this->CutFunction ? this->CutFunction->GetClassName() : "(none)")
     << "\n";
  os << indent << "Values:";
  for (const double value : this->Values->All())
  {
    os << " " << value;
  }
  os << "\n" << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfUncertifiedLines: " << this->NumberOfUncertifiedLines << "\n";
  os << indent << "NumberOfUndecidedElements: " << this->NumberOfUndecidedElements << "\n";
}

vtkMTimeType vtkHighOrderContour::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->CutFunction ? std::max(own, this->CutFunction->GetMTime()) : own;
}

void vtkHighOrderContour::SetCutFunction(vtkImplicitFunction* function)
{
  vtkSetSmartPointerBodyMacro(CutFunction, vtkImplicitFunction, function);
}

vtkImplicitFunction* vtkHighOrderContour::GetCutFunction()
{
  return this->CutFunction;
}

std::string vtkHighOrderContour::DescribeSurfaces()
{
  return DescribeSurfacesWith(SurfaceUse::Lines);
}

void vtkHighOrderContour::SetValue(int i, double value)
{
  if (i < 0)
  {
    vtkErrorMacro("SetValue: values are counted from 0, and " << i << " was given.");
    return;
  }
  if (this->Values->Set(i, value))
  {
    this->Modified();
  }
}

double vtkHighOrderContour::GetValue(int i)
{
  if (i < 0 || i >= this->Values->Size())
  {
    vtkErrorMacro("GetValue: there are " << this->Values->Size() << " values, counted from 0, and "
                                         << i << " was asked for.");
    return 0.0;
  }
  return this->Values->At(i);
}

double* vtkHighOrderContour::GetValues()
{
  return this->Values->Data();
}

void vtkHighOrderContour::GetValues(double* values)
{
  std::copy_n(this->Values->Data(), this->Values->Size(), values);
}

void vtkHighOrderContour::SetNumberOfContours(int number)
{
  if (this->Values->Resize(number))
  {
    this->Modified();
  }
}

vtkIdType vtkHighOrderContour::GetNumberOfContours()
{
  return this->Values->Size();
}

void vtkHighOrderContour::GenerateValues(int number, double range[2])
{
  this->GenerateValues(number, range[0], range[1]);
}

void vtkHighOrderContour::GenerateValues(int number, double rangeStart, double rangeEnd)
{
  if (this->Values->Generate(number, rangeStart, rangeEnd))
  {
    this->Modified();
  }
}

void vtkHighOrderContour::GenerateRoundValues(int number, double rangeStart, double rangeEnd)
{
  const std::vector<double> values = RoundValues(number, { rangeStart, rangeEnd });
  if (static_cast<int>(values.size()) != number)
  {
    vtkErrorMacro("GenerateRoundValues: there are no " << number << " round values between "
                                                       << rangeStart << " and " << rangeEnd
                                                       << "; give a range that ascends.");
    return;
  }
  this->SetNumberOfContours(number);
  for (int i = 0; i < number; ++i)
  {
    this->SetValue(i, values[static_cast<std::size_t>(i)]);
  }
}

void vtkHighOrderContour::ResetReport()
{
  this->NumberOfUncertifiedLines = 0;
  this->NumberOfUndecidedElements = 0;
  this->ReportText.clear();
}

bool vtkHighOrderContour::Make(vtkDataObject* mesh, vtkPolyData* output)
{
  if (!this->CutFunction)
  {
    throw InvalidData("there is no cut function; give one with SetCutFunction.");
  }
  const auto model = this->ModelOf(mesh);
  model->RequireSolids("contour lines on a cut");
  const std::string name = ChosenName(this, this->FieldName);
  const Field& field = FieldIn(*model, name);
  RequireComponent(field, this->Component);
  const Box3 box = model->GetLocator().Bounds();
  const double extent = glm::length(box.upper - box.lower);
  const double diagonal = extent > 0.0 ? extent : 1.0; // a grid may be empty
  const std::vector<SurfacePatch> patches = PatchesOf(this->CutFunction);
  ContourRequest options{ this->Values->All(), this->Tolerance };
  if (options.tolerance == 0.0)
  {
    options.tolerance = 1e-4 * diagonal;
  }
  this->UpdateProgress(0.2);
  ContourQuestion question{ model->GetMesh(), &field, this->Component };
  ContourSet set;
  if (patches.empty())
  {
    const auto cut = MakeCutFunction(this->CutFunction, diagonal);
    question.cut = cut.get();
    set = TraceContours(question, model->GetLocator(), model->Faces(), options);
  }
  else
  {
    set = TraceContours(question, patches, model->GetLocator(), model->Faces(), options);
  }
  this->UpdateProgress(0.9);
  ToPolyData(set, *model, field.name.empty() ? "Value" : field.name, options.values, output);
  this->NumberOfUncertifiedLines = set.report.uncertified;
  this->NumberOfUndecidedElements = set.report.undecided;
  this->ReportText = DescribeContours(set);
  if (patches.empty())
  {
    this->ReportText +=
      std::string(this->CutFunction->GetClassName()) + " is searched by samples: not certified\n";
  }
  const std::string doubts = DescribeDoubts(set.report);
  if (!doubts.empty())
  {
    vtkWarningMacro(<< doubts);
  }
  return true;
}
