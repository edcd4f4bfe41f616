// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderProbe.h"

#include "ModelSource.h"
#include "PointSampling.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <exception>

vtkStandardNewMacro(vtkHighOrderProbe);

vtkHighOrderProbe::vtkHighOrderProbe()
  : Source(std::make_unique<pixelexact::ModelSource>())
{
  this->SetNumberOfInputPorts(2);
}

vtkHighOrderProbe::~vtkHighOrderProbe() = default;

void vtkHighOrderProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fields:";
  for (const auto& name : this->Fields)
  {
    os << " " << name;
  }
  os << (this->Fields.empty() ? " all\n" : "\n");
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

void vtkHighOrderProbe::AddField(const std::string& name)
{
  this->Fields.push_back(name);
  this->Modified();
}

void vtkHighOrderProbe::ClearFields()
{
  this->Fields.clear();
  this->Modified();
}

int vtkHighOrderProbe::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    pixelexact::TakeGrids(info);
    return 1;
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
  if (!this->Superclass::RequestUpdateExtent(request, inputVector, outputVector))
  {
    return 0;
  }
  // All of the grid, whatever piece of the points is asked for.
  pixelexact::AskForWhole(inputVector[1]);
  return 1;
}

int vtkHighOrderProbe::RequestData(vtkInformation* /*request*/, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  auto* points = vtkDataSet::GetData(inputVector[0]);
  auto* grid = vtkDataObject::GetData(inputVector[1]);
  auto* output = vtkDataSet::GetData(outputVector);
  try
  {
    output->CopyStructure(points);
    const auto model = this->Source->Get(grid, this);
    const auto within = [this](double from, double to)
    {
      return [this, from, to](double done)
      {
        this->UpdateProgress(from + done * (to - from));
        return this->GetAbortExecute() == 0;
      };
    };
    const double located = this->Enclosures ? 0.3 : 0.7;
    const pixelexact::PointSampling sampling(
      *model, pixelexact::PointsOf(points), within(0.1, located));
    if (sampling.IsAborted() ||
      !sampling.AddFields({ this->Fields, this->ComputeGradients, this->Enclosures },
        output->GetPointData(), within(located, 1.0)))
    {
      output->Initialize();
      return 1;
    }
    sampling.AddLocations(output->GetPointData());
    if (this->Owners)
    {
      sampling.AddOwners(output->GetPointData());
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
