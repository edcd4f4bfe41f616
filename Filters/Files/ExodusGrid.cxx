// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ExodusGrid.h"

#include "Cells/CellBasis.h"
#include "Conversion/SourceArrays.h"
#include "Conversion/SourceCells.h"
#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Files/ExodusCells.h"
#include "Files/SolverGrid.h"
#include "Formats/Exodus/ExodusFile.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <new>
#include <set>

namespace pixelexact
{
namespace
{
using Block = ExodusFile::Block;
constexpr std::int64_t kMaxId = std::numeric_limits<std::int32_t>::max();

/// Fields at nodes or of elements, which grow as parts of the mesh are appended.
class GrowingFields
{
public:
  using Values = std::vector<double>;

  /// Appends a field's values at the `count` entities from `place` on. Each component has `count`
  /// values, or none, which is stored as NaN.
  void Append(const std::string& name, std::int64_t place, std::int64_t count,
    const std::vector<Values>& components)
  {
    vtkSmartPointer<vtkDoubleArray>& array = Arrays[name];
    if (array == nullptr)
    {
      array = vtkSmartPointer<vtkDoubleArray>::New();
      array->SetName(name.c_str());
      array->SetNumberOfComponents(static_cast<int>(components.size()));
      Order.push_back(name);
    }
    if (array->GetNumberOfComponents() != static_cast<int>(components.size()))
    {
      throw InvalidData("its field '" + name + "' has other components in another part");
    }
    FillTo(*array, place);
    for (std::int64_t i = 0; i < count; ++i)
    {
      for (const Values& values : components)
      {
        array->InsertNextValue(values.empty() ? kNone : values[static_cast<std::size_t>(i)]);
      }
    }
  }

  void AddTo(vtkFieldData& data, std::int64_t count)
  {
    for (const std::string& name : Order)
    {
      FillTo(*Arrays[name], count);
      Arrays[name]->Squeeze();
      data.AddArray(Arrays[name]);
    }
  }

private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  static void FillTo(vtkDoubleArray& array, std::int64_t count)
  {
    while (array.GetNumberOfValues() < count * array.GetNumberOfComponents())
    {
      array.InsertNextValue(kNone);
    }
  }

  std::map<std::string, vtkSmartPointer<vtkDoubleArray>> Arrays;
  std::vector<std::string> Order;
};

/// A side set, joined from all parts.
struct Sides
{
  std::string name;
  std::vector<AttributedFace> faces;
};

class GridBuilder
{
public:
  GridBuilder(std::size_t step, bool surfaces)
    : Step(step)
    , Surfaces(surfaces)
  {
    Points->SetDataTypeToDouble();
    Grid->AllocateEstimate(1024, 8);
  }

  void Add(const std::string& file)
  {
    const ExodusFile part(file);
    const std::vector<double> times = part.Times();
    if (!times.empty() && Step >= times.size())
    {
      throw InvalidData("it has fewer time steps than the parts before it");
    }
    HasSteps = !times.empty();
    FirstPoint = Points->GetNumberOfPoints();
    FirstCellOf.clear();
    AddPoints(part);
    for (const Block& block : part.Blocks())
    {
      AddBlock(part, block);
    }
    AddFields(part);
    AddSides(part);
    NodeSets = std::max(NodeSets, part.NodeSets());
  }

