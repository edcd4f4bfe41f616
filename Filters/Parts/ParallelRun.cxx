// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/ParallelRun.h"

#include "Conversion/ModelSource.h"
#include "Core/Base/Error.h"
#include "PackedArrays.h"
#include "Parts/PartExchange.h"

#include "vtkAppendPolyData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <exception>
#include <functional>
#include <vector>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// The cells that belong to this process; ghost cells are left out.
std::vector<vtkIdType> OwnCells(vtkUnstructuredGrid* grid)
{
  const vtkUnsignedCharArray* marks = grid->GetCellGhostArray();
  std::vector<vtkIdType> own;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (marks == nullptr || (marks->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) == 0)
    {
      own.push_back(cell);
    }
  }
  return own;
}

/// Calls `each` for each place of a leaf in composite data, also empty ones, in VTK's order.
void ForPlaces(
  vtkCompositeDataSet* data, const std::function<void(vtkCompositeDataIterator*)>& each)
{
  const auto place = vtkSmartPointer<vtkCompositeDataIterator>::Take(data->NewIterator());
  place->SkipEmptyNodesOff();
  for (place->InitTraversal(); place->IsDoneWithTraversal() == 0; place->GoToNextItem())
  {
    each(place);
  }
}

/// The grids of a process' part, packed; empty ones where there are no cells.
std::vector<Grid> PackedGrids(vtkDataObject* own, vtkAlgorithm* filter)
{
  const auto packed = [filter](vtkDataObject* data)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    const std::vector<vtkIdType> cells =
      grid != nullptr ? OwnCells(grid) : std::vector<vtkIdType>();
    return cells.empty() ? Grid::New() : PackedCells(WithCoefficients(grid, filter), cells, true);
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(own);
  if (composite == nullptr)
  {
    if (vtkUnstructuredGrid::SafeDownCast(own) == nullptr)
    {
      throw InvalidData("there is no high-order grid; connect a vtkUnstructuredGrid.");
    }
    return { packed(own) };
  }
  (void)PartsOf(composite); // throws where a leaf with cells is no grid
  std::vector<Grid> grids;
  ForPlaces(composite,
    [&](vtkCompositeDataIterator* place)
    { grids.push_back(packed(composite->GetDataSet(place))); });
  return grids;
}

/// Throws on all processes where any has another number of blocks.
void RequireTheSame(int count, vtkMultiProcessController* processes)
{
  const int own[2] = { count, -count };
  int most[2] = { 0, 0 };
  processes->AllReduce(own, most, 2, vtkCommunicator::MAX_OP);
  if (most[0] != -most[1])
  {
    throw InvalidData("the processes have different numbers of blocks; put the blocks together "
                      "first (vtkHighOrderPack, then vtkAppendFilter or Merge Blocks).");
  }
}
} // namespace

vtkMultiProcessController* ProcessesThatShare(vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  auto* processes = vtkMultiProcessController::GetGlobalController();
  vtkInformation* asked = output->GetInformationObject(0);
  const bool share = processes != nullptr && processes->GetNumberOfProcesses() > 1 &&
    asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) == processes->GetNumberOfProcesses() &&
    asked->Get(Pipeline::UPDATE_PIECE_NUMBER()) == processes->GetLocalProcessId();
  return share ? processes : nullptr;
}

void AskForParts(vtkInformationVector* input, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  auto* processes = ProcessesThatShare(output);
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* asked = input->GetInformationObject(i);
    asked->Set(Pipeline::UPDATE_PIECE_NUMBER(), processes ? processes->GetLocalProcessId() : 0);
    asked->Set(
      Pipeline::UPDATE_NUMBER_OF_PIECES(), processes ? processes->GetNumberOfProcesses() : 1);
    asked->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
}

bool HasNoShare(vtkInformationVector* input)
{
  auto* processes = vtkMultiProcessController::GetGlobalController();
  vtkDataObject* data = vtkDataObject::GetData(input);
  return processes != nullptr && processes->GetNumberOfProcesses() > 1 && data != nullptr &&
    data->GetNumberOfElements(vtkDataObject::CELL) == 0;
}

