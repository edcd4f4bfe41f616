// SPDX-License-Identifier: BSD-3-Clause
#include "BlockInput.h"

#include "Core/Base/Error.h"
#include "VtkMessages.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataSet.h>
#include <vtkExodusIIReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtk_exodusII.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>

namespace pixelexact
{
namespace
{
/// An element block as the file has it.
struct Block
{
  std::string type; ///< "HEX27"
  int nodes = 0;    ///< of an element
};

class ExodusFile
{
public:
  explicit ExodusFile(const std::string& path)
    : Path(path)
  {
    int computerWord = sizeof(double);
    int fileWord = 0;
    float version = 0.0F;
    ex_opts(0); // the library prints else
    Id = ex_open(path.c_str(), EX_READ, &computerWord, &fileWord, &version);
    if (Id < 0)
    {
      CannotRead(path, "it is no Exodus II file, or damaged");
    }
    ex_set_int64_status(Id, EX_ALL_INT64_API);
  }
  ~ExodusFile() { ex_close(Id); }
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  /// By their numbers.
  [[nodiscard]] std::map<std::int64_t, Block> Blocks() const
  {
    const std::int64_t count = ex_inquire_int(Id, EX_INQ_ELEM_BLK);
    const std::int64_t points = ex_inquire_int(Id, EX_INQ_NODES);
    Require(count >= 0 && count <= kMost && points >= 0 && points <= kMost);
    std::vector<std::int64_t> ids(static_cast<std::size_t>(count));
    Require(ids.empty() || ex_get_ids(Id, EX_ELEM_BLOCK, ids.data()) >= 0);
    std::map<std::int64_t, Block> blocks;
    for (const std::int64_t id : ids)
    {
      std::array<char, MAX_STR_LENGTH + 1> type{};
      std::int64_t elements = 0;
      std::int64_t nodes = 0;
      std::int64_t edges = 0;
      std::int64_t faces = 0;
      std::int64_t attributes = 0;
      const int got = ex_get_block(
        Id, EX_ELEM_BLOCK, id, type.data(), &elements, &nodes, &edges, &faces, &attributes);
      Require(got >= 0 && elements >= 0 && elements <= kMost && nodes >= 0 && nodes <= kMostNodes);
      RequireConnectivity(id, elements * nodes, points);
      if (elements > 0)
      {
        std::string name = type.data();
        std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
        blocks[id] = { name, static_cast<int>(nodes) };
      }
    }
    return blocks;
  }

private:
  static constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  static constexpr std::int64_t kMostNodes = 1000; ///< of an element

  void Require(bool sound) const
  {
    if (!sound)
    {
      CannotRead(Path, "it is damaged or cut short; copy it anew");
    }
  }

  /// VTK's reader believes the numbers of nodes.
  void RequireConnectivity(std::int64_t block, std::int64_t count, std::int64_t points) const
  {
    if (count == 0)
    {
      return;
    }
    std::vector<std::int64_t> nodes(static_cast<std::size_t>(count));
    Require(ex_get_conn(Id, EX_ELEM_BLOCK, block, nodes.data(), nullptr, nullptr) >= 0);
    Require(std::ranges::all_of(
      nodes, [points](std::int64_t node) { return node >= 1 && node <= points; }));
  }

  std::string Path;
  int Id = -1;
};

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
void RequireAllNodes(vtkMultiBlockDataSet& read, const std::map<std::int64_t, Block>& blocks)
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
      throw Unsupported("block " + std::to_string(block->first) + " has elements of type " +
        block->second.type + " with " + std::to_string(block->second.nodes) +
        " nodes, of which VTK's reader takes " + std::to_string(nodes) +
        "; write HEX8, 20, 27, TET4, 10, WEDGE6, 15, 18, 21, PYRAMID5, 13, TRI3, 6 or QUAD4, 8, 9");
    }
  }
}

/// Shells have a thickness, and fields on both sides, that no plane element has.
void RefuseShells(const std::map<std::int64_t, Block>& blocks)
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
    throw Unsupported("its elements are shells; solids and plane elements (TRI, QUAD) are read");
  }
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
  const std::map<std::int64_t, Block> blocks = ExodusFile(file).Blocks();
  RefuseShells(blocks);
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
  RequireAllNodes(*read, blocks);
  input.grid = JoinBlocks(*read, file, input.notes);
  if (vtkDataArray* ids = input.grid->GetCellData()->GetArray("ObjectId"))
  {
    ids->SetName("Attribute");
  }
  NoteDisplacements(*input.grid, input.notes);
  return input;
}
} // namespace pixelexact
