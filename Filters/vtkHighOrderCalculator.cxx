// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderCalculator.h"

#include "Conversion/ModelSource.h"
#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"
#include "Grids/FilterWork.h"
#include "HighOrderArrays.h"
#include "Parts/ParallelRun.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderCalculator);

namespace
{
using namespace pixelexact;

/// The field's values at the grid's points.
vtkSmartPointer<vtkDoubleArray> ValuesAtPoints(
  const HighOrderModel& model, const Field& field, vtkUnstructuredGrid* grid)
{
  const vtkIdType count = grid->GetNumberOfPoints();
  std::vector<Vec3> points(static_cast<std::size_t>(count));
  for (vtkIdType p = 0; p < count; ++p)
  {
    grid->GetPoint(p, &points[static_cast<std::size_t>(p)].x);
  }
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(field.values.components);
  array->SetNumberOfTuples(count);
  SampleTarget target;
  target.value = { array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()) };
  Sample(model.GetLocator(), &field, points, target);
  return array;
}
} // namespace

vtkHighOrderCalculator::vtkHighOrderCalculator()
  : Source(std::make_unique<ModelSource>())
{
}

vtkHighOrderCalculator::~vtkHighOrderCalculator() = default;

void vtkHighOrderCalculator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ResultArrayName: " << this->ResultArrayName << "\n";
  os << indent << "Function: " << this->Function << "\n";
  os << indent << "PointValues: " << this->PointValues << "\n";
}

int vtkHighOrderCalculator::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkHighOrderCalculator::Define(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  const std::string& name = this->ResultArrayName;
  const auto model = this->Source->Get(input, this);
  if (name.empty() || this->Function.empty())
  {
    throw InvalidData(name.empty() ? "the new field has no name; set ResultArrayName."
                                   : "there is no expression; set Function.");
  }
  if (std::ranges::find(model->Fields(), name, &Field::name) != model->Fields().end() ||
    model->Definitions().contains(name))
  {
    throw InvalidData("the grid has a field '" + name + "'; choose another ResultArrayName.");
  }
  const Field& field = model->GetField(this->Function);
  output->ShallowCopy(this->Source->GridOf(input));
  vtkNew<vtkStringArray> definition;
  definition->SetName((kDefinitionPrefix + name).c_str());
  definition->InsertNextValue(this->Function);
  output->GetFieldData()->AddArray(definition);
  if (this->PointValues)
  {
    const auto values = ValuesAtPoints(*model, field, output);
    values->SetName(name.c_str());
    output->GetPointData()->AddArray(values);
  }
}

int vtkHighOrderCalculator::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  return FillOutput(this, output,
    [&]
    {
      const bool any = !HasNoShare(inputVector[0]);
      if (any)
      {
        this->Define(vtkUnstructuredGrid::GetData(inputVector[0]), output);
      }
      return any;
    });
}
