// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderSubdivide.h"

#include "Cells/Subdivision.h"
#include "CompositeParts.h"
#include "ConversionLoss.h"
#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Grids/FilterInput.h"
#include "Grids/FilterWork.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHighOrderSubdivide);

namespace
{
using namespace pixelexact;

std::vector<vtkUnstructuredGrid*> GridsOf(vtkDataObject* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return { grid };
  }
  std::vector<vtkUnstructuredGrid*> grids;
  for (const CompositePart& part : PartsOf(vtkCompositeDataSet::SafeDownCast(data)))
  {
    grids.push_back(part.grid);
  }
  return grids;
}

/// The arrays with this name, one of each grid; empty where a grid lacks it or has another kind.
std::vector<vtkAbstractArray*> AlikeOf(
  const std::vector<vtkUnstructuredGrid*>& grids, const char* name)
{
  std::vector<vtkAbstractArray*> arrays;
  for (vtkUnstructuredGrid* grid : grids)
  {
    vtkAbstractArray* array = grid->GetCellData()->GetAbstractArray(name);
    if (array == nullptr ||
      array->GetDataType() != grids[0]->GetCellData()->GetAbstractArray(name)->GetDataType() ||
      array->GetNumberOfComponents() !=
        grids[0]->GetCellData()->GetAbstractArray(name)->GetNumberOfComponents())
    {
      return {};
    }
    arrays.push_back(array);
  }
  return arrays;
}

/// Gives the cells of `output` the cell arrays of a model's grid, or of composite data those that
/// all its leaves have alike: cell i those of the cell of element elementOf[i]. PixelExact's own
/// are left out, and those whose name the output has. Also the grid's field data, without
/// PixelExact's.
void SpreadCellArrays(vtkDataObject* grid, const HighOrderModel& model,
  std::span<const int> elementOf, vtkUnstructuredGrid* output)
{
  const std::vector<vtkUnstructuredGrid*> grids = GridsOf(grid);
  if (grids.empty())
  {
    return;
  }
  std::vector<std::int64_t> begins;
  for (const HighOrderModel::Block& block : model.Blocks())
  {
    begins.push_back(block.begin);
  }
  begins.resize(std::max<std::size_t>(begins.size(), 1));
  vtkCellData* first = grids[0]->GetCellData();
  for (int a = 0; a < first->GetNumberOfArrays(); ++a)
  {
    const char* name = first->GetArrayName(a);
    if (name == nullptr || std::strcmp(name, kElementIds) == 0 ||
      std::strcmp(name, kLinearizedOrder) == 0 || output->GetCellData()->HasArray(name) != 0)
    {
      continue;
    }
    const std::vector<vtkAbstractArray*> from = AlikeOf(grids, name);
    if (from.empty())
    {
      continue;
    }
    const auto to = vtkSmartPointer<vtkAbstractArray>::Take(from[0]->NewInstance());
    to->SetName(name);
    to->SetNumberOfComponents(from[0]->GetNumberOfComponents());
    to->CopyComponentNames(from[0]);
    to->SetNumberOfTuples(static_cast<vtkIdType>(elementOf.size()));
    for (std::size_t i = 0; i < elementOf.size(); ++i)
    {
      const auto block = static_cast<std::size_t>(
        std::upper_bound(begins.begin(), begins.end(), elementOf[i]) - begins.begin() - 1);
      to->SetTuple(static_cast<vtkIdType>(i), elementOf[i] - static_cast<vtkIdType>(begins[block]),
        from[block]);
    }
    output->GetCellData()->AddArray(to);
  }
  if (grids.size() == 1)
  {
    output->GetFieldData()->ShallowCopy(grids[0]->GetFieldData());
    RemoveHighOrderArrays(output);
  }
}

/// Approximate bytes of cell arrays per cell.
[[nodiscard]] double BytesOfCellArrays(vtkDataObject* grid)
{
  double bytes = 0.0;
  for (vtkUnstructuredGrid* one : GridsOf(grid))
  {
    double sum = 0.0;
    for (int a = 0; a < one->GetCellData()->GetNumberOfArrays(); ++a)
    {
      const vtkAbstractArray* array = one->GetCellData()->GetAbstractArray(a);
      sum += static_cast<double>(array->GetDataTypeSize()) * array->GetNumberOfComponents();
    }
    bytes = std::max(bytes, sum);
  }
  return bytes;
}

void RequireRoom(
  const SubdivisionSize& size, const std::vector<const Field*>& fields, vtkDataObject* grid)
{
  double perPoint = 3.0;
  for (const Field* field : fields)
  {
    perPoint += field->values.components;
  }
  const double bytes = 8.0 * perPoint * static_cast<double>(size.points) +
    8.0 * static_cast<double>(size.corners) +
    (21.0 + BytesOfCellArrays(grid)) * static_cast<double>(size.cells);
  RequireMemory(
    bytes, Counted(size.points, "point") + " in " + Counted(size.cells, "cell"), "lower the level");
}
} // namespace

vtkHighOrderSubdivide::vtkHighOrderSubdivide()
  : MeshFilter(MeshScope::Part)
{
}

vtkHighOrderSubdivide::~vtkHighOrderSubdivide() = default;

void vtkHighOrderSubdivide::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfCoarseElements: " << this->NumberOfCoarseElements << "\n";
  PrintFields(os, indent, this->Fields.All());
}

void vtkHighOrderSubdivide::ResetReport()
{
  this->NumberOfCoarseElements = 0;
}

bool vtkHighOrderSubdivide::Make(vtkDataObject* mesh, vtkUnstructuredGrid* output)
{
  const auto model = this->ModelOf(mesh);
  const std::vector<const Field*> fields = FieldsNamed(*model, this->Fields.All());
  const SubdivisionLevels levels = this->Tolerance > 0.0
    ? AdaptedLevels(*model, fields, this->Tolerance, this->Level, ProgressOf(this, 0.0, 0.5))
    : UniformLevels(*model, this->Level);
  if (levels.aborted)
  {
    return false;
  }
  this->NumberOfCoarseElements = levels.coarse;
  vtkDataObject* grid = this->Input.GridOf(mesh);
  RequireRoom(SizeOf(*model, levels), fields, grid);
  std::vector<int> elementOf;
  if (!Subdivide(*model, fields, levels, output, elementOf,
        ProgressOf(this, this->Tolerance > 0.0 ? 0.5 : 0.0, 1.0)))
  {
    return false;
  }
  SpreadCellArrays(grid, *model, elementOf, output);
  return true;
}
