// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/NodalExpression.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Expression/Expression.h"
#include "Core/Expression/PointLeaves.h"
#include "Core/Expression/Program.h"
#include "Grids/FilterWork.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkGradientFilter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <numbers>
#include <set>

namespace pixelexact
{
namespace
{
constexpr vtkIdType kPointsTogether = PointLeaves::kTogether;

bool IsDerivative(const Graph::Node& leaf)
{
  return leaf.operation == Operation::Slope || leaf.operation == Operation::Curvature;
}

/// The name in the text's language; empty for quantities at a grid's points.
std::string NameOfElementalLeaf(Operation operation)
{
  switch (operation)
  {
    case Operation::Reference:
    case Operation::InverseJacobian:
      return "xi";
    case Operation::Determinant:
      return "detJ";
    case Operation::ScaledJacobian:
      return "scaledJacobian";
    case Operation::ElementNumber:
      return "element";
    case Operation::Order:
      return "order";
    case Operation::Normal:
      return "n";
    case Operation::Behind:
      return "jump";
    default:
      return {};
  }
}

/// Derivatives of component c by x, y and z are the components 3 c, 3 c + 1 and 3 c + 2.
vtkSmartPointer<vtkDataArray> FilterGradients(
  vtkPointSet* grid, vtkDataArray* values, const char* name)
{
  const auto input = vtkSmartPointer<vtkPointSet>::Take(grid->NewInstance());
  input->CopyStructure(grid);
  input->GetPointData()->AddArray(values);
  vtkNew<vtkGradientFilter> filter;
  filter->SetInputData(input);
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, values->GetName());
  filter->SetResultArrayName(name);
  filter->Update();
  vtkSmartPointer<vtkDataArray> gradients = filter->GetOutput()->GetPointData()->GetArray(name);
  if (gradients == nullptr || gradients->GetNumberOfTuples() != grid->GetNumberOfPoints())
  {
    throw Error("VTK's Gradient filter gave no gradients");
  }
  return gradients;
}
} // namespace

NodalExpression::NodalExpression(const FieldExpression& expression)
  : Expression(expression)
{
}

bool NodalExpression::HasDerivatives() const
{
  return std::ranges::any_of(Expression.GetProgram().Leaves(),
    [](const Graph::Node& leaf)
    { return IsDerivative(leaf) || leaf.operation == Operation::InverseJacobian; });
}

void NodalExpression::RequireNodal() const
{
  for (const Graph::Node& leaf : Expression.GetProgram().Leaves())
  {
    if (const std::string name = NameOfElementalLeaf(leaf.operation); !name.empty())
    {
      throw Unsupported("VTK's Gradient filter and Calculator have no '" + name + "'");
    }
  }
}

std::vector<std::string> NodalExpression::FieldNames() const
{
  std::set<std::string> names;
  for (const Graph::Node& leaf : Expression.GetProgram().Leaves())
  {
    if (leaf.operation == Operation::Value || IsDerivative(leaf))
    {
      names.insert(Expression.GetFields()[static_cast<std::size_t>(leaf.field)]->name);
    }
  }
  return { names.begin(), names.end() };
}

/// The field's component that a leaf is, or is a derivative of.
NodalExpression::Column NodalExpression::ValueOf(vtkPointSet* grid, const Graph::Node& leaf) const
{
  const std::string& name = Expression.GetFields()[static_cast<std::size_t>(leaf.field)]->name;
  vtkDataArray* const array = grid->GetPointData()->GetArray(name.c_str());
  if (array == nullptr || array->GetNumberOfComponents() <= leaf.component)
  {
    throw Error("the grid's points have no values of '" + name + "'");
  }
  return { array, leaf.component };
}

