// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderLinearCut.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Cuts/CutTriangles.h"
#include "Cuts/PointSampling.h"
#include "Cuts/VtkCutFunction.h"
#include "Grids/FilterInput.h"
#include "Grids/FilterWork.h"
#include "HighOrderModel.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImplicitFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

vtkStandardNewMacro(vtkHighOrderLinearCut);

namespace
{
using namespace pixelexact;

/// Appends the values of the numbered points in `from` to `to`.
void Append(vtkPointData* from, const std::vector<std::int64_t>& numbers, vtkPointData* to)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> places;
  const vtkIdType begin = to->GetNumberOfTuples();
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    ids->InsertNextId(static_cast<vtkIdType>(numbers[i]));
    places->InsertNextId(begin + static_cast<vtkIdType>(i));
  }
  to->CopyData(from, ids, places);
}

void SetShape(const CutTriangles& whole, const ClippedCut& clipped, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(
    static_cast<vtkIdType>(clipped.kept.size()) + static_cast<vtkIdType>(clipped.rim.size()));
  vtkIdType next = 0;
  for (const std::int64_t point : clipped.kept)
  {
    points->SetPoint(next++, glm::value_ptr(whole.points[static_cast<std::size_t>(point)]));
  }
  for (const Vec3& x : clipped.rim)
  {
    points->SetPoint(next++, glm::value_ptr(x));
  }
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(clipped.triangles.size()));
  next = 0;
  for (const auto& triangle : clipped.triangles)
  {
    for (const std::int64_t corner : triangle)
    {
      corners->SetValue(next++, static_cast<vtkIdType>(corner));
    }
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, corners);
  output->SetPoints(points);
  output->SetPolys(triangles);
}

/// The box that is proven to hold the mesh, but where the points' box ends as far out, up to what
/// the bounds leave open: corners of the surface on a flat side of the mesh are in it then.
Box3 CutBox(const HighOrderModel& model, vtkDataObject* grid)
{
  Box3 box = model.GetLocator().Bounds();
  const double slack = 1e-9 * glm::length(box.upper - box.lower);
  const std::array<double, 6> points = BoundsOf(grid);
  for (int d = 0; d < 3; ++d)
  {
    const std::size_t side = 2 * static_cast<std::size_t>(d);
    const double lower = points[side];
    const double upper = points[side + 1];
    box.lower[d] = std::fabs(lower - box.lower[d]) <= slack ? lower : box.lower[d];
    box.upper[d] = std::fabs(upper - box.upper[d]) <= slack ? upper : box.upper[d];
  }
  return box;
}
} // namespace

vtkHighOrderLinearCut::vtkHighOrderLinearCut()
  : MeshFilter(MeshScope::WholeOnFirst)
{
}

vtkHighOrderLinearCut::~vtkHighOrderLinearCut() = default;

void vtkHighOrderLinearCut::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "CutFunction: " << (this->CutFunction ? this->CutFunction->GetClassName() : "(none)")
     << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "NumberOfTrianglesAtTheRim: " << this->NumberOfTrianglesAtTheRim << "\n";
  os << indent << "NumberOfPointsOffSurface: " << this->NumberOfPointsOffSurface << "\n";
  PrintFields(os, indent, this->Fields.All());
}

vtkMTimeType vtkHighOrderLinearCut::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->CutFunction ? std::max(own, this->CutFunction->GetMTime()) : own;
}

void vtkHighOrderLinearCut::SetCutFunction(vtkImplicitFunction* function)
{
  vtkSetSmartPointerBodyMacro(CutFunction, vtkImplicitFunction, function);
}

vtkImplicitFunction* vtkHighOrderLinearCut::GetCutFunction()
{
  return this->CutFunction;
}

void vtkHighOrderLinearCut::ResetReport()
{
  this->NumberOfTrianglesAtTheRim = 0;
  this->NumberOfPointsOffSurface = 0;
}

bool vtkHighOrderLinearCut::Make(vtkDataObject* mesh, vtkPolyData* output)
{
  if (!this->CutFunction)
  {
    throw InvalidData("there is no cut function; give one with SetCutFunction.");
  }
  const auto model = this->ModelOf(mesh);
  model->RequireSolids("a linear cut");
  double perPoint = PointSampling::kBytesPerPoint + 100.0; // also Xi, Element, ... of the output
  for (const Field* field : FieldsNamed(*model, this->Fields.All()))
  {
    perPoint += 16.0 * field->values.components;
  }
  const Box3 box = CutBox(*model, mesh);
  const double extent = glm::length(box.upper - box.lower);
  const auto function = MakeCutFunction(this->CutFunction, extent > 0.0 ? extent : 1.0);
  const CutTriangles cut =
    TriangulateCut(*function, box, this->Resolution, perPoint, ProgressOf(this, 0.0, 0.2));
  if (cut.aborted)
  {
    return false;
  }
  const PointSampling all(*model, cut.points, ProgressOf(this, 0.2, 0.9));
  if (all.IsAborted())
  {
    return false;
  }
  const ClippedCut clipped = ClipToMesh(*function, cut, all.Verdicts(), model->GetLocator());
  SetShape(cut, clipped, output);
  const auto sampled = [this](const PointSampling& sampling)
  {
    auto values = vtkSmartPointer<vtkPointData>::New();
    sampling.AddFields({ this->Fields.All() }, values);
    sampling.AddLocations(values);
    return values;
  };
  const auto inner = sampled(all);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(inner, output->GetNumberOfPoints());
  Append(inner, clipped.kept, output->GetPointData());
  std::vector<std::int64_t> rim(clipped.rim.size());
  std::iota(rim.begin(), rim.end(), std::int64_t{ 0 });
  Append(sampled(PointSampling(*model, clipped.rim)), rim, output->GetPointData());
  this->NumberOfTrianglesAtTheRim = clipped.atTheRim;
  this->NumberOfPointsOffSurface = cut.offSurface;
  if (cut.offSurface > 0)
  {
    vtkWarningMacro(<< Counted(cut.offSurface, "point")
                    << " could not be brought onto the surface; raise the resolution, or give a "
                       "function whose gradient does not vanish there.");
  }
  return true;
}
