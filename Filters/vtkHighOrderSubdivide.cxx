// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderSubdivide.h"

#include "Cells/CellArrays.h"
#include "Cells/Subdivision.h"
#include "Conversion/ModelSource.h"
#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Grids/FieldsNamed.h"
#include "Grids/FilterWork.h"
#include "Grids/FreeMemory.h"
#include "Parts/ParallelRun.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHighOrderSubdivide);

namespace
{
using namespace pixelexact;

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
  : Source(std::make_unique<ModelSource>())
{
}

vtkHighOrderSubdivide::~vtkHighOrderSubdivide() = default;

void vtkHighOrderSubdivide::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfCoarseElements: " << this->NumberOfCoarseElements << "\n";
  PrintFields(os, indent, this->Fields);
}

void vtkHighOrderSubdivide::AddField(const std::string& name)
{
  this->Fields.push_back(name);
  this->Modified();
}

void vtkHighOrderSubdivide::ClearFields()
{
  this->Fields.clear();
  this->Modified();
}

int vtkHighOrderSubdivide::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  TakeGrids(info);
  return 1;
}

bool vtkHighOrderSubdivide::Fill(vtkDataObject* input, vtkUnstructuredGrid* output)
{
  const auto model = this->Source->Get(input, this);
  const std::vector<const Field*> fields = FieldsNamed(*model, this->Fields);
  const SubdivisionLevels levels = this->Tolerance > 0.0
    ? AdaptedLevels(*model, fields, this->Tolerance, this->Level, ProgressOf(this, 0.0, 0.5))
    : UniformLevels(*model, this->Level);
  if (levels.aborted)
  {
    return false;
  }
  this->NumberOfCoarseElements = levels.coarse;
  vtkDataObject* grid = this->Source->GridOf(input);
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

int vtkHighOrderSubdivide::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  this->NumberOfCoarseElements = 0;
  return FillOutput(this, output,
    [&]
    {
      return !HasNoShare(inputVector[0]) &&
        this->Fill(vtkDataObject::GetData(inputVector[0]), output);
    });
}
