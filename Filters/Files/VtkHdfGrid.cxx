// SPDX-License-Identifier: BSD-3-Clause
#include "Files/VtkHdfGrid.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/VtkHdf/VtkHdfFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

namespace pixelexact
{
namespace
{
using HdfGrid = vtkSmartPointer<vtkUnstructuredGrid>;
using HdfArray = vtkSmartPointer<vtkDataArray>;

/// VTK's number for the type in which an array's values are exact.
int VtkTypeOf(Hdf5Kind kind, std::size_t bytes)
{
  if (kind == Hdf5Kind::Reals)
  {
    return bytes <= sizeof(float) ? VTK_FLOAT : VTK_DOUBLE;
  }
  const bool hasSign = kind == Hdf5Kind::Integers;
  switch (bytes)
  {
    case 1:
      return hasSign ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 2:
      return hasSign ? VTK_SHORT : VTK_UNSIGNED_SHORT;
    case 4:
      return hasSign ? VTK_INT : VTK_UNSIGNED_INT;
    default:
      return hasSign ? VTK_TYPE_INT64 : VTK_TYPE_UINT64;
  }
}

template <class Value>
void CopyAll(const std::vector<Value>& values, vtkDataArray& array)
{
  const auto copy = [&values](auto* to)
  {
    using To = std::remove_pointer_t<decltype(to)>;
    std::ranges::transform(values, to, [](Value value) { return static_cast<To>(value); });
  };
  switch (array.GetDataType())
  {
    vtkTemplateMacro(copy(static_cast<VTK_TT*>(array.GetVoidPointer(0))));
    default:
      break;
  }
}

HdfArray ReadRows(const Hdf5File& file, const VtkHdfArray& from, const Hdf5Rows& rows)
{
  auto array = HdfArray::Take(vtkDataArray::CreateDataArray(VtkTypeOf(from.kind, from.bytes)));
  array->SetName(from.name.c_str());
  array->SetNumberOfComponents(static_cast<int>(std::max<std::size_t>(from.components, 1)));
  const auto fill = [&](const auto& values)
  {
    if (from.components == 0 || values.size() != rows.count * from.components)
    {
      throw InvalidData(from.path + ": it has rows without values; write the file again");
    }
    array->SetNumberOfTuples(static_cast<vtkIdType>(rows.count));
    CopyAll(values, *array);
  };
  switch (from.kind)
  {
    case Hdf5Kind::Reals:
      fill(file.Reals(from.path, rows));
      break;
    case Hdf5Kind::Unsigned:
      fill(file.Unsigned(from.path, rows));
      break;
    default:
      fill(file.Integers(from.path, rows));
      break;
  }
  return array;
}

bool AreEqual(std::string_view a, std::string_view b)
{
  return std::ranges::equal(
    a, b, {}, [](unsigned char c) { return std::tolower(c); },
    [](unsigned char c) { return std::tolower(c); });
}

/// The number of an attribute of VTK with this name; -1: there is none.
int PurposeOf(const std::string& attribute)
{
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    if (AreEqual(attribute, vtkDataSetAttributes::GetAttributeTypeAsString(type)))
    {
      return type;
    }
  }
  return -1;
}

/// Reads one step of a file.
class PartReader
{
public:
  PartReader(const VtkHdfFile& file, std::size_t step, std::vector<std::string>& notes)
    : File(file)
    , Step(step)
    , Notes(notes)
  {
  }

  std::vector<HdfGrid> Read()
  {
    std::vector<HdfGrid> grids;
    for (std::size_t block = 0; block < File.BlockCount(); ++block)
    {
      const auto points = ArraysOf(block, "PointData");
      const auto cells = ArraysOf(block, "CellData");
      const auto whole = ArraysOf(block, "FieldData");
      for (const VtkHdfPart& part : File.Parts(block, Step))
      {
        HdfGrid grid = HdfGrid::New();
        AddPoints(block, part, *grid);
        AddCells(block, part, *grid);
        AddArrays(block, "PointData", points, part.points, *grid->GetPointData());
        AddArrays(block, "CellData", cells, part.cells, *grid->GetCellData());
        AddFieldData(block, whole, *grid->GetFieldData());
        grids.push_back(grid);
      }
    }
    return grids;
  }

private:
  void Note(const std::string& line)
  {
    if (Noted.insert(line).second)
    {
      Notes.push_back(line);
    }
  }

  std::vector<VtkHdfArray> ArraysOf(std::size_t block, const std::string& group)
  {
    std::vector<std::string> notes;
    auto arrays = File.Arrays(block, group, notes);
    std::ranges::for_each(notes, [this](const std::string& line) { Note(line); });
    for (VtkHdfArray& array : arrays)
    {
      if (array.kind == Hdf5Kind::Reals && array.bytes > sizeof(double))
      {
        Note("'" + array.name + "' has more than double precision and is rounded to double.");
      }
      // VTK's writer of some versions leaves out what the array is for.
      const bool isWeights = group == "PointData" && array.name == "RationalWeights";
      const bool isDegrees = group == "CellData" && array.name == "HigherOrderDegrees";
      if (array.attribute.empty() &&
        ((isWeights && array.components == 1) || (isDegrees && array.components == 3)))
      {
        array.attribute = array.name;
        Note("the array '" + array.name +
          "' is not marked in the file, and is used as VTK uses one of that name; rename it where "
          "it is a field.");
      }
    }
    return arrays;
  }