  vtkSmartPointer<vtkUnstructuredGrid> Finish(
    const std::string& file, std::vector<std::string>& notes)
  {
    if (Grid->GetNumberOfCells() == 0)
    {
      throw InvalidData(
        LeftOut.empty() ? "it holds no elements" : "nothing of it is read: " + LeftOut.front());
    }
    SetPoints();
    Grid->Squeeze();
    AtNodes.AddTo(*Grid->GetPointData(), Grid->GetNumberOfPoints());
    OfElements.AddTo(*Grid->GetCellData(), Grid->GetNumberOfCells());
    AddAttributes();
    AddNames();
    Note(file, notes);
    return Grid;
  }

private:
  void AddPoints(const ExodusFile& part)
  {
    HasSingles = HasSingles || (part.Nodes() > 0 && part.HasSingleCoordinates());
    HasDoubles = HasDoubles || (part.Nodes() > 0 && !part.HasSingleCoordinates());
    const std::vector<double> x = part.Coordinates(0);
    const std::vector<double> y = part.Coordinates(1);
    const std::vector<double> z = part.Coordinates(2);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      Points->InsertNextPoint(x[i], y.empty() ? 0.0 : y[i], z.empty() ? 0.0 : z[i]);
    }
  }

  /// Sets points in single precision where all parts are, so that the converter assumes
  /// single-precision roundings.
  void SetPoints()
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(HasSingles && !HasDoubles ? VTK_FLOAT : VTK_DOUBLE);
    points->GetData()->DeepCopy(Points->GetData());
    Grid->SetPoints(points);
  }

  void AddBlock(const ExodusFile& part, const Block& block)
  {
    std::string& name = BlockNames[block.id];
    name = name.empty() ? block.name : name;
    const auto cell = ExodusCellOf(block.type, block.nodes);
    if (!cell)
    {
      LeaveOut(block);
      return;
    }
    HasShells = HasShells || IsShell(block);
    const std::vector<std::int64_t> nodes = part.Connectivity(block);
    FirstCellOf[block.first] = Grid->GetNumberOfCells();
    std::vector<vtkIdType> ids(static_cast<std::size_t>(block.nodes));
    for (std::int64_t e = 0; e < block.elements; ++e)
    {
      const std::int64_t* own = nodes.data() + e * block.nodes;
      for (std::size_t k = 0; k < ids.size(); ++k)
      {
        ids[k] = FirstPoint + own[cell->order.empty() ? static_cast<int>(k) : cell->order[k]];
      }
      Grid->InsertNextCell(cell->type, block.nodes, ids.data());
      Ids.push_back(block.id);
    }
  }

  static bool IsShell(const Block& block) { return block.type.find("SHELL") != std::string::npos; }

  void LeaveOut(const Block& block)
  {
    const std::string what = "block " + std::to_string(block.id) + " has elements of type " +
      block.type + " with " + Counted(block.nodes, "node");
    if (IsExodusSolid(block.type) || block.type.starts_with("TRI") || block.type.starts_with("QUA"))
    {
      throw Unsupported(what +
        ", which no cell of VTK has; write HEX8, 20, 27, TETRA4, 10, 15, WEDGE6, 15, 18, 21, "
        "PYRAMID5, 13, TRI3, 6 or QUAD4, 8, 9");
    }
    LeftOut.push_back(what + ", which are no solids and left out.");
  }

  void AddFields(const ExodusFile& part)
  {
    if (!HasSteps)
    {
      return;
    }
    for (const ExodusField& field : JoinComponents(part.NodalNames()))
    {
      std::vector<std::vector<double>> components;
      for (std::size_t c = 0; c < field.count; ++c)
      {
        components.push_back(part.AtNodes(field.first + c, Step));
      }
      Complete(components, part.Dimensions(), part.Nodes());
      AtNodes.Append(field.name, FirstPoint, part.Nodes(), components);
    }
    for (const ExodusField& field : JoinComponents(part.ElementNames()))
    {
      for (const Block& block : part.Blocks())
      {
        AddElementValues(part, field, block);
      }
    }
  }

