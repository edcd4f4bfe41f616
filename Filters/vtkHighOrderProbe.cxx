// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderProbe.h"

#include "Cuts/PointSampling.h"
#include "Grids/FilterInput.h"
#include "Grids/FilterWork.h"
#include "HighOrderModel.h"
#include "Parts/ParallelRun.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkHighOrderProbe);

vtkHighOrderProbe::vtkHighOrderProbe()
  : MeshFilter(pixelexact::MeshScope::WholeOnEach, 1)
{
  this->SetNumberOfInputPorts(2);
}

vtkHighOrderProbe::~vtkHighOrderProbe() = default;

void vtkHighOrderProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  pixelexact::PrintFields(os, indent, this->Fields.All());
  os << indent << "ComputeGradients: " << this->ComputeGradients << "\n";
  os << indent << "Enclosures: " << this->Enclosures << "\n";
  os << indent << "Owners: " << this->Owners << "\n";
}

void vtkHighOrderProbe::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkHighOrderProbe::SetSourceData(vtkDataObject* grid)
{
  this->SetInputDataObject(1, grid);
}

int vtkHighOrderProbe::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkHighOrderProbe::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Superclass::RequestInformation(request, inputVector, outputVector))
  {
    return 0;
  }
  // The time is the grid's; the pipeline by itself takes it from the points.
  vtkInformation* grid = inputVector[1]->GetInformationObject(0);
  if (grid && grid->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()))
  {
    vtkInformation* output = outputVector->GetInformationObject(0);
    output->CopyEntry(grid, vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    output->CopyEntry(grid, vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  }
  return 1;
}

int vtkHighOrderProbe::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->PointsAreInBlocks =
    pixelexact::ComesInBlocks(this->PointsAreInBlocks, inputVector[0], outputVector);
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

bool vtkHighOrderProbe::Make(vtkDataObject* mesh, vtkDataObject* output)
{
  using namespace pixelexact;
  auto* points = vtkDataSet::SafeDownCast(output);
  const auto model = this->ModelOf(mesh);
  if (this->ComputeGradients)
  {
    model->RequireSolids("a gradient");
  }
  const double located = this->Enclosures ? 0.3 : 0.7;
  const PointSampling sampling(*model, PointsOf(points), ProgressOf(this, 0.1, located));
  vtkPointData* data = points->GetPointData();
  if (sampling.IsAborted() ||
    !sampling.AddFields({ this->Fields.All(), this->ComputeGradients, this->Enclosures }, data,
      ProgressOf(this, located, 1.0)))
  {
    return false;
  }
  sampling.AddLocations(data);
  if (this->Owners)
  {
    sampling.AddOwners(data);
  }
  return true;
}

int vtkHighOrderProbe::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkDataSet::GetData(outputVector);
  if (this->PointsAreInBlocks)
  {
    // No failure, for which those behind would wait.
    output->Initialize();
    vtkErrorMacro("points in blocks are not probed in several processes; put them together first "
                  "(vtkAppendFilter, Merge Blocks)");
    return 1;
  }
  output->CopyStructure(vtkDataSet::GetData(inputVector[0]));
  return this->Superclass::RequestData(request, inputVector, outputVector);
}
