// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/ContourPolyData.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "HighOrderModel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <glm/gtc/type_ptr.hpp>

namespace pixelexact
{
namespace
{
template <class Array>
vtkNew<Array> NewArray(const std::string& name, int components, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

void AddPointArrays(
  const ContourSet& set, const HighOrderModel& model, const std::string& name, vtkPointData* data)
{
  if (name == "Element" || name == "Xi" || name == "Gradient" || name == "Block")
  {
    throw InvalidData("two arrays of the lines would be called '" + name +
      "', that of the field and what is known of their points; rename the field.");
  }
  const auto count = static_cast<vtkIdType>(set.vertices.size());
  const auto value = NewArray<vtkDoubleArray>(name, 1, count);
  const auto element = NewArray<vtkTypeInt64Array>("Element", 1, count);
  const auto xi = NewArray<vtkDoubleArray>("Xi", 3, count);
  const auto gradient = NewArray<vtkDoubleArray>("Gradient", 3, count);
  const auto block = NewArray<vtkTypeInt64Array>("Block", 1, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const ContourVertex& vertex = set.vertices[static_cast<std::size_t>(i)];
    value->SetValue(i, vertex.value);
    element->SetValue(i, model.SourceCells()[static_cast<std::size_t>(vertex.element)]);
    xi->SetTypedTuple(i, glm::value_ptr(vertex.xi));
    gradient->SetTypedTuple(i, glm::value_ptr(vertex.gradient));
    if (!model.Blocks().empty())
    {
      block->SetValue(i, HighOrderModel::BlockOf(vertex.element, model.Blocks()).flatIndex);
    }
  }
  data->SetScalars(value);
  data->AddArray(element);
  data->AddArray(xi);
  data->AddArray(gradient);
  if (!model.Blocks().empty())
  {
    data->AddArray(block);
  }
}

std::string Line(std::int64_t count, const std::string& thing, const std::string& what)
{
  return count == 0 ? std::string() : Counted(count, thing) + " " + what + "\n";
}
} // namespace

void ToPolyData(const ContourSet& set, const HighOrderModel& model, const std::string& name,
  const std::vector<double>& values, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(set.vertices.size()));
  for (std::size_t i = 0; i < set.vertices.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), glm::value_ptr(set.vertices[i].x));
  }
  const auto count = static_cast<vtkIdType>(set.lines.size());
  const auto contour = NewArray<vtkDoubleArray>("ContourValue", 1, count);
  const auto closed = NewArray<vtkUnsignedCharArray>("Closed", 1, count);
  const auto certified = NewArray<vtkUnsignedCharArray>("Certified", 1, count);
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const ContourLine& line = set.lines[static_cast<std::size_t>(i)];
    lines->InsertNextCell(static_cast<int>(line.vertices.size()));
    for (const std::int64_t id : line.vertices)
    {
      lines->InsertCellPoint(static_cast<vtkIdType>(id));
    }
    contour->SetValue(i, values[line.value]);
    closed->SetValue(i, line.closed ? 1 : 0);
    certified->SetValue(i, line.certified ? 1 : 0);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  AddPointArrays(set, model, name, output->GetPointData());
  output->GetCellData()->AddArray(contour);
  output->GetCellData()->AddArray(closed);
  output->GetCellData()->AddArray(certified);
}

std::string DescribeDoubts(const ContourReport& report)
{
  return Line(report.uncertified, "line", "not certified") +
    Line(report.undecided, "element", "(once per value) not decided: lines may be missing there") +
    Line(report.spent, "element",
      "(once per value) where the work budget was exhausted: the value is touched there, or all "
      "but "
      "reached on much of the surface; another value, or one a little beside it, is resolved") +
    Line(report.touched, "piece",
      "where the field touches the value without crossing it: rounding alone may remove these") +
    Line(report.lost, "piece", "could not be followed to an end: singular points, or roundoff") +
    Line(report.ambiguous, "joint", "of more than two ends") +
    Line(report.constant, "element",
      "(once per value) with the value, or in the surface, throughout, up to rounding: nothing is "
      "drawn there") +
    Line(report.notFinite, "element", "left out: coefficients are NaN or infinite") +
    Line(report.tooHigh, "element",
      "(once per value) left out: orders of field and surface together exceed 64; use a plane, or "
      "lower orders") +
    Line(report.normsOfZero, "value",
      "of 0 of a magnitude left out: it is taken at points; take a component");
}

std::string DescribeContours(const ContourSet& set)
{
  return Counted(static_cast<std::int64_t>(set.lines.size()), "line") + " of " +
    Counted(set.report.pieces, "piece") + ", " +
    Counted(static_cast<std::int64_t>(set.vertices.size()), "point") + "\n" +
    Line(set.report.endsInside, "end", "inside of the mesh, where the field jumps") +
    DescribeDoubts(set.report);
}
} // namespace pixelexact
