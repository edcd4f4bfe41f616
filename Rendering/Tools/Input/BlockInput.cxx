// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockInput.h"

#include "Formats/FileText.h"

#include <fmt/format.h>

#include <vtkAlgorithm.h>
#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <map>

namespace pixelexact
{
namespace
{
/// Properties of the arrays with the same name in all blocks.
struct CommonArray
{
  int components = 0;
  int blocks = 0;
  bool isAlike = true;   ///< all have the same number of components
  bool isOneType = true; ///< all have the same type of numbers
  int type = 0;
};

/// Makes the blocks' numeric arrays the same: NaN where a block has no array of that name, doubles
/// where types differ. Removes arrays with different numbers of components. Both are noted.
void MakeAlike(std::span<vtkDataSetAttributes* const> blocks, std::span<const vtkIdType> sizes,
  const std::string& file, std::vector<std::string>& notes)
{
  std::map<std::string, CommonArray> arrays;
  for (vtkDataSetAttributes* data : blocks)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array == nullptr || array->GetName() == nullptr)
      {
        continue;
      }
      CommonArray& common = arrays[array->GetName()];
      const bool isFirst = common.blocks++ == 0;
      common.components = isFirst ? array->GetNumberOfComponents() : common.components;
      common.type = isFirst ? array->GetDataType() : common.type;
      common.isAlike = common.isAlike && common.components == array->GetNumberOfComponents();
      common.isOneType = common.isOneType && common.type == array->GetDataType();
    }
  }
  const auto count = static_cast<int>(blocks.size());
  for (const auto& [name, common] : arrays)
  {
    if ((common.isAlike && common.isOneType && common.blocks == count) ||
      name == vtkDataSetAttributes::GhostArrayName())
    {
      continue;
    }
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      vtkDataArray* old = blocks[i]->GetArray(name.c_str());
      if (!common.isAlike)
      {
        blocks[i]->RemoveArray(name.c_str());
        continue;
      }
      vtkNew<vtkDoubleArray> own;
      own->SetNumberOfComponents(common.components);
      if (old != nullptr)
      {
        own->DeepCopy(old);
      }
      else
      {
        own->SetNumberOfTuples(sizes[i]);
        own->Fill(std::numeric_limits<double>::quiet_NaN());
      }
      own->SetName(name.c_str());
      blocks[i]->AddArray(own);
    }
    if (!common.isAlike)
    {
      notes.push_back(fmt::format(
        "'{}': the field '{}' has other components in some blocks and was left out.", file, name));
    }
    else if (common.blocks < count)
    {
      notes.push_back(
        fmt::format("'{}': the field '{}' has values in {} of {} blocks; it is NaN in "
                    "the others.",
          file, name, common.blocks, count));
    }
  }
}
} // namespace

void RequireMark(const std::string& file, std::span<const std::string_view> marks, const char* what)
{
  if (IsPipeOrDevice(file))
  {
    CannotRead(file, kPipeRemedy);
  }
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
  if (request.timesAlone)
  {
    return;
  }
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
  std::vector<vtkSmartPointer<vtkDataSet>> inputs;
  std::vector<vtkDataSetAttributes*> points;
  std::vector<vtkDataSetAttributes*> cells;
  std::vector<vtkIdType> pointCounts;
  std::vector<vtkIdType> cellCounts;
  bool isSingle = true;
  const auto leaves = vtk::TakeSmartPointer(blocks.NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    if (leaf == nullptr || leaf->GetNumberOfCells() == 0)
    {
      continue;
    }
    auto* set = vtkPointSet::SafeDownCast(leaf);
    isSingle = isSingle && set != nullptr && set->GetPoints()->GetDataType() == VTK_FLOAT;
    inputs.emplace_back(leaf);
    points.push_back(leaf->GetPointData());
    cells.push_back(leaf->GetCellData());
    pointCounts.push_back(leaf->GetNumberOfPoints());
    cellCounts.push_back(leaf->GetNumberOfCells());
    append->AddInputData(leaf);
  }
  if (inputs.empty())
  {
    CannotRead(file, "it holds no elements");
  }
  MakeAlike(points, pointCounts, file, notes);
  MakeAlike(cells, cellCounts, file, notes);
  append->SetOutputPointsPrecision(
    isSingle ? vtkAlgorithm::SINGLE_PRECISION : vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  return append->GetOutput();
}
} // namespace pixelexact
