// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Subdivision.h"

#include "Cells/LinearCell.h"
#include "Cells/ShapeLattice.h"
#include "Core/Location/Locator.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

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

/// First point, cell and corner of each element.
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
/// The sum of the cells' volumes for lattice points at `xyz`.
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

/// Points of a lattice at which linear cells are compared with the element: the mean in xi of the
/// lattice points in `of`.
struct Middles
{
  std::vector<Vec3> xi;
  std::vector<std::vector<int>> of;
};

Middles MakeMiddles(const ShapeLattice& lattice)
{
  Middles middles;
  const auto add = [&](std::vector<int> corners)
  {
    Vec3 sum(0.0);
    for (const int corner : corners)
    {
      sum += lattice.points[static_cast<std::size_t>(corner)];
    }
    middles.xi.push_back(sum / static_cast<double>(corners.size()));
    middles.of.push_back(std::move(corners));
  };
  for (std::size_t cell = 0; cell < lattice.Cells(); ++cell)
  {
    const std::span<const int> corners = lattice.Corners(cell);
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      add({ corners[k], corners[(k + 1) % corners.size()] });
    }
    const std::size_t base = lattice.types[cell] == VTK_PYRAMID ? 4 : corners.size();
    add({ corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(base) });
  }
  return middles;
}

const Middles& MiddlesOf(Shape shape, int level)
{
  static PerLevel<Middles> all;
  return all.Get(shape, level, [&] { return MakeMiddles(LatticeOf(shape, level)); });
}

/// The largest distance of values at middles from the means of the values at their corners.
double LargestMiss(const Mesh& mesh, const Field* field, int element, int level)
{
  const Shape shape = mesh.ShapeOf(element);
  const Middles& middles = MiddlesOf(shape, level);
  const int components = field != nullptr ? field->values.components : 3;
  const auto n = static_cast<std::size_t>(components);
  const auto corners = ValuesAt(mesh, field, element, LatticeOf(shape, level).points, components);
  const auto exact = ValuesAt(mesh, field, element, middles.xi, components);
  double largest = 0.0;
  for (std::size_t m = 0; m < middles.of.size(); ++m)
  {
    for (std::size_t c = 0; c < n; ++c)
    {
      double sum = 0.0;
      for (const int corner : middles.of[m])
      {
        sum += corners[static_cast<std::size_t>(corner) * n + c];
      }
      const double miss =
        std::fabs(exact[m * n + c] - sum / static_cast<double>(middles.of[m].size()));
      // Keeps NaN, so that the tolerance counts as missed.
      largest = miss <= largest ? largest : miss;
    }
  }
  return largest;
}

/// The widest range of a component, over the nodes of level 1 of all elements.
double RangeOf(const Mesh& mesh, const Field& field)
{
  const auto n = static_cast<std::size_t>(field.values.components);
  std::vector<double> lower(n, std::numeric_limits<double>::infinity());
  std::vector<double> upper(n, -std::numeric_limits<double>::infinity());
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const auto& points = LatticeOf(mesh.ShapeOf(e), 1).points;
    const auto values = ValuesAt(mesh, &field, e, points, field.values.components);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      lower[i % n] = std::min(lower[i % n], values[i]);
      upper[i % n] = std::max(upper[i % n], values[i]);
    }
  }
  double widest = 0.0;
  for (std::size_t c = 0; c < n; ++c)
  {
    widest = std::max(widest, upper[c] - lower[c]);
  }
  return widest;
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

SubdivisionLevels UniformLevels(const HighOrderModel& model, int level)
{
  return { std::vector<std::uint8_t>(static_cast<std::size_t>(model.GetMesh().Elements()),
             static_cast<std::uint8_t>(level)),
    0, false };
}

SubdivisionLevels AdaptedLevels(const HighOrderModel& model,
  const std::vector<const Field*>& fields, double tolerance, int most, const StepProgress& progress)
{
  const Mesh& mesh = model.GetMesh();
  const Box3& box = model.GetLocator().Bounds();
  const double length = tolerance * glm::length(box.upper - box.lower);
  std::vector<double> allowed(fields.size());
  std::ranges::transform(
    fields, allowed.begin(), [&](const Field* field) { return tolerance * RangeOf(mesh, *field); });
  SubdivisionLevels levels = UniformLevels(model, most);
  std::atomic<std::int64_t> coarse{ 0 };
  const auto isFine = [&](int element, int level)
  {
    if (!(LargestMiss(mesh, nullptr, element, level) <= length))
    {
      return false;
    }
    for (std::size_t f = 0; f < fields.size(); ++f)
    {
      if (!(LargestMiss(mesh, fields[f], element, level) <= allowed[f]))
      {
        return false;
      }
    }
    return true;
  };
  levels.aborted = !ParallelSteps(levels.ofElement.size(), progress,
    [&](std::size_t e)
    {
      int level = 0;
      while (level < most && !isFine(static_cast<int>(e), level))
      {
        ++level;
      }
      levels.ofElement[e] = static_cast<std::uint8_t>(level);
      if (level == most && !isFine(static_cast<int>(e), level))
      {
        ++coarse;
      }
    });
  levels.coarse = coarse;
  return levels;
}
} // namespace pixelexact
