// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockInput.h"
#include "Input/ExodusFile.h"
#include "Input/ExodusSeries.h"
#include "Input/ExodusSides.h"

#include "Base/VtkMessages.h"
#include "Core/Base/Counted.h"
#include "Files/SolverGroups.h"

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
#include <set>

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

/// VTK's reader numbers the elements of some files only. `before`: elements of the parts before.
void NumberElements(vtkMultiBlockDataSet& read, const ExodusBlocks& blocks, std::int64_t before)
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
      before + block->second.first);
    leaf->GetCellData()->AddArray(numbers);
  }
}

/// Shells have a thickness, and fields on both sides, that no plane element has.
void RefuseShells(const std::set<std::string>& types, const std::string& file)
{
  const auto isShell = [](const std::string& type)
  { return type.find("SHELL") != std::string::npos; };
  const auto isSolid = [](const std::string& type)
  {
    constexpr std::array kSolids{ "HEX", "TET", "WEDGE", "PYRA" };
    return std::ranges::any_of(kSolids, [&](const char* name) { return type.starts_with(name); });
  };
  if (std::ranges::any_of(types, isShell) && std::ranges::none_of(types, isSolid))
  {
    CannotRead(file, "its elements are shells; solids and plane elements (TRI, QUAD) are read");
  }
}

/// What several parts of a mesh say of it, put together.
struct ExodusSets
{
  std::map<std::int64_t, std::string> blocks; ///< names by number
  std::map<std::int64_t, ExodusFile::SideSet> sides;
  std::int64_t elements = 0;
  std::int64_t nodeSets = 0; ///< of one part

  void Add(const ExodusFile& file, const ExodusBlocks& added)
  {
    for (const auto& [id, block] : added)
    {
      std::string& name = blocks[id];
      name = name.empty() ? block.name : name;
    }
    for (const ExodusFile::SideSet& set : file.SideSets())
    {
      ExodusFile::SideSet& all = sides[set.id];
      all.id = set.id;
      all.name = all.name.empty() ? set.name : all.name;
      for (const std::int64_t element : set.elements)
      {
        all.elements.push_back(elements + element);
      }
      all.sides.insert(all.sides.end(), set.sides.begin(), set.sides.end());
    }
    nodeSets = std::max(nodeSets, file.NodeSets());
    elements += file.Elements();
  }
};

/// Names of element blocks and side sets.
void AddNames(const ExodusSets& sets, vtkUnstructuredGrid& grid)
{
  SolverMesh named;
  const auto add = [&named](std::int64_t id, const std::string& name, bool isBoundary)
  {
    if (!name.empty() && id <= std::numeric_limits<std::int32_t>::max())
    {
      named.groups.push_back({ static_cast<std::int32_t>(id), name, isBoundary });
    }
  };
  for (const auto& [id, name] : sets.blocks)
  {
    add(id, name, false);
  }
  for (const auto& [id, set] : sets.sides)
  {
    add(id, set.name, true);
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

/// Reads one file, and says what it tells of the mesh. Elements are numbered from those before.
vtkSmartPointer<vtkMultiBlockDataSet> ReadPart(
  const std::string& file, std::size_t step, std::set<std::string>& types, ExodusSets& sets)
{
  const ExodusFile exodus(file);
  const ExodusBlocks blocks = exodus.Blocks();
  for (const auto& [id, block] : blocks)
  {
    types.insert(block.type);
  }
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
  if (const std::vector<double> times = TimesOf(*reader); times.empty())
  {
    reader->Update();
  }
  else if (step < times.size())
  {
    reader->UpdateTimeStep(times[step]);
  }
  else
  {
    CannotRead(file, "it has fewer time steps than the parts before it");
  }
  check();
  vtkSmartPointer<vtkMultiBlockDataSet> read =
    vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  RequireAllNodes(*read, blocks, file);
  NumberElements(*read, blocks, sets.elements);
  sets.Add(exodus, blocks);
  return read;
}

/// The numbers of blocks are attributes. Behind the file's fields: the first one is shown where
/// none is named.
void MakeAttributes(vtkCellData& cells)
{
  if (const vtkSmartPointer<vtkDataArray> ids = cells.GetArray("ObjectId"))
  {
    cells.RemoveArray("ObjectId");
    ids->SetName("Attribute");
    cells.AddArray(ids);
  }
}

} // namespace

InputGrid ReadExodusFile(const InputRequest& request)
{
  const std::vector<ExodusName> meshes = MeshesOf(request.files);
  InputGrid input;
  const ExodusStep step = ChooseStep(meshes, request, input);
  const std::vector<std::string> files = PartsOf(meshes[step.mesh]);
  ExodusSets sets;
  std::set<std::string> types;
  vtkNew<vtkMultiBlockDataSet> parts;
  for (const std::string& file : files)
  {
    parts->SetBlock(parts->GetNumberOfBlocks(), ReadPart(file, step.own, types, sets));
  }
  const std::string& file = files.front();
  RefuseShells(types, file);
  input.grid = JoinBlocks(*parts, file, input.notes);
  std::vector<ExodusFile::SideSet> sides;
  std::ranges::transform(
    sets.sides, std::back_inserter(sides), [](const auto& entry) { return entry.second; });
  AddSideSets(sides, *input.grid, input.notes);
  input.grid->GetCellData()->RemoveArray(kExodusElement);
  MakeAttributes(*input.grid->GetCellData());
  AddNames(sets, *input.grid);
  NoteDisplacements(*input.grid, input.notes);
  if (sets.nodeSets > 0)
  {
    input.notes.push_back("'" + file + "': " + Counted(sets.nodeSets, "node set") +
      ", which name points and no faces, are left out.");
  }
  if (meshes.size() == 1)
  {
    NoteOtherMeshes(meshes.front(), input.notes);
  }
  return input;
}
} // namespace pixelexact
