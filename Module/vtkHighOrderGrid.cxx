// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderGrid.h"

#include "CompositeParts.h"
#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderGrid);

namespace
{
using namespace pixelexact;

void OrderRange(const Expansion& expansion, int range[2])
{
  range[0] = 0;
  range[1] = -1;
  for (int e = 0; e < expansion.Elements(); ++e)
  {
    const auto& order = expansion.SpaceOf(e).order;
    const auto [low, high] = std::ranges::minmax(order);
    range[0] = e == 0 ? low : std::min<int>(range[0], low);
    range[1] = std::max<int>(range[1], high);
  }
}

int RequireElement(const HighOrderModel& model, vtkIdType element)
{
  if (element < 0 || element >= model.GetMesh().Elements())
  {
    throw InvalidData("there is no element " + std::to_string(element) + "; the grid has " +
      std::to_string(model.GetMesh().Elements()) + ", numbered from 0.");
  }
  return static_cast<int>(element);
}
} // namespace

vtkHighOrderGrid::vtkHighOrderGrid() = default;
vtkHighOrderGrid::~vtkHighOrderGrid() = default;

void vtkHighOrderGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "High-order fields:";
  for (const auto& name : StoredFieldNames(this))
  {
    os << " " << name;
  }
  os << "\n";
}

std::shared_ptr<HighOrderModel> vtkHighOrderGrid::GetModel()
{
  if (!this->Model || !this->Model->IsCurrent(this))
  {
    // The old model stays alive until the new one exists, which may share its locator, but not
    // after a failure.
    const auto stale = std::move(this->Model);
    this->Model = HighOrderModel::From(this);
  }
  return this->Model;
}

bool vtkHighOrderGrid::IsHighOrder(vtkUnstructuredGrid* grid)
{
  return HasHighOrderArrays(grid);
}

bool vtkHighOrderGrid::IsSurfaceInSpace(vtkDataObject* data)
{
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    try
    {
      const auto parts = PartsOf(composite);
      return !parts.empty() && IsShell(parts.front().grid);
    }
    catch (const Error&)
    {
      return false; // of what is no grid
    }
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(data);
  return grid != nullptr && IsShell(grid);
}

std::string vtkHighOrderGrid::CheckCoefficients(vtkUnstructuredGrid* grid)
{
  if (!grid)
  {
    return "there is no grid.";
  }
  try
  {
    HighOrderModel::From(grid);
    return {};
  }
  catch (const Error& error)
  {
    return error.what();
  }
}

int vtkHighOrderGrid::GetNumberOfHighOrderFields()
{
  try
  {
    return static_cast<int>(this->GetModel()->Fields().size());
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

std::string vtkHighOrderGrid::GetHighOrderFieldName(int index)
{
  try
  {
    const auto model = this->GetModel();
    const auto fields = model->Fields();
    if (index < 0 || index >= static_cast<int>(fields.size()))
    {
      throw InvalidData("there is no high-order field number " + std::to_string(index) +
        "; the grid has " + std::to_string(fields.size()) + ".");
    }
    return fields[index].name;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return {};
  }
}

int vtkHighOrderGrid::GetHighOrderFieldComponents(const std::string& name)
{
  try
  {
    return this->GetModel()->GetField(name).values.components;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkHighOrderGrid::GetGeometryOrderRange(int range[2])
{
  range[0] = 0;
  range[1] = -1;
  try
  {
    OrderRange(this->GetModel()->GetMesh().map, range);
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

void vtkHighOrderGrid::GetFieldOrderRange(const std::string& name, int range[2])
{
  range[0] = 0;
  range[1] = -1;
  try
  {
    OrderRange(this->GetModel()->GetField(name).values, range);
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

bool vtkHighOrderGrid::MapForward(vtkIdType element, const double xi[3], double x[3])
{
  try
  {
    const auto model = this->GetModel();
    const Vec3 at(xi[0], xi[1], xi[2]);
    Vec3 world;
    pixelexact::MapForward(
      model->GetMesh(), RequireElement(*model, element), { &at, 1 }, { &world, 1 });
    for (int d = 0; d < 3; ++d)
    {
      x[d] = world[d];
    }
    return true;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

bool vtkHighOrderGrid::EvaluateField(
  const std::string& name, vtkIdType element, const double xi[3], vtkDoubleArray* values)
{
  try
  {
    const auto model = this->GetModel();
    const Field& field = model->GetField(name);
    const int e = RequireElement(*model, element);
    values->SetNumberOfComponents(field.values.components);
    values->SetNumberOfTuples(1);
    const Vec3 at(xi[0], xi[1], xi[2]);
    EvaluateAt(model->GetMesh(), field, e, { &at, 1 },
      { values->GetPointer(0), static_cast<std::size_t>(field.values.components) }, {});
    values->Modified();
    return true;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}