  void AddElementValues(const ExodusFile& part, const ExodusField& field, const Block& block)
  {
    const auto cell = FirstCellOf.find(block.first);
    if (cell == FirstCellOf.end())
    {
      return;
    }
    std::vector<std::vector<double>> components;
    bool isComplete = true;
    bool isEmpty = true;
    for (std::size_t c = 0; c < field.count; ++c)
    {
      auto values = part.OfElements(field.first + c, block, Step);
      isComplete = isComplete && values;
      isEmpty = isEmpty && !values;
      components.push_back(std::move(values).value_or(std::vector<double>()));
    }
    const int dimension = CellDimension(Grid->GetCellType(cell->second));
    if (!isComplete)
    {
      Missing[field.name][dimension].insert(block.id);
    }
    if (!isEmpty)
    {
      if (!Surfaces || dimension == 2)
      {
        Found[field.name] = std::max(Found[field.name], dimension);
      }
      Complete(components, part.Dimensions(), block.elements);
      OfElements.Append(field.name, cell->second, block.elements, components);
    }
  }

  /// Gives vectors in a plane a third component of zero.
  static void Complete(
    std::vector<std::vector<double>>& components, int dimensions, std::int64_t count)
  {
    if (components.size() == 2 && dimensions == 2)
    {
      components.emplace_back(static_cast<std::size_t>(count), 0.0);
    }
  }

  void AddSides(const ExodusFile& part)
  {
    const std::vector<Block>& blocks = part.Blocks();
    for (const ExodusFile::SideSet& set : part.SideSets())
    {
      Sides& all = SideSets[set.id];
      all.name = all.name.empty() ? set.name : all.name;
      for (std::size_t i = 0; i < set.elements.size(); ++i)
      {
        const auto block =
          std::prev(std::ranges::upper_bound(blocks, set.elements[i], {}, &Block::first));
        const auto first = FirstCellOf.find(block->first);
        const vtkIdType cell =
          first == FirstCellOf.end() ? -1 : first->second + (set.elements[i] - block->first);
        const std::span<const CellSide> sides =
          cell < 0 ? std::span<const CellSide>() : SidesOf(Grid->GetCellType(cell));
        // The first two sides of a shell are its faces.
        const std::int64_t side = set.sides[i] - (IsShell(*block) ? 2 : 0);
        if (side < 1 || side > std::ssize(sides) || set.id > kMaxId)
        {
          ++NoSides;
          continue;
        }
        all.faces.push_back(
          { { static_cast<std::int32_t>(cell), sides[static_cast<std::size_t>(side - 1)].face },
            static_cast<std::int32_t>(set.id) });
      }
    }
  }

  /// Adds the array Attribute: the number of each cell's block. It follows the file's fields,
  /// because the first field is shown by default.
  void AddAttributes()
  {
    const auto add = [this](auto& array)
    {
      array.SetName("Attribute");
      array.SetNumberOfValues(static_cast<vtkIdType>(Ids.size()));
      std::ranges::copy(Ids, array.GetPointer(0));
      Grid->GetCellData()->AddArray(&array);
    };
    if (std::ranges::all_of(Ids, [](std::int64_t id) { return id >= 0 && id <= kMaxId; }))
    {
      add(*vtkNew<vtkIntArray>());
    }
    else
    {
      add(*vtkNew<vtkTypeInt64Array>());
    }
  }

  void AddNames()
  {
    std::vector<Group> named;
    const auto add = [&named](std::int64_t id, const std::string& name, bool isBoundary)
    {
      if (!name.empty() && id <= kMaxId)
      {
        named.push_back({ static_cast<std::int32_t>(id), name, isBoundary });
      }
    };
    for (const auto& [id, name] : BlockNames)
    {
      add(id, name, false);
    }
    std::vector<AttributedFace> faces;
    for (const auto& [id, set] : SideSets)
    {
      add(id, set.name, true);
      faces.insert(faces.end(), set.faces.begin(), set.faces.end());
    }
    AddSourceFaces(faces, Grid);
    AddGroupNames(named, Grid);
  }

