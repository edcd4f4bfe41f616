// SPDX-License-Identifier: BSD-3-Clause
#include "GridConversion.h"

#include "Core/Base/Error.h"
#include "FieldSelection.h"
#include "GeometryConversion.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "KeptMesh.h"
#include "MeshDiagnostics.h"
#include "OutputGrid.h"
#include "SlabArray.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace pixelexact
{
namespace
{
template <class Function>
void ForElements(const SourceMesh& mesh, Function&& function)
{
  tbb::parallel_for(tbb::blocked_range<int>(0, mesh.Elements(), 16),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int e = range.begin(); e < range.end(); ++e)
      {
        function(e);
      }
    });
}

bool AllFinite(std::span<const double> values)
{
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

/// Adds the mesh's coefficients to `grid`, whose cell e is element e of `mesh`.
void ConvertMesh(const SourceMesh& mesh, vtkUnstructuredGrid* grid)
{
  // The orders that remain, and so the offsets, are only known after the conversion.
  std::vector<ElementGeometry> geometry(mesh.Elements());
  ForElements(mesh, [&](int e) { geometry[e] = ConvertGeometry(mesh, e); });

  MeshArrays arrays;
  std::vector<Space> spaces;
  spaces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const auto& g = geometry[e];
    spaces.push_back(g.space);
    arrays.centre.insert(arrays.centre.end(), g.centre.begin(), g.centre.end());
    arrays.size.push_back(g.size);
    arrays.uncertainty.push_back(g.uncertainty);
    arrays.sourceCell.push_back(mesh.Number(e));
  }
  arrays.map.Allocate(spaces, 3);
  ForElements(
    mesh, [&](int e) { std::ranges::copy(geometry[e].coefficients, arrays.map.Coefficients(e)); });
  StoreMesh(grid, arrays, Origin::PointData);
  if (mesh.GetSlab())
  {
    StoreSlab(*mesh.GetSlab(), grid);
  }
}

/// Adds the coefficients of a field of the grid's points, in the spaces of the cells. Returns the
/// number of elements where they are not finite, as the next function.
int ConvertPointField(const SourceMesh& mesh, vtkDataArray* values, vtkUnstructuredGrid* grid)
{
  const int components = values->GetNumberOfComponents();
  std::vector<Space> spaces;
  spaces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    spaces.push_back(mesh.Basis(e).GetSpace());
  }
  ExpansionArrays arrays;
  arrays.Allocate(spaces, components);
  const auto doubles = AsDoubles(values);
  const std::span<const double> nodal(
    doubles->GetPointer(0), static_cast<std::size_t>(doubles->GetNumberOfValues()));
  std::atomic<int> nonFinite{ 0 };
  ForElements(mesh,
    [&](int e)
    {
      const ChangeOfBasis& change = mesh.Basis(e).change;
      const auto count = static_cast<std::size_t>(spaces[e].Modes());
      const std::span<double> out(arrays.Coefficients(e), count * components);
      std::vector<double> atNodes;
      for (int c = 0; c < components; ++c)
      {
        mesh.Gather(e, nodal, components, c, atNodes);
        change.Apply(atNodes, 0.0, out.subspan(c * count, count));
      }
      nonFinite += AllFinite(out) ? 0 : 1;
    });
  StoreField(grid, values->GetName(), arrays, Origin::PointData);
  return nonFinite;
}

/// Adds a field that is constant in each cell; `values` has one tuple per cell of `grid`.
int ConvertCellField(const SourceMesh& mesh, vtkDataArray* values, vtkUnstructuredGrid* grid)
{
  const int components = values->GetNumberOfComponents();
  std::vector<Space> spaces;
  spaces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    spaces.push_back(UniformSpace(mesh.Basis(e).GetSpace().shape, 0));
  }
  ExpansionArrays arrays;
  arrays.Allocate(spaces, components);
  int nonFinite = 0;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    // The first mode is 1.
    const std::span<double> out(arrays.Coefficients(e), components);
    values->GetTuple(e, out.data());
    nonFinite += AllFinite(out) ? 0 : 1;
  }
  StoreField(grid, values->GetName(), arrays, Origin::CellData);
  return nonFinite;
}

std::vector<std::string> DiagnoseMesh(const SourceMesh& mesh, const HighOrderModel& model)
{
  auto lines = DiagnoseNodes(mesh);
  const auto more = DiagnoseJacobian(model.GetMesh(), model.SourceCells());
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}
} // namespace

ConversionReport ConvertGrid(vtkUnstructuredGrid* input, const ConversionOptions& options,
  KeptMesh& kept, vtkUnstructuredGrid* output)
{
  const auto progress = [&](double done)
  {
    if (options.progress)
    {
      options.progress(done);
    }
  };
  const SourceMesh mesh(input, options.nodes);
  ConversionReport report;
  report.skippedCells = mesh.SkippedCells();
  progress(0.1);
  CopyElements(input, mesh, output);
  if (!kept.AddTo(mesh, output))
  {
    ConvertMesh(mesh, output);
    kept.Keep(mesh, output);
  }
  progress(0.5);
  const FieldArrays fields = SelectFields(output, options.fields);
  for (auto* array : fields.points)
  {
    report.nonFinite[array->GetName()] = ConvertPointField(mesh, array, output);
  }
  for (auto* array : fields.cells)
  {
    report.nonFinite[array->GetName()] = ConvertCellField(mesh, array, output);
  }
  progress(0.9);
  const auto model = HighOrderModel::From(output); // checks what was made
  if (options.diagnose)
  {
    if (!kept.diagnostics)
    {
      kept.diagnostics = DiagnoseMesh(mesh, *model);
    }
    report.diagnostics = *kept.diagnostics;
  }
  for (const auto& [name, count] : report.nonFinite)
  {
    if (count > 0)
    {
      report.diagnostics.push_back("field '" + name + "' is NaN or infinite in " +
        std::to_string(count) + " of " + std::to_string(mesh.Elements()) +
        " elements; they are kept and shown as they are.");
    }
  }
  return report;
}
} // namespace pixelexact
