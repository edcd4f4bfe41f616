// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockInput.h"

#include <fmt/format.h>

#include <vtkAlgorithm.h>
#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>

namespace pixelexact
{
namespace
{
/// Counts in how many blocks an array is, by name.
class ArrayCount
{
public:
  void Add(vtkDataSetAttributes& data)
  {
    for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    {
      if (const char* name = data.GetArrayName(i))
      {
        ++Counts[name];
      }
    }
  }

  void Note(int blocks, const std::string& file, std::vector<std::string>& notes) const
  {
    for (const auto& [name, count] : Counts)
    {
      if (count < blocks)
      {
        notes.push_back(fmt::format("'{}': the field '{}' is in {} of {} blocks and was left out.",
          file, name, count, blocks));
      }
    }
  }

private:
  std::map<std::string, int> Counts;
};
} // namespace

void RequireMark(const std::string& file, std::span<const std::string_view> marks, const char* what)
{
  std::array<char, 32> head{};
  std::ifstream(file, std::ios::binary).read(head.data(), head.size());
  const std::string_view begin(head.data(), head.size());
  if (std::ranges::none_of(marks, [&](std::string_view mark) { return begin.starts_with(mark); }))
  {
    CannotRead(file, std::string("it is no ") + what);
  }
}

std::vector<double> TimesOf(vtkAlgorithm& reader)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* information = reader.GetOutputInformation(0);
  if (!information->Has(Pipeline::TIME_STEPS()))
  {
    return {};
  }
  const double* times = information->Get(Pipeline::TIME_STEPS());
  return { times, times + information->Length(Pipeline::TIME_STEPS()) };
}

void UpdateToStep(vtkAlgorithm& reader, const InputRequest& request, InputGrid& input)
{
  input.times = TimesOf(reader);
  input.step = ChooseStep(request, input.times);
  if (input.times.empty())
  {
    reader.Update();
    return;
  }
  reader.UpdateTimeStep(input.times[static_cast<std::size_t>(input.step)]);
}

vtkSmartPointer<vtkUnstructuredGrid> JoinBlocks(
  vtkMultiBlockDataSet& blocks, const std::string& file, std::vector<std::string>& notes)
{
  vtkNew<vtkAppendFilter> append;
  ArrayCount points;
  ArrayCount cells;
  int count = 0;
  const auto leaves = vtk::TakeSmartPointer(blocks.NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    if (leaf != nullptr && leaf->GetNumberOfCells() > 0)
    {
      append->AddInputData(leaf);
      points.Add(*leaf->GetPointData());
      cells.Add(*leaf->GetCellData());
      ++count;
    }
  }
  if (count == 0)
  {
    CannotRead(file, "it holds no elements");
  }
  points.Note(count, file, notes);
  cells.Note(count, file, notes);
  append->Update();
  return append->GetOutput();
}
} // namespace pixelexact
