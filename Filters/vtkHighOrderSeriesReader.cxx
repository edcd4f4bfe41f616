// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderSeriesReader.h"

#include "Core/Base/Error.h"
#include "Files/GridParts.h"
#include "Files/TimeSeries.h"
#include "Grids/FilterWork.h"
#include "MessageWords.h"
#include "Parts/PartExchange.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkHighOrderSeriesReader);

using namespace pixelexact;
using Pipeline = vtkStreamingDemandDrivenPipeline;

struct vtkHighOrderSeriesReader::Internals
{
  std::vector<TimeStep> steps;
  bool timed = false; ///< whether there is more than a single file without time

  void List(const std::vector<std::string>& files)
  {
    steps.clear();
    if (files.empty())
    {
      throw InvalidData("no file is named; call SetFileName.");
    }
    const bool collection =
      std::ranges::any_of(files, [](const auto& file) { return LowerSuffix(file) == ".pvd"; });
    if (collection && files.size() > 1)
    {
      throw InvalidData("a collection (.pvd) is to be the only file; call SetFileName.");
    }
    const bool isHdf = std::ranges::any_of(files, &IsVtkHdfName);
    steps = collection ? ReadCollection(files[0])
      : isHdf          ? ListHdfSteps(files)
                       : NumberFiles(files);
    timed = collection || files.size() > 1 || steps.front().isTimed;
  }

  [[nodiscard]] const TimeStep& StepAt(vtkInformation* output) const
  {
    if (!timed || !output->Has(Pipeline::UPDATE_TIME_STEP()))
    {
      return steps.front();
    }
    const double time = output->Get(Pipeline::UPDATE_TIME_STEP());
    const auto after = std::ranges::upper_bound(steps, time, {}, &TimeStep::time);
    return after == steps.begin() ? steps.front() : *(after - 1);
  }
};

vtkHighOrderSeriesReader::vtkHighOrderSeriesReader()
  : Series(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHighOrderSeriesReader::~vtkHighOrderSeriesReader() = default;

void vtkHighOrderSeriesReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames:" << (this->FileNames.empty() ? " none\n" : "\n");
  for (const auto& name : this->FileNames)
  {
    os << indent.GetNextIndent() << name << "\n";
  }
  os << indent << "SurfaceElements: " << this->SurfaceElements << "\n";
  os << indent << "Steps: " << this->Series->steps.size() << "\n";
  for (const auto& line : this->Diagnostics)
  {
    os << indent << line << "\n";
  }
}

void vtkHighOrderSeriesReader::SetFileName(const char* name)
{
  std::vector<std::string> wanted;
  if (name && *name)
  {
    wanted.emplace_back(name);
  }
  if (this->FileNames != wanted)
  {
    this->FileNames = wanted;
    this->Modified();
  }
}

const char* vtkHighOrderSeriesReader::GetFileName()
{
  return this->FileNames.empty() ? "" : this->FileNames[0].c_str();
}

void vtkHighOrderSeriesReader::AddFileName(const char* name)
{
  if (name && *name)
  {
    this->FileNames.emplace_back(name);
    this->Modified();
  }
}

void vtkHighOrderSeriesReader::ClearFileNames()
{
  this->SetFileName(nullptr);
}

int vtkHighOrderSeriesReader::GetNumberOfFileNames()
{
  return static_cast<int>(this->FileNames.size());
}

int vtkHighOrderSeriesReader::GetNumberOfDiagnostics()
{
  return static_cast<int>(this->Diagnostics.size());
}

std::string vtkHighOrderSeriesReader::GetDiagnostic(int index)
{
  return index >= 0 && index < this->GetNumberOfDiagnostics() ? this->Diagnostics[index]
                                                              : std::string();
}

int vtkHighOrderSeriesReader::RequestInformation(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  output->Remove(Pipeline::TIME_STEPS());
  output->Remove(Pipeline::TIME_RANGE());
  output->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  try
  {
    this->Series->List(this->FileNames);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
  if (this->Series->timed)
  {
    std::vector<double> times;
    std::ranges::transform(this->Series->steps, std::back_inserter(times), &TimeStep::time);
    const double range[2] = { times.front(), times.back() };
    output->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    output->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

int vtkHighOrderSeriesReader::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  this->Diagnostics.clear();
  return FillOutput(this, output,
    [&]
    {
      vtkInformation* asked = outputVector->GetInformationObject(0);
      const TimeStep& step = this->Series->StepAt(asked);
      const auto read = ReadParts(step.parts, PieceAskedFor(asked), this->SurfaceElements);
      output->ShallowCopy(read.grid);
      if (this->Series->timed)
      {
        output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.time);
      }
      this->Diagnostics = read.notes;
      for (const auto& line : this->Diagnostics)
      {
        vtkWarningMacro(<< pixelexact::Worded(line));
      }
      return true;
    });
}
