// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/GridConversion.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/GeometryConversion.h"
#include "Conversion/MeshDiagnostics.h"
#include "Conversion/SourceArrays.h"
#include "ConversionLoss.h"
#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Shape/ShapeFace.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkIntArray.h"
#include "vtkQuadratureSchemeDefinition.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace pixelexact
{
namespace
{
template <class Function>
void ForElements(int begin, int end, Function&& function)
{
  tbb::parallel_for(tbb::blocked_range<int>(begin, end, 16),
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

/// Collects the maps of a mesh during conversion. The remaining orders, and so the places of the
/// coefficients, are known only after an element is converted. Therefore elements are appended in
/// batches to an array with room for all; pages that are never written take no memory.
class MapArrays
{
public:
  explicit MapArrays(const SourceMesh& mesh)
    : Source(mesh)
  {
    std::size_t most = 0;
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      most += static_cast<std::size_t>(MostCoefficients(mesh, e));
    }
    Arrays.map.components = 3;
    Arrays.map.coefficients = CoefficientBlock(most);
  }

  MeshArrays Convert()
  {
    constexpr int kTogether = 4096;
    std::vector<ElementGeometry> geometry;
    for (int begin = 0; begin < Source.Elements(); begin += kTogether)
    {
      const int end = std::min(begin + kTogether, Source.Elements());
      geometry.resize(static_cast<std::size_t>(end - begin));
      ForElements(begin, end, [&](int e) { geometry[e - begin] = ConvertGeometry(Source, e); });
      for (int e = begin; e < end; ++e)
      {
        Place(e, geometry[e - begin]);
      }
      ForElements(begin, end,
        [&](int e) {
          std::ranges::copy(geometry[e - begin].coefficients, Arrays.map.Coefficients(e).begin());
        });
    }
    Arrays.map.coefficients.Shrink(static_cast<std::size_t>(Placed));
    return std::move(Arrays);
  }

private:
  void Place(int element, const ElementGeometry& g)
  {
    const auto [known, isNew] =
      SpaceNumbers.try_emplace(g.space, static_cast<std::int32_t>(SpaceNumbers.size()));
    if (isNew)
    {
      Arrays.map.spaces.push_back(g.space);
    }
    Arrays.map.spaceOf.push_back(known->second);
    Arrays.map.offset.push_back(Placed);
    Placed += static_cast<std::int64_t>(g.coefficients.size());
    Arrays.centre.insert(Arrays.centre.end(), g.centre.begin(), g.centre.end());
    Arrays.size.push_back(g.size);
    Arrays.uncertainty.push_back(g.uncertainty);
    Arrays.sourceCell.push_back(Source.Number(element));
  }

  const SourceMesh& Source;
  MeshArrays Arrays;
  std::map<Space, std::int32_t> SpaceNumbers;
  std::int64_t Placed = 0; ///< coefficients
};

/// The elements of a surface in space as faces with the cells' attributes, which the grid's array
/// Attribute holds.
std::vector<AttributedFace> FacesOfSurface(vtkUnstructuredGrid* grid, const SourceMesh& mesh)
{
  vtkDataArray* const attribute = grid->GetCellData()->GetArray("Attribute");
  if (attribute == nullptr || attribute->GetNumberOfComponents() != 1)
  {
    return {};
  }
  std::vector<AttributedFace> faces;
  faces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const double number = attribute->GetComponent(e, 0);
    if (number >= std::numeric_limits<int>::min() && number <= std::numeric_limits<int>::max())
    {
      faces.push_back(
        { { e, ShellFace(mesh.Basis(e).GetSpace().shape) }, static_cast<int>(number) });
    }
  }
  return faces;
}

/// Adds the mesh's coefficients to `grid`, whose cell e is element e of `mesh`.
void ConvertMesh(const SourceMesh& mesh, vtkUnstructuredGrid* grid)
{
  MeshArrays arrays = ConvertMaps(mesh);
  const bool isSurface = mesh.GetSlab() && mesh.GetSlab()->inSpace;
  arrays.boundary = isSurface ? FacesOfSurface(grid, mesh) : SourceFacesOf(grid, mesh);
  StoreMesh(grid, std::move(arrays), Origin::PointData);
  if (mesh.GetSlab())
  {
    StoreSlab(*mesh.GetSlab(), grid);
  }
}

/// Adds a field that is constant in each cell; `values` has one tuple per cell of `grid`. Returns
/// the number of elements with values that are not finite.
int ConvertCellField(const SourceMesh& mesh, vtkDataArray* values, vtkUnstructuredGrid* grid)
{
  const int components = values->GetNumberOfComponents();
  std::vector<Space> spaces;
  spaces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    spaces.push_back(UniformSpace(mesh.Basis(e).GetSpace().shape, 0));
  }
  OwnedExpansion expansion;
  expansion.Allocate(spaces, components);
  int nonFinite = 0;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    // Mode 0 is the constant 1.
    const std::span<double> out = expansion.Coefficients(e);
    values->GetTuple(e, out.data());
    nonFinite += AllFinite(out) ? 0 : 1;
  }
  StoreField(grid, values->GetName(), { std::move(expansion) }, Origin::CellData);
  return nonFinite;
}

/// Largest loss that is accepted, relative to the field's range.
constexpr double kMaxRationalLoss = 1e-9;

std::string InFewDigits(double number)
{
  std::ostringstream text;
  text.precision(2);
  text << number;
  return text.str();
}

