// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderPlotOverLine.h"

#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"
#include "Cuts/PointSampling.h"
#include "Grids/FilterInput.h"
#include "Grids/FilterWork.h"
#include "HighOrderModel.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

vtkStandardNewMacro(vtkHighOrderPlotOverLine);

namespace
{
using namespace pixelexact;

constexpr double kSpacing = 1e-15; ///< of t; smaller intervals are not subdivided

/// An end of an interval of the segment.
struct StretchEnd
{
  double t = 0.0;
  std::int32_t element = -1;
};
struct Stretch
{
  StretchEnd from;
  StretchEnd to;
};

std::vector<StretchEnd> Locate(const HighOrderModel& model, const Vec3& start, const Vec3& end,
  const std::vector<double>& places)
{
  std::vector<Vec3> points(places.size());
  std::ranges::transform(
    places, points.begin(), [&](double t) { return start + t * (end - start); });
  std::vector<std::int32_t> elements(places.size());
  std::vector<Verdict> verdicts(places.size());
  SampleTarget target;
  target.element = elements;
  target.verdict = verdicts;
  Sample(model.GetLocator(), nullptr, points, target);
  std::vector<StretchEnd> located(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    located[i] = { places[i], verdicts[i] == Verdict::Inside ? elements[i] : -1 };
  }
  return located;
}

/// Finds where a segment passes from one element into another, or out of the mesh. Returns pairs of
/// parameters of start + t (end - start), ascending, between which the element changes, as close as
/// roundings of t permit. First the elements at `places` (ascending, from 0 to 1) are located. An
/// element or a gap between two adjacent places may be missed.
std::vector<double> LineBreaks(const HighOrderModel& model, const Vec3& start, const Vec3& end,
  const std::vector<double>& places)
{
  std::vector<Stretch> open;
  const auto add = [&open](const StretchEnd& from, const StretchEnd& to)
  {
    if (from.element != to.element)
    {
      open.push_back({ from, to });
    }
  };
  const std::vector<StretchEnd> first = Locate(model, start, end, places);
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    add(first[i - 1], first[i]);
  }
  std::vector<double> breaks;
  while (!open.empty())
  {
    std::vector<Stretch> subdivided;
    std::vector<double> middles;
    for (const Stretch& stretch : open)
    {
      const double middle = 0.5 * (stretch.from.t + stretch.to.t);
      if (!(stretch.to.t - stretch.from.t > kSpacing) || !(middle > stretch.from.t) ||
        !(middle < stretch.to.t))
      {
        breaks.push_back(stretch.from.t);
        breaks.push_back(stretch.to.t);
        continue;
      }
      subdivided.push_back(stretch);
      middles.push_back(middle);
    }
    open.clear();
    const std::vector<StretchEnd> located = Locate(model, start, end, middles);
    for (std::size_t i = 0; i < subdivided.size(); ++i)
    {
      add(subdivided[i].from, located[i]);
      add(located[i], subdivided[i].to);
    }
  }
  std::ranges::sort(breaks);
  return breaks;
}
} // namespace

vtkHighOrderPlotOverLine::vtkHighOrderPlotOverLine()
  : MeshFilter(pixelexact::MeshScope::WholeOnFirst)
{
}

vtkHighOrderPlotOverLine::~vtkHighOrderPlotOverLine() = default;

void vtkHighOrderPlotOverLine::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto point = [&](const char* name, const double* x)
  { os << indent << name << ": " << x[0] << " " << x[1] << " " << x[2] << "\n"; };
  point("Point1", this->Point1);
  point("Point2", this->Point2);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "ElementBoundaries: " << (this->ElementBoundaries ? "on" : "off") << "\n";
  os << indent << "ComputeGradients: " << (this->ComputeGradients ? "on" : "off") << "\n";
  os << indent << "Enclosures: " << (this->Enclosures ? "on" : "off") << "\n";
  pixelexact::PrintFields(os, indent, this->Fields.All());
}

bool vtkHighOrderPlotOverLine::Make(vtkDataObject* mesh, vtkPolyData* output)
{
  using pixelexact::Vec3;
  const Vec3 start(this->Point1[0], this->Point1[1], this->Point1[2]);
  const Vec3 end(this->Point2[0], this->Point2[1], this->Point2[2]);
  const double length = glm::length(end - start);
  if (!std::isfinite(length) || !(length > 0.0))
  {
    throw pixelexact::Error(
      "Point1 and Point2 must be finite, and not the same; they are the ends of the line");
  }
  const auto model = this->ModelOf(mesh);
  this->UpdateProgress(0.1);
  std::vector<double> places(static_cast<std::size_t>(this->Resolution) + 1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i] = static_cast<double>(i) / this->Resolution;
  }
  if (this->ElementBoundaries)
  {
    const std::vector<double> breaks = LineBreaks(*model, start, end, places);
    std::vector<double> all;
    std::ranges::merge(places, breaks, std::back_inserter(all));
    all.erase(std::unique(all.begin(), all.end()), all.end());
    places = std::move(all);
  }
  this->UpdateProgress(0.3);

  const auto count = static_cast<vtkIdType>(places.size());
  std::vector<Vec3> line(places.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> distance;
  distance->SetName("arc_length");
  distance->SetNumberOfTuples(count);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    line[k] = start + places[k] * (end - start);
    points->SetPoint(i, line[k].x, line[k].y, line[k].z);
    distance->SetValue(i, places[k] * length);
    cells->InsertCellPoint(i);
  }
  output->SetPoints(points);
  output->SetLines(cells);
  vtkPointData* data = output->GetPointData();
  data->AddArray(distance);

  const pixelexact::PointSampling sampling(
    *model, std::move(line), pixelexact::ProgressOf(this, 0.3, 0.6));
  if (sampling.IsAborted() ||
    !sampling.AddFields({ this->Fields.All(), this->ComputeGradients, this->Enclosures }, data,
      pixelexact::ProgressOf(this, 0.6, 1.0)))
  {
    return false;
  }
  sampling.AddLocations(data);
  return true;
}
