// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Subdivision.h"

#include "Cells/LevelLattice.h"
#include "Cells/LinearCell.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
vtkDoubleArray* AddDoubles(
  vtkPointData* data, const std::string& name, int components, std::int64_t tuples)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data->AddArray(array);
  return array;
}

/// Where an element's points, cells and corners begin.
std::vector<SubdivisionSize> BeginningsOf(
  const HighOrderModel& model, const SubdivisionLevels& levels)
{
  const Mesh& mesh = model.GetMesh();
  std::vector<SubdivisionSize> begins(levels.ofElement.size() + 1);
  for (std::size_t e = 0; e < levels.ofElement.size(); ++e)
  {
    const ShapeLattice& lattice = LatticeOf(mesh.ShapeOf(static_cast<int>(e)), levels.ofElement[e]);
    begins[e + 1] = { begins[e].points + static_cast<std::int64_t>(lattice.points.size()),
      begins[e].cells + static_cast<std::int64_t>(lattice.Cells()),
      begins[e].corners + static_cast<std::int64_t>(lattice.corners.size()) };
  }
  return begins;
}
/// The sum of the cells' volumes where the lattice's points are at `xyz`.
double VolumeOf(const ShapeLattice& lattice, const double* xyz)
{
  double sum = 0.0;
  std::vector<Vec3> places;
  for (std::size_t cell = 0; cell < lattice.Cells(); ++cell)
  {
    places.clear();
    for (const int corner : lattice.Corners(cell))
    {
      const double* const x = xyz + 3 * static_cast<std::ptrdiff_t>(corner);
      places.emplace_back(x[0], x[1], x[2]);
    }
    sum += pixelexact::VolumeOf(lattice.types[cell], places);
  }
  return sum;
}
} // namespace

SubdivisionSize SizeOf(const HighOrderModel& model, const SubdivisionLevels& levels)
{
  return BeginningsOf(model, levels).back();
}

bool Subdivide(const HighOrderModel& model, const std::vector<const Field*>& fields,
  const SubdivisionLevels& levels, vtkUnstructuredGrid* output, std::vector<int>& elementOf,
  const StepProgress& progress)
{
  const Mesh& mesh = model.GetMesh();
  const std::vector<SubdivisionSize> begins = BeginningsOf(model, levels);
  const SubdivisionSize& all = begins.back();

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(all.points);
  double* x = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
  std::vector<double*> values;
  values.reserve(fields.size());
  for (const Field* field : fields)
  {
    values.push_back(
      AddDoubles(output->GetPointData(), field->name, field->values.components, all.points)
        ->GetPointer(0));
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(all.cells + 1);
  offsets->SetValue(0, 0);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(all.corners);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(all.cells);
  vtkNew<vtkTypeInt64Array> source;
  source->SetName("Element");
  source->SetNumberOfValues(all.cells);
  elementOf.resize(static_cast<std::size_t>(all.cells));

  const bool done = ParallelSteps(levels.ofElement.size(), progress,
    [&](std::size_t e)
    {
      const int element = static_cast<int>(e);
      const SubdivisionSize& begin = begins[e];
      const ShapeLattice& lattice = LatticeOf(mesh.ShapeOf(element), levels.ofElement[e]);
      std::ranges::copy(ValuesAt(mesh, nullptr, element, lattice.points, 3), x + 3 * begin.points);
      for (std::size_t f = 0; f < fields.size(); ++f)
      {
        const int components = fields[f]->values.components;
        std::ranges::copy(ValuesAt(mesh, fields[f], element, lattice.points, components),
          values[f] + components * begin.points);
      }
      for (std::size_t cell = 0; cell < lattice.Cells(); ++cell)
      {
        const vtkIdType number = begin.cells + static_cast<vtkIdType>(cell);
        types->SetValue(number, lattice.types[cell]);
        offsets->SetValue(number + 1, begin.corners + lattice.offsets[cell + 1]);
        source->SetValue(number, model.SourceCells()[e]);
        elementOf[static_cast<std::size_t>(number)] = element;
      }
      vtkIdType* const own = corners->GetPointer(begin.corners);
      std::ranges::transform(lattice.corners, own,
        [&](int corner) { return static_cast<vtkIdType>(begin.points) + corner; });
      if (VolumeOf(lattice, x + 3 * begin.points) < 0.0)
      {
        for (std::size_t cell = 0; cell < lattice.Cells(); ++cell)
        {
          Mirror(std::span(own + lattice.offsets[cell], lattice.Corners(cell).size()));
        }
      }
    });
  if (!done)
  {
    return false;
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  output->SetPoints(points);
  output->SetCells(types, cells);
  output->GetCellData()->AddArray(source);
  return true;
}
} // namespace pixelexact