  void Note(const std::string& file, std::vector<std::string>& notes)
  {
    const auto add = [&](const std::string& line) { notes.push_back("'" + file + "': " + line); };
    std::ranges::for_each(LeftOut, add);
    const bool showsShells = HasShells && (Surfaces || HighestDimension(DimensionsOf(Grid)) == 2);
    if (showsShells)
    {
      add("its shells are surfaces without their thickness.");
    }
    for (const auto& [name, byDimension] : Missing)
    {
      const auto found = Found.find(name);
      const auto missing =
        found == Found.end() ? byDimension.end() : byDimension.find(found->second);
      if (found == Found.end())
      {
        add("the field '" + name +
          (Surfaces ? "' has values in no block of surfaces."
                    : "' has values in no block and is left out."));
      }
      else if (missing != byDimension.end())
      {
        std::string list;
        for (const std::int64_t id : missing->second)
        {
          list.append(list.empty() ? "" : ", ").append(std::to_string(id));
        }
        std::string note = "the field '";
        note.append(name)
          .append("' has no values in ")
          .append(missing->second.size() == 1 ? "block " : "blocks ")
          .append(list)
          .append("; it is NaN there.");
        add(note);
      }
    }
    if (HasSingles && HasDoubles)
    {
      add(
        "some parts have coordinates in single precision; the rounding of these is not counted as "
        "an error of the mesh.");
    }
    if (NoSides > 0)
    {
      notes.push_back(Counted(NoSides, "side") +
        " of side sets are no faces of solids or plane elements and were left out.");
    }
    for (int i = 0; i < Grid->GetPointData()->GetNumberOfArrays(); ++i)
    {
      const std::string name = Grid->GetPointData()->GetArrayName(i);
      std::string lower = name;
      std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
      if (lower.starts_with("dis"))
      {
        notes.push_back("the displacements '" + name +
          "' are a field; the mesh is shown where the file has it, not displaced.");
      }
    }
    if (NodeSets > 0)
    {
      add(Counted(NodeSets, "node set") + ", which name points and no faces, are left out.");
    }
  }

  std::size_t Step;
  bool Surfaces; ///< the elements of surfaces are shown, and not the solids
  bool HasSteps = false;
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkPoints> Points; ///< in double precision
  bool HasSingles = false;
  bool HasDoubles = false;
  GrowingFields AtNodes;
  GrowingFields OfElements;
  std::vector<std::int64_t> Ids; ///< blocks of the cells
  bool HasShells = false;
  std::map<std::int64_t, std::string> BlockNames;
  std::map<std::int64_t, Sides> SideSets;
  std::vector<std::string> LeftOut;
  /// Per field: blocks without values, by the dimension of their elements, and the largest
  /// dimension of elements with values.
  std::map<std::string, std::map<int, std::set<std::int64_t>>> Missing;
  std::map<std::string, int> Found;
  std::size_t NoSides = 0;
  std::int64_t NodeSets = 0; ///< of one part
  // The next two members belong to the part that Add reads.
  vtkIdType FirstPoint = 0;
  std::map<std::int64_t, vtkIdType> FirstCellOf; ///< of a block, by its first element
};

/// Calls `read`. Prefixes its exceptions with the file's name.
template <class Read>
auto Naming(const std::string& file, const Read& read)
{
  const auto fail = [&](const char* why) { return Error("cannot read '" + file + "': " + why); };
  try
  {
    return read();
  }
  catch (const Error& error)
  {
    throw fail(error.what());
  }
  catch (const std::bad_alloc&)
  {
    throw fail("it asks for more memory than there is");
  }
}
} // namespace

std::vector<double> ExodusTimes(const std::string& file)
{
  return Naming(file, [&] { return ExodusFile(file).Times(); });
}

vtkSmartPointer<vtkUnstructuredGrid> ReadExodusGrid(const std::vector<std::string>& files,
  std::size_t step, bool surfaces, std::vector<std::string>& notes)
{
  GridBuilder builder(step, surfaces);
  for (const std::string& file : files)
  {
    Naming(file, [&] { builder.Add(file); });
  }
  return Naming(files.front(), [&] { return builder.Finish(files.front(), notes); });
}
} // namespace pixelexact
