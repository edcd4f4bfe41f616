// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderCalculator.h"

#include "Core/Base/Error.h"
#include "Core/Expression/Expression.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

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

void AddDefinition(const std::string& name, const std::string& text, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkStringArray> definition;
  definition->SetName((kDefinitionPrefix + name).c_str());
  definition->InsertNextValue(text);
  grid->GetFieldData()->AddArray(definition);
}
} // namespace

vtkHighOrderCalculator::vtkHighOrderCalculator()
  : MeshFilter(MeshScope::PartByBlock)
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

int vtkHighOrderCalculator::DefinePhase(vtkUnstructuredGrid* grid, double degrees)
{
  constexpr std::string_view kReal = "_real";
  // Multiples of 90 degrees have no rounded sines.
  const double turn = std::remainder(degrees, 360.0);
  const bool isRight = std::fmod(turn, 90.0) == 0.0;
  const double angle = turn * std::acos(-1.0) / 180.0;
  const double cosine = isRight ? std::round(std::cos(angle)) : std::cos(angle);
  const double sine = isRight ? std::round(std::sin(angle)) : std::sin(angle);
  const std::vector<std::string> names = StoredFieldNames(grid);
  const auto isThere = [&names](const std::string& name)
  { return std::ranges::find(names, name) != names.end(); };
  int defined = 0;
  for (const std::string& real : names)
  {
    const std::string name = real.substr(0, real.size() - std::min(real.size(), kReal.size()));
    if (name.empty() || !real.ends_with(kReal) || !isThere(name + "_imag") || isThere(name) ||
      name.find('\'') != std::string::npos)
    {
      continue;
    }
    std::string text = "'";
    text.append(real).append("'*").append(NumberText(cosine)).append(" - '");
    text.append(name).append("_imag'*").append(NumberText(sine));
    AddDefinition(name, text, grid);
    ++defined;
  }
  return defined;
}

bool vtkHighOrderCalculator::Make(vtkDataObject* mesh, vtkDataObject* output)
{
  const std::string& name = this->ResultArrayName;
  const auto model = this->ModelOf(mesh);
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
  auto* grid = vtkUnstructuredGrid::SafeDownCast(output);
  grid->ShallowCopy(this->Input.GridOf(mesh));
  AddDefinition(name, this->Function, grid);
  if (this->PointValues)
  {
    const auto values = ValuesAtPoints(*model, field, grid);
    values->SetName(name.c_str());
    grid->GetPointData()->AddArray(values);
  }
  return true;
}
