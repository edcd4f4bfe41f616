// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderIntegrate.h"

#include "FieldsNamed.h"
#include "FilterWork.h"
#include "HighOrderModel.h"
#include "IntegralRows.h"
#include "ModelSource.h"
#include "VtkCutFunction.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include "vtkDoubleArray.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkHighOrderIntegrate);

namespace
{
using namespace pixelexact;

/// Null where the grid has none and none was named.
const Field* FieldIn(const HighOrderModel& model, const std::string& name)
{
  if (!name.empty())
  {
    return &FieldNamed(model, name);
  }
  return model.Fields().empty() ? nullptr : &model.Fields().front();
}

void ToTable(const std::vector<IntegralRow>& rows, vtkTable* table)
{
  vtkNew<vtkStringArray> names;
  names->SetName("Quantity");
  table->AddColumn(names);
  const auto add = [table](const char* name)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
    return column.Get();
  };
  vtkDoubleArray* const value = add("Value");
  vtkDoubleArray* const error = add("ErrorBound");
  vtkDoubleArray* const lower = add("Lower");
  vtkDoubleArray* const upper = add("Upper");
  for (const IntegralRow& row : rows)
  {
    names->InsertNextValue(row.quantity);
    value->InsertNextValue(row.Middle());
    error->InsertNextValue(row.Error());
    lower->InsertNextValue(row.value.lower);
    upper->InsertNextValue(row.value.upper);
  }
}
} // namespace

vtkHighOrderIntegrate::vtkHighOrderIntegrate()
  : Source(std::make_unique<ModelSource>())
{
}

vtkHighOrderIntegrate::~vtkHighOrderIntegrate() = default;

void vtkHighOrderIntegrate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "CutFunction: " << (this->CutFunction ? this->CutFunction->GetClassName() : "(none)")
     << "\n";
  os << indent << "BoundaryAttributes:";
  for (const std::int32_t attribute : this->Attributes)
  {
    os << " " << attribute;
  }
  os << "\n" << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
  os << indent << "ToleranceMet: " << this->ToleranceMet << "\n";
  os << indent << "UnresolvedArea: " << this->UnresolvedArea << "\n";
}

vtkMTimeType vtkHighOrderIntegrate::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->CutFunction ? std::max(own, this->CutFunction->GetMTime()) : own;
}

void vtkHighOrderIntegrate::SetCutFunction(vtkImplicitFunction* function)
{
  vtkSetSmartPointerBodyMacro(CutFunction, vtkImplicitFunction, function);
}

vtkImplicitFunction* vtkHighOrderIntegrate::GetCutFunction()
{
  return this->CutFunction;
}

void vtkHighOrderIntegrate::AddBoundaryAttribute(int attribute)
{
  this->Attributes.push_back(attribute);
  this->Modified();
}

void vtkHighOrderIntegrate::ClearBoundaryAttributes()
{
  if (!this->Attributes.empty())
  {
    this->Attributes.clear();
    this->Modified();
  }
}

int vtkHighOrderIntegrate::GetNumberOfBoundaryAttributes()
{
  return static_cast<int>(this->Attributes.size());
}

int vtkHighOrderIntegrate::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  TakeGrids(info);
  return 1;
}

int vtkHighOrderIntegrate::RequestUpdateExtent(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* /*outputVector*/)
{
  AskForWhole(inputVector[0]);
  return 1;
}

void vtkHighOrderIntegrate::Integrate(vtkDataObject* grid, vtkTable* output)
{
  if (this->CutFunction && !this->Attributes.empty())
  {
    throw InvalidData("there are a cut function and attributes of the boundary; integrate over one "
                      "of them at a time.");
  }
  const auto model = this->Source->Get(grid, this);
  IntegralQuestion question{ model->GetMesh(), FieldIn(*model, ChosenName(this, this->FieldName)),
    nullptr };
  const IntegralEffort effort{ this->Tolerance,
    this->Seconds != 0.0 ? this->Seconds : std::numeric_limits<double>::infinity() };
  this->UpdateProgress(0.2);
  SurfaceIntegral found;
  if (this->CutFunction)
  {
    const Box3 box = model->GetLocator().Bounds();
    const double extent = glm::length(box.upper - box.lower);
    const auto cut = MakeCutFunction(this->CutFunction, extent > 0.0 ? extent : 1.0);
    question.cut = cut->Quadric();
    if (question.cut == nullptr)
    {
      throw Unsupported(std::string(this->CutFunction->GetClassName()) +
        ": integrals are taken over planes, spheres, cylinders, cones and quadrics.");
    }
    found = IntegrateCut(question, model->GetLocator(), model->Faces(), effort);
  }
  else
  {
    found = IntegrateFaces(question, BoundaryOf(*model, this->Attributes), effort);
  }
  this->UpdateProgress(0.9);
  ToTable(RowsOf(question, found), output);
  this->ToleranceMet = found.met;
  this->UnresolvedArea = found.unresolved;
  std::string doubts;
  for (const std::string& doubt : DoubtsOf(found, this->Tolerance))
  {
    doubts += doubt + "\n";
  }
  if (!doubts.empty())
  {
    vtkWarningMacro(<< doubts);
  }
}

int vtkHighOrderIntegrate::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkTable::GetData(outputVector);
  this->ToleranceMet = false;
  this->UnresolvedArea = 0.0;
  return FillOutput(this, output,
    [&]
    {
      this->Integrate(vtkDataObject::GetData(inputVector[0]), output);
      return true;
    });
}
