// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderLinearCut.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "CutTriangles.h"
#include "FieldsNamed.h"
#include "ModelSource.h"
#include "PointBounds.h"
#include "PointSampling.h"
#include "VtkCutFunction.h"

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
#include <exception>

vtkStandardNewMacro(vtkHighOrderLinearCut);

namespace
{
using namespace pixelexact;

/// The triangles whose corners are all inside, and their points.
struct Kept
{
  std::vector<Vec3> points;
  vtkNew<vtkIdTypeArray> corners;
  vtkIdType atTheEdge = 0;

  Kept(const CutTriangles& cut, std::span<const Verdict> verdicts)
  {
    std::vector<vtkIdType> number(cut.points.size(), -1);
    for (const auto& triangle : cut.triangles)
    {
      const auto inside = std::ranges::count_if(triangle,
        [&](std::int64_t p) { return verdicts[static_cast<std::size_t>(p)] == Verdict::Inside; });
      atTheEdge += inside > 0 && inside < 3 ? 1 : 0;
      if (inside < 3)
      {
        continue;
      }
      for (const std::int64_t p : triangle)
      {
        vtkIdType& mine = number[static_cast<std::size_t>(p)];
        if (mine < 0)
        {
          mine = static_cast<vtkIdType>(points.size());
          points.push_back(cut.points[static_cast<std::size_t>(p)]);
          from.push_back(p);
        }
        corners->InsertNextValue(mine);
      }
    }
  }
  std::vector<std::int64_t> from; ///< per point, its number in the cut
};
/// The box that is proven to hold the mesh, but where the points' box ends as far out, up to what
/// the bounds leave open: corners of the surface on a flat side of the mesh are in it then.
Box3 CutBox(const HighOrderModel& model, vtkDataObject* grid)
{
  Box3 box = model.GetLocator().Bounds();
  const double slack = 1e-9 * glm::length(box.upper - box.lower);
  const std::array<double, 6> points = BoundsOf(grid);
  for (int d = 0; d < 3; ++d)
  {
    const double lower = points[static_cast<std::size_t>(2 * d)];
    const double upper = points[static_cast<std::size_t>(2 * d + 1)];
    box.lower[d] = std::fabs(lower - box.lower[d]) <= slack ? lower : box.lower[d];
    box.upper[d] = std::fabs(upper - box.upper[d]) <= slack ? upper : box.upper[d];
  }
  return box;
}
} // namespace

vtkHighOrderLinearCut::vtkHighOrderLinearCut()
  : Source(std::make_unique<ModelSource>())
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
  os << indent << "NumberOfTrianglesAtTheEdge: " << this->NumberOfTrianglesAtTheEdge << "\n";
  os << indent << "NumberOfPointsOffSurface: " << this->NumberOfPointsOffSurface << "\n";
  os << indent << "Fields:";
  for (const auto& name : this->Fields)
  {
    os << " " << name;
  }
  os << (this->Fields.empty() ? " all\n" : "\n");
}

vtkMTimeType vtkHighOrderLinearCut::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->CutFunction ? std::max(own, this->CutFunction->GetMTime()) : own;
}

void vtkHighOrderLinearCut::SetCutFunction(vtkImplicitFunction* function)
{
  if (this->CutFunction != function)
  {
    this->CutFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkHighOrderLinearCut::GetCutFunction()
{
  return this->CutFunction;
}

void vtkHighOrderLinearCut::AddField(const std::string& name)
{
  this->Fields.push_back(name);
  this->Modified();
}

void vtkHighOrderLinearCut::ClearFields()
{
  this->Fields.clear();
  this->Modified();
}

int vtkHighOrderLinearCut::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  TakeGrids(info);
  return 1;
}

int vtkHighOrderLinearCut::RequestUpdateExtent(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* /*outputVector*/)
{
  AskForWhole(inputVector[0]);
  return 1;
}

bool vtkHighOrderLinearCut::Cut(vtkDataObject* grid, vtkPolyData* output)
{
  if (!this->CutFunction)
  {
    throw InvalidData("there is no cut function; give one with SetCutFunction.");
  }
  const auto model = this->Source->Get(grid, this);
  double perPoint = PointSampling::kBytesPerPoint + 100.0; // also Xi, Element, ... of the output
  for (const Field* field : FieldsNamed(*model, this->Fields))
  {
    perPoint += 16.0 * field->values.components;
  }
  const auto progressIn = [this](double from, double to)
  {
    return [this, from, to](double part)
    {
      this->UpdateProgress(from + (to - from) * part);
      return this->GetAbortExecute() == 0;
    };
  };
  const Box3 box = CutBox(*model, grid);
  const double extent = glm::length(box.upper - box.lower);
  const auto function = MakeCutFunction(this->CutFunction, extent > 0.0 ? extent : 1.0);
  const CutTriangles cut =
    TriangulateCut(*function, box, this->Resolution, perPoint, progressIn(0.0, 0.2));
  if (cut.aborted)
  {
    return false;
  }
  const PointSampling all(*model, cut.points, progressIn(0.2, 0.9));
  if (all.IsAborted())
  {
    return false;
  }
  const Kept kept(cut, all.Verdicts());
  vtkNew<vtkPointData> values;
  all.AddFields({ this->Fields }, values);
  all.AddLocations(values);

  const auto count = static_cast<vtkIdType>(kept.points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, glm::value_ptr(kept.points[static_cast<std::size_t>(i)]));
    from->InsertNextId(kept.from[static_cast<std::size_t>(i)]);
    to->InsertNextId(i);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, kept.corners);
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(values, count);
  output->GetPointData()->CopyData(values, from, to);
  this->NumberOfTrianglesAtTheEdge = kept.atTheEdge;
  this->NumberOfPointsOffSurface = cut.offSurface;
  if (cut.offSurface > 0)
  {
    vtkWarningMacro(<< Counted(cut.offSurface, "point")
                    << " could not be brought onto the surface; raise the resolution, or give a "
                       "function whose gradient does not vanish there.");
  }
  return true;
}

int vtkHighOrderLinearCut::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkPolyData::GetData(outputVector);
  this->NumberOfTrianglesAtTheEdge = 0;
  this->NumberOfPointsOffSurface = 0;
  try
  {
    if (!this->Cut(vtkDataObject::GetData(inputVector[0]), output))
    {
      output->Initialize();
    }
    return 1;
  }
  catch (const std::exception& error) // memory may run out too
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}