  void AddPoints(std::size_t block, const VtkHdfPart& part, vtkUnstructuredGrid& grid) const
  {
    const std::vector<double> values = File.Points(block, part);
    vtkNew<vtkPoints> points;
    points->SetDataType(File.HasSinglePoints(block) ? VTK_FLOAT : VTK_DOUBLE);
    points->SetNumberOfPoints(static_cast<vtkIdType>(part.points.count));
    CopyAll(values, *points->GetData());
    grid.SetPoints(points);
  }

  void AddCells(std::size_t block, const VtkHdfPart& part, vtkUnstructuredGrid& grid) const
  {
    const auto types = File.Types(block, part.cells);
    if (const auto polyhedra = std::ranges::count(types, std::uint64_t{ VTK_POLYHEDRON });
        polyhedra > 0)
    {
      throw Unsupported(Counted(polyhedra, "cell") +
        " of it are polyhedra, which have no polynomial basis; cut them into tetrahedra (ParaView: "
        "Tetrahedralize)");
    }
    const auto offsets = File.Offsets(block, part);
    const auto points = File.Connectivity(block, part);
    vtkNew<vtkUnsignedCharArray> kinds;
    kinds->SetNumberOfValues(static_cast<vtkIdType>(types.size()));
    CopyAll(types, *kinds);
    const auto stored = [](const std::vector<std::int64_t>& numbers)
    {
      auto array = vtkSmartPointer<vtkTypeInt64Array>::New();
      array->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
      std::ranges::copy(numbers, array->GetPointer(0));
      return array;
    };
    vtkNew<vtkCellArray> cells;
    cells->SetData(stored(offsets), stored(points));
    grid.SetCells(kinds, cells);
  }

  void AddArrays(std::size_t block, const std::string& group,
    const std::vector<VtkHdfArray>& arrays, const Hdf5Rows& entities,
    vtkDataSetAttributes& data) const
  {
    for (const VtkHdfArray& from : arrays)
    {
      const std::size_t first = File.FirstRow(block, group, from, Step, entities.first);
      data.AddArray(ReadRows(File.File(), from, { first, entities.count }));
      const int purpose = PurposeOf(from.attribute);
      if (purpose < 0)
      {
        continue;
      }
      const bool isAccepted = data.SetActiveAttribute(from.name.c_str(), purpose) >= 0;
      const bool isNeeded = purpose == vtkDataSetAttributes::RATIONALWEIGHTS ||
        purpose == vtkDataSetAttributes::HIGHERORDERDEGREES;
      if (!isAccepted && isNeeded)
      {
        throw InvalidData(from.path + ": it is marked as " + from.attribute + ", but has " +
          Counted(from.components, "component") + "; write the file again");
      }
    }
  }

  void AddFieldData(
    std::size_t block, const std::vector<VtkHdfArray>& arrays, vtkFieldData& data) const
  {
    for (const VtkHdfArray& from : arrays)
    {
      if (from.kind != Hdf5Kind::Texts)
      {
        data.AddArray(ReadRows(File.File(), from, File.FieldRows(block, from, Step)));
        continue;
      }
      vtkNew<vtkStringArray> texts;
      texts->SetName(from.name.c_str());
      for (const std::string& text : File.File().Texts(from.path))
      {
        texts->InsertNextValue(text);
      }
      data.AddArray(texts);
    }
  }

  const VtkHdfFile& File;
  std::size_t Step;
  std::vector<std::string>& Notes;
  std::set<std::string> Noted;
};
} // namespace

std::vector<double> VtkHdfTimes(const std::string& file)
{
  return VtkHdfFile(file).Times();
}

std::vector<HdfGrid> ReadVtkHdfParts(
  const std::string& file, std::size_t step, std::vector<std::string>& notes)
{
  const VtkHdfFile opened(file);
  if (step >= std::max<std::size_t>(opened.Times().size(), 1))
  {
    throw InvalidData("it has no time step " + std::to_string(step) + " any more; read it again");
  }
  notes.insert(notes.end(), opened.Notes().begin(), opened.Notes().end());
  std::vector<HdfGrid> grids = PartReader(opened, step, notes).Read();
  if (grids.empty())
  {
    throw InvalidData(
      "its time step " + std::to_string(step) + " has no parts; choose another one (--time-step)");
  }
  return grids;
}

bool HasCurvedVtkHdfCells(const std::string& file)
{
  const auto isCurved = [](std::uint64_t type)
  {
    return (type >= VTK_QUADRATIC_EDGE && type <= VTK_TRIQUADRATIC_PYRAMID) ||
      (type >= VTK_LAGRANGE_CURVE && type <= VTK_BEZIER_PYRAMID);
  };
  try
  {
    const VtkHdfFile opened(file);
    for (std::size_t block = 0; block < opened.BlockCount(); ++block)
    {
      for (const VtkHdfPart& part : opened.Parts(block, 0))
      {
        if (std::ranges::any_of(opened.Types(block, part.cells), isCurved))
        {
          return true;
        }
      }
    }
  }
  catch (const std::exception&)
  {
    return false; // the reader reports it
  }
  return false;
}
} // namespace pixelexact