NodalExpression::Differentiated NodalExpression::Differentiate(vtkPointSet* grid) const
{
  Differentiated derivatives;
  bool twice = false;
  for (const Graph::Node& leaf : Expression.GetProgram().Leaves())
  {
    if (!IsDerivative(leaf))
    {
      continue;
    }
    twice = twice || leaf.operation == Operation::Curvature;
    const Column column = ValueOf(grid, leaf);
    if (std::ranges::find(derivatives.columns, column) == derivatives.columns.end())
    {
      derivatives.columns.push_back(column);
    }
  }
  const auto columns = static_cast<int>(derivatives.columns.size());
  if (columns == 0)
  {
    return derivatives;
  }
  const vtkIdType points = grid->GetNumberOfPoints();
  RequireMemory(8.0 * (twice ? 13.0 : 4.0) * columns * static_cast<double>(points),
    "derivatives at " + Counted(points, "point"), "lower the level");
  // One array for all expressions, so that the filter visits each cell once.
  vtkNew<vtkDoubleArray> values;
  values->SetName("PixelExact.Values");
  values->SetNumberOfComponents(columns);
  values->SetNumberOfTuples(points);
  for (int c = 0; c < columns; ++c)
  {
    const Column& column = derivatives.columns[static_cast<std::size_t>(c)];
    values->CopyComponent(c, column.array, column.component);
  }
  derivatives.first = FilterGradients(grid, values, "PixelExact.First");
  if (twice)
  {
    derivatives.second = FilterGradients(grid, derivatives.first, "PixelExact.Second");
  }
  return derivatives;
}

NodalExpression::Column NodalExpression::ColumnOf(
  vtkPointSet* grid, const Differentiated& derivatives, const Graph::Node& leaf) const
{
  switch (leaf.operation)
  {
    case Operation::Pi:
      return {};
    case Operation::Coordinate:
      return { grid->GetPoints()->GetData(), leaf.a };
    case Operation::Value:
      return ValueOf(grid, leaf);
    default:
      break;
  }
  const auto found = std::ranges::find(derivatives.columns, ValueOf(grid, leaf));
  const int slope = 3 * static_cast<int>(found - derivatives.columns.begin()) + leaf.a;
  return leaf.operation == Operation::Slope ? Column{ derivatives.first, slope }
                                            : Column{ derivatives.second, 3 * slope + leaf.b };
}

vtkSmartPointer<vtkDoubleArray> NodalExpression::Compute(vtkPointSet* grid) const
{
  RequireNodal();
  const Differentiated derivatives = Differentiate(grid);
  const Program& program = Expression.GetProgram();
  std::vector<Column> columns;
  for (const Graph::Node& leaf : program.Leaves())
  {
    columns.push_back(ColumnOf(grid, derivatives, leaf));
  }
  const auto components = static_cast<std::size_t>(Expression.Components());
  auto result = vtkSmartPointer<vtkDoubleArray>::New();
  result->SetNumberOfComponents(Expression.Components());
  result->SetNumberOfTuples(grid->GetNumberOfPoints());
  const auto computeBlock = [&](vtkIdType begin, vtkIdType end)
  {
    constexpr auto kRow = static_cast<std::size_t>(kPointsTogether);
    std::vector<double> storage((columns.size() + components) * kRow);
    std::vector<const double*> leaves;
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
      const auto& [array, component] = columns[k];
      double* const leaf = &storage[k * kRow];
      for (vtkIdType i = begin; i < end; ++i)
      {
        leaf[i - begin] = array != nullptr ? array->GetComponent(i, component) : std::numbers::pi;
      }
      leaves.push_back(leaf);
    }
    std::vector<double*> out;
    for (std::size_t c = 0; c < components; ++c)
    {
      out.push_back(&storage[(columns.size() + c) * kRow]);
    }
    std::vector<double> registers;
    program.Run(leaves, static_cast<int>(end - begin), out.data(), registers);
    for (vtkIdType i = begin; i < end; ++i)
    {
      for (std::size_t c = 0; c < components; ++c)
      {
        result->SetTypedComponent(i, static_cast<int>(c), out[c][i - begin]);
      }
    }
  };
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, grid->GetNumberOfPoints(), kPointsTogether),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      for (vtkIdType begin = range.begin(); begin < range.end(); begin += kPointsTogether)
      {
        computeBlock(begin, std::min(range.end(), begin + kPointsTogether));
      }
    });
  return result;
}
} // namespace pixelexact
