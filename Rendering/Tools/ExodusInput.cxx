// SPDX-License-Identifier: BSD-3-Clause
#include "BlockInput.h"
#include "ExodusFile.h"
#include "ExodusSides.h"

#include "Core/Base/Counted.h"
#include "SolverGroups.h"
#include "VtkMessages.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataSet.h>
#include <vtkExodusIIReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <numeric>

namespace pixelexact
{
namespace
{
using ExodusBlocks = std::map<std::int64_t, ExodusFile::Block>;

void ReadAllArrays(vtkExodusIIReader& reader)
{
  for (const int type : { vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK })
  {
    for (int i = 0; i < reader.GetNumberOfObjectArrays(type); ++i)
    {
      reader.SetObjectArrayStatus(type, i, 1);
    }
  }
  for (int i = 0; i < reader.GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++i)
  {
    reader.SetObjectStatus(vtkExodusIIReader::ELEM_BLOCK, i, 1);
  }
}

/// VTK's reader takes only the first nodes of types that it does not know.
void RequireAllNodes(
  vtkMultiBlockDataSet& read, const ExodusBlocks& blocks, const std::string& file)
{
  const auto leaves = vtk::TakeSmartPointer(read.NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* leaf = vtkUnstructuredGrid::SafeDownCast(leaves->GetCurrentDataObject());
    vtkDataArray* ids = leaf != nullptr && leaf->GetNumberOfCells() > 0
      ? leaf->GetCellData()->GetArray("ObjectId")
      : nullptr;
    if (ids == nullptr)
    {
      continue;
    }
    const auto block = blocks.find(static_cast<std::int64_t>(ids->GetComponent(0, 0)));
    const auto nodes = static_cast<int>(leaf->GetCells()->GetCellSize(0));
    if (block != blocks.end() && block->second.nodes != nodes)
    {
      CannotRead(file,
        "block " + std::to_string(block->first) + " has elements of type " + block->second.type +
          " with " + std::to_string(block->second.nodes) + " nodes, of which VTK's reader takes " +
          std::to_string(nodes) +
          "; write HEX8, 20, 27, TET4, 10, WEDGE6, 15, 18, 21, PYRAMID5, 13, TRI3, 6 or QUAD4, 8, "
          "9");
    }
  }
}

/// VTK's reader numbers the elements of some files only.
void NumberElements(vtkMultiBlockDataSet& read, const ExodusBlocks& blocks)
{
  const auto leaves = vtk::TakeSmartPointer(read.NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    vtkDataArray* ids = leaf != nullptr && leaf->GetNumberOfCells() > 0
      ? leaf->GetCellData()->GetArray("ObjectId")
      : nullptr;
    const auto block = ids == nullptr
      ? blocks.end()
      : blocks.find(static_cast<std::int64_t>(ids->GetComponent(0, 0)));
    if (block == blocks.end())
    {
      continue;
    }
    vtkNew<vtkTypeInt64Array> numbers;
    numbers->SetName(kExodusElement);
    numbers->SetNumberOfValues(leaf->GetNumberOfCells());
    std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + numbers->GetNumberOfValues(),
      block->second.first);
    leaf->GetCellData()->AddArray(numbers);
  }
}

/// Shells have a thickness, and fields on both sides, that no plane element has.
void RefuseShells(const ExodusBlocks& blocks, const std::string& file)
{
  const auto isShell = [](const auto& entry)
  { return entry.second.type.find("SHELL") != std::string::npos; };
  const auto isSolid = [](const auto& entry)
  {
    constexpr std::array kSolids{ "HEX", "TET", "WEDGE", "PYRA" };
    return std::ranges::any_of(
      kSolids, [&](const char* name) { return entry.second.type.starts_with(name); });
  };
  if (std::ranges::any_of(blocks, isShell) && std::ranges::none_of(blocks, isSolid))
  {
    CannotRead(file, "its elements are shells; solids and plane elements (TRI, QUAD) are read");
  }
}

/// Names of element blocks and side sets.
void AddNames(const ExodusFile& file, const ExodusBlocks& blocks, vtkUnstructuredGrid& grid)
{
  SolverMesh named;
  const auto add = [&named](std::int64_t id, const std::string& name, bool isBoundary)
  {
    if (!name.empty() && id <= std::numeric_limits<std::int32_t>::max())
    {
      named.groups.push_back({ static_cast<std::int32_t>(id), name, isBoundary });
    }
  };
  for (const auto& [id, block] : blocks)
  {
    add(id, block.name, false);
  }
  for (const ExodusFile::SideSet& set : file.SideSets())
  {
    add(set.id, set.name, true);
  }
  AddGroups(named, &grid);
}

void NoteDisplacements(vtkDataSet& grid, std::vector<std::string>& notes)
{
  for (int i = 0; i < grid.GetPointData()->GetNumberOfArrays(); ++i)
  {
    std::string name = grid.GetPointData()->GetArrayName(i);
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (name.starts_with("dis"))
    {
      notes.push_back(std::string("the displacements '") + grid.GetPointData()->GetArrayName(i) +
        "' are a field; the mesh is shown where the file has it, not displaced.");
    }
  }
}
} // namespace

InputGrid ReadExodusFile(const InputRequest& request)
{
  CheckAlone(request.files);
  const std::string& file = request.files[0];
  constexpr std::array<std::string_view, 4> kMarks{ "CDF\x01", "CDF\x02", "CDF\x05", kHdf5Mark };
  RequireMark(file, kMarks, "Exodus II file (netCDF)");
  const ExodusFile exodus(file);
  const ExodusBlocks blocks = exodus.Blocks();
  RefuseShells(blocks, file);
  const VtkMessages messages;
  const auto check = [&]
  {
    if (const std::string error = messages.FirstError(); !error.empty())
    {
      CannotRead(file, error);
    }
  };
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(file.c_str());
  reader->ApplyDisplacementsOff();
  reader->GenerateObjectIdCellArrayOn();
  reader->UpdateInformation();
  check();
  ReadAllArrays(*reader);
  InputGrid input;
  UpdateToStep(*reader, request, input);
  check();
  auto* read = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  RequireAllNodes(*read, blocks, file);
  NumberElements(*read, blocks);
  input.grid = JoinBlocks(*read, file, input.notes);
  if (vtkDataArray* ids = input.grid->GetCellData()->GetArray("ObjectId"))
  {
    ids->SetName("Attribute");
  }
  AddSideSets(exodus.SideSets(), *input.grid, input.notes);
  input.grid->GetCellData()->RemoveArray(kExodusElement);
  AddNames(exodus, blocks, *input.grid);
  NoteDisplacements(*input.grid, input.notes);
  if (const std::int64_t sets = exodus.NodeSets(); sets > 0)
  {
    input.notes.push_back("'" + file + "': " + Counted(sets, "node set") +
      ", which name points and no faces, are left out.");
  }
  return input;
}
} // namespace pixelexact
