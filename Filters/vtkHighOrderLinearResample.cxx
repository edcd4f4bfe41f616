// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderLinearResample.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Cuts/PointSampling.h"
#include "Grids/FilterInput.h"
#include "Grids/FilterWork.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderLinearResample);

namespace
{
using namespace pixelexact;

void RequireRoom(const int dimensions[3], const std::vector<const Field*>& fields)
{
  double perNode = PointSampling::kBytesPerPoint + 3.0; // a mask, and flags of nodes and cells
  for (const Field* field : fields)
  {
    perNode += 8.0 * field->values.components;
  }
  const std::int64_t nodes = std::int64_t{ dimensions[0] } * dimensions[1] * dimensions[2];
  RequireMemory(
    perNode * static_cast<double>(nodes), Counted(nodes, "node"), "lower the dimensions");
}

/// Marks nodes that are not inside, and the cells that touch them.
void Blank(vtkImageData* image, std::span<const Verdict> verdicts)
{
  vtkNew<vtkCharArray> mask;
  mask->SetName("vtkValidPointMask");
  mask->SetNumberOfValues(image->GetNumberOfPoints());
  const auto newFlags = [](vtkIdType count)
  {
    auto flags = vtkSmartPointer<vtkUnsignedCharArray>::New();
    flags->SetName(vtkDataSetAttributes::GhostArrayName());
    flags->SetNumberOfValues(count);
    flags->FillValue(0);
    return flags;
  };
  const auto points = newFlags(image->GetNumberOfPoints());
  const auto cells = newFlags(image->GetNumberOfCells());
  const int* n = image->GetDimensions();
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    const bool inside = verdicts[point] == Verdict::Inside;
    mask->SetValue(point, inside ? 1 : 0);
    if (inside)
    {
      continue;
    }
    points->SetValue(point, vtkDataSetAttributes::HIDDENPOINT);
    const int at[3] = { static_cast<int>(point % n[0]), static_cast<int>(point / n[0] % n[1]),
      static_cast<int>(point / n[0] / n[1]) };
    for (int corner = 0; corner < 8; ++corner)
    {
      int cell[3];
      bool exists = true;
      for (int d = 0; d < 3; ++d)
      {
        cell[d] = at[d] - ((corner >> d) & 1);
        exists = exists && cell[d] >= 0 && cell[d] < std::max(n[d] - 1, 1);
      }
      if (exists)
      {
        cells->SetValue(image->ComputeCellId(cell), vtkDataSetAttributes::HIDDENCELL);
      }
    }
  }
  image->GetPointData()->AddArray(mask);
  image->GetPointData()->AddArray(points);
  image->GetCellData()->AddArray(cells);
}

/// Origin and spacing of nodes that reach from corner to corner of the box.
void SetGeometry(vtkImageData* image, const int dimensions[3], const double bounds[6])
{
  double spacing[3];
  double origin[3];
  for (int d = 0; d < 3; ++d)
  {
    const double length = bounds[2 * d + 1] - bounds[2 * d];
    origin[d] = dimensions[d] > 1 ? bounds[2 * d] : bounds[2 * d] + length / 2;
    spacing[d] = dimensions[d] > 1 && length > 0.0 ? length / (dimensions[d] - 1) : 1.0;
  }
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  image->SetDimensions(dimensions);
}
} // namespace

vtkHighOrderLinearResample::vtkHighOrderLinearResample()
  : MeshFilter(MeshScope::WholeOnFirst)
{
}

vtkHighOrderLinearResample::~vtkHighOrderLinearResample() = default;

void vtkHighOrderLinearResample::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "SamplingBounds:";
  for (const double bound : this->SamplingBounds)
  {
    os << " " << bound;
  }
  os << "\n";
  PrintFields(os, indent, this->Fields.All());
}

int vtkHighOrderLinearResample::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUniformGrid");
  return 1;
}

int vtkHighOrderLinearResample::RequestInformation(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  // Origin and spacing may depend on the data and are set with it.
  int extent[6];
  for (int d = 0; d < 3; ++d)
  {
    extent[2 * d] = 0;
    extent[2 * d + 1] = std::max(this->Dimensions[d], 1) - 1;
  }
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

bool vtkHighOrderLinearResample::Make(vtkDataObject* mesh, vtkImageData* output)
{
  const int* n = this->Dimensions;
  if (n[0] < 1 || n[1] < 1 || n[2] < 1)
  {
    throw InvalidData("Dimensions must be at least 1 in each direction.");
  }
  const auto model = this->ModelOf(mesh);
  model->RequireSolids("a linear resample");
  const bool own = this->SamplingBounds[0] <= this->SamplingBounds[1];
  output->Initialize();
  RequireRoom(n, FieldsNamed(*model, this->Fields.All()));
  SetGeometry(output, n, own ? this->SamplingBounds : BoundsOf(mesh).data());
  const PointSampling sampling(*model, PointsOf(output), ProgressOf(this, 0.0, 0.8));
  if (sampling.IsAborted())
  {
    return false;
  }
  sampling.AddFields({ this->Fields.All(), false }, output->GetPointData());
  Blank(output, sampling.Verdicts());
  return true;
}