bool ComesInBlocks(bool known, vtkInformationVector* input, vtkInformationVector* output)
{
  return ProcessesThatShare(output) == nullptr
    ? known
    : vtkCompositeDataSet::SafeDownCast(vtkDataObject::GetData(input)) != nullptr;
}

int AnswerOfAll(int answer, vtkInformationVector* output)
{
  int least = answer;
  if (auto* processes = ProcessesThatShare(output))
  {
    processes->AllReduce(&answer, &least, 1, vtkCommunicator::MIN_OP);
  }
  return least;
}

WholeMesh::WholeMesh(Maker maker)
  : WhoMakes(maker)
{
}

vtkDataObject* WholeMesh::Of(
  vtkInformationVector* input, vtkInformationVector* output, vtkAlgorithm* filter)
{
  vtkDataObject* own = vtkDataObject::GetData(input);
  auto* processes = ProcessesThatShare(output);
  if (processes == nullptr)
  {
    this->Source.clear();
    this->Whole = nullptr;
    return own;
  }
  const DataState state = own != nullptr ? StateOf(own) : DataState();
  const int changed = this->Source.empty() || this->Source != state ? 1 : 0;
  int anyChanged = 0;
  processes->AllReduce(&changed, &anyChanged, 1, vtkCommunicator::MAX_OP);
  if (anyChanged != 0)
  {
    this->Source.clear();
    this->Gather(own, processes, filter);
    this->Source = state;
  }
  return this->Whole;
}

void WholeMesh::Gather(
  vtkDataObject* own, vtkMultiProcessController* processes, vtkAlgorithm* filter)
{
  this->Whole = nullptr;
  std::vector<Grid> grids;
  std::string problem;
  try
  {
    grids = PackedGrids(own, filter);
  }
  catch (const std::exception& error) // memory may run out too
  {
    // The error is thrown later, because the other processes wait for this one's part.
    problem = error.what();
  }
  AgreeThatAllIsWell(problem, processes);
  RequireTheSame(static_cast<int>(grids.size()), processes);
  // All parts are gathered before any is checked, so that a failure does not block other processes.
  std::vector<std::vector<Grid>> parts;
  parts.reserve(grids.size());
  for (const Grid& grid : grids)
  {
    parts.push_back(
      this->WhoMakes == Maker::Each ? FromAll(grid, processes) : FromAllToFirst(grid, processes));
  }
  if (this->WhoMakes == Maker::First && processes->GetLocalProcessId() != 0)
  {
    return;
  }
  std::vector<Grid> wholes;
  wholes.reserve(parts.size());
  for (const auto& ofGrid : parts)
  {
    const Grid all = Appended(ofGrid);
    // A model of a packed grid would hold the coefficients twice.
    wholes.push_back(all ? Unpack(all) : Grid::New());
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(own);
  if (composite == nullptr)
  {
    this->Whole = wholes.front();
    return;
  }
  const auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  std::size_t next = 0;
  ForPlaces(composite,
    [&](vtkCompositeDataIterator* place)
    {
      const Grid& grid = wholes[next++];
      copy->SetDataSet(place, grid->GetNumberOfCells() > 0 ? grid.Get() : nullptr);
    });
  this->Whole = copy;
}

vtkSmartPointer<vtkPolyData> WholeSurface(vtkPolyData* surface, vtkInformationVector* output)
{
  auto* processes = ProcessesThatShare(output);
  if (processes == nullptr)
  {
    return surface;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  processes->Gather(surface, received, 0);
  if (processes->GetLocalProcessId() != 0)
  {
    return nullptr;
  }
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  for (const auto& part : received)
  {
    auto* polydata = vtkPolyData::SafeDownCast(part);
    if (polydata != nullptr && polydata->GetNumberOfPoints() > 0)
    {
      append->AddInputData(polydata);
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}
} // namespace pixelexact