/// The message on the rational cells and the loss of their maps.
std::string DescribeRationals(const SourceMesh& mesh)
{
  double loss = 0.0;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    loss = std::max(loss, mesh.Loss(e));
  }
  return Counted(mesh.RationalElements(), "cell") +
    " with rational weights: polynomials in place of the maps are proven to lose at most " +
    InFewDigits(loss) + ", which verdicts take into account";
}

/// Adds the message on a field's loss to `lines`. Throws Unsupported where the loss is above
/// kMaxRationalLoss.
void DescribeRationalField(
  const SourceMesh& mesh, vtkDataArray* values, std::vector<std::string>& lines)
{
  if (mesh.RationalElements() == 0)
  {
    return;
  }
  const int components = values->GetNumberOfComponents();
  const auto doubles = AsDoubles(values);
  const std::span<const double> nodal(
    doubles->GetPointer(0), static_cast<std::size_t>(doubles->GetNumberOfValues()));
  double loss = 0.0;
  double range = 0.0;
  for (int c = 0; c < components; ++c)
  {
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      loss = std::fmax(loss, mesh.Loss(e, nodal, components, c));
    }
    double ends[2];
    doubles->GetFiniteRange(ends, c);
    range = std::max(range, ends[1] - ends[0]);
  }
  const std::string name = std::string("field '") + values->GetName() + "'";
  if (loss > kMaxRationalLoss * range)
  {
    throw Unsupported(name + " loses " + InFewDigits(loss) +
      " where polynomials stand for the cells' rational functions; divide the cells, or refit them "
      "with weights that are more alike.");
  }
  lines.push_back(name +
    ": polynomials in place of rational functions are proven to lose at most " + InFewDigits(loss));
}

std::vector<std::string> DiagnoseMesh(
  const SourceMesh& mesh, const HighOrderModel& model, vtkUnstructuredGrid* grid)
{
  auto lines = DiagnoseNodes(mesh);
  const auto add = [&lines](const std::vector<std::string>& more)
  { lines.insert(lines.end(), more.begin(), more.end()); };
  // The solids beneath a surface in space may fold where the surface does not.
  if (!model.IsShell())
  {
    add(DiagnoseJacobian(model.GetMesh(), model.SourceCells(), mesh.GetSlab().has_value()));
  }
  add(DiagnoseSameCells(grid));
  for (int i = 0; i < grid->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = grid->GetFieldData()->GetAbstractArray(i);
    if (array->GetName() != nullptr && array->HasInformation() &&
      array->GetInformation()->Has(vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME()))
    {
      lines.push_back("'" + std::string(array->GetName()) +
        "' holds values at quadrature points, which are not read: vtkQuadraturePointsGenerator "
        "makes points with these values");
    }
  }
  if (mesh.SkippedSurfaces() > 0)
  {
    lines.push_back(Counted(mesh.SkippedSurfaces(), "surface element") +
      " beside the solids: left out; SetSurfaceElements (--surface-elements) reads the surfaces in "
      "place of the solids");
  }
  if (mesh.RationalElements() > 0)
  {
    lines.push_back(DescribeRationals(mesh));
  }
  return lines;
}
} // namespace

MeshArrays ConvertMaps(const SourceMesh& mesh)
{
  return MapArrays(mesh).Convert();
}

int ConvertPointField(const SourceMesh& mesh, vtkDataArray* values, vtkUnstructuredGrid* grid)
{
  const int components = values->GetNumberOfComponents();
  std::vector<Space> spaces;
  spaces.reserve(static_cast<std::size_t>(mesh.Elements()));
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    spaces.push_back(mesh.Basis(e).GetSpace());
  }
  OwnedExpansion expansion;
  expansion.Allocate(spaces, components);
  const auto doubles = AsDoubles(values);
  const std::span<const double> nodal(
    doubles->GetPointer(0), static_cast<std::size_t>(doubles->GetNumberOfValues()));
  std::atomic<int> nonFinite{ 0 };
  const std::vector<double> shifts(static_cast<std::size_t>(components));
  ForElements(0, mesh.Elements(),
    [&](int e)
    {
      thread_local std::vector<double> atNodes;
      thread_local ChangeOfBasis::Scratch scratch;
      const std::span<double> out = expansion.Coefficients(e);
      mesh.GatherAll(e, nodal, components, components, atNodes);
      mesh.Basis(e).change.Apply(atNodes, shifts, out, scratch);
      if (!AllFinite(out))
      {
        ++nonFinite;
      }
    });
  StoreField(grid, values->GetName(), { std::move(expansion) }, Origin::PointData);
  return nonFinite;
}

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
  if (OrderLostByConversion(input) >= 0)
  {
    throw StaleData(
      "the coefficients that a reader gave the grid were lost on the way" + RemedyOf(input));
  }
  const SourceMesh mesh(input, options.nodes, options.surfaces);
  ConversionReport report;
  report.skippedCells = mesh.SkippedCells();
  progress(0.1);
  CopyElements(input, mesh, output);
  if (!kept.AddTo(mesh, output))
  {
    ConvertMesh(mesh, output);
    kept.Keep(mesh, output);
  }
  output->GetFieldData()->RemoveArray(kSourceFaces);
  progress(0.5);
  const FieldArrays fields = SelectFields(output, options.fields);
  std::vector<std::string> rationals;
  for (auto* array : fields.points)
  {
    report.nonFinite[array->GetName()] = ConvertPointField(mesh, array, output);
    DescribeRationalField(mesh, array, rationals);
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
      kept.diagnostics = DiagnoseMesh(mesh, *model, output);
    }
    report.diagnostics = *kept.diagnostics;
    report.diagnostics.insert(report.diagnostics.end(), rationals.begin(), rationals.end());
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
