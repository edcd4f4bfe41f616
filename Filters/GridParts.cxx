// SPDX-License-Identifier: BSD-3-Clause
#include "GridParts.h"

#include "CellBasis.h"
#include "Core/Base/Error.h"
#include "GridCheck.h"
#include "HighOrderArrays.h"
#include "OutputGrid.h"
#include "ReaderMessages.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <set>
#include <utility>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

std::string Cannot(const GridPart& part)
{
  return "cannot read '" + part.file + "'" +
    (part.list.empty() ? "" : ", which '" + part.list + "' names") + ": ";
}

Grid ReadXml(const std::string& file, std::vector<std::string>& warnings)
{
  std::error_code failure;
  if (!std::filesystem::exists(file, failure))
  {
    throw InvalidData("there is no such file");
  }
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    throw InvalidData("it is not a VTK XML file of type UnstructuredGrid, or cut short");
  }
  vtkNew<ReaderMessages> messages;
  messages->Watch(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (!messages->error.empty())
  {
    throw InvalidData(messages->error);
  }
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InvalidData(vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
  }
  Grid grid = reader->GetOutput();
  CheckConsistency(*grid);
  warnings = messages->warnings;
  return grid;
}

/// VTK's warnings become notes. What several parts have alike is said of the first one.
class PartReader
{
public:
  explicit PartReader(std::vector<std::string>& notes)
    : Notes(notes)
  {
  }
  Grid Read(const GridPart& part);

private:
  std::vector<std::string>& Notes;
  std::set<std::string> Said;
};

Grid PartReader::Read(const GridPart& part)
{
  try
  {
    std::vector<std::string> warnings;
    Grid grid = ReadXml(part.file, warnings);
    for (const std::string& warning : warnings)
    {
      if (Said.insert(warning).second)
      {
        Notes.emplace_back("'").append(part.file).append("': ").append(warning).append(".");
      }
    }
    return grid;
  }
  catch (const Error& error)
  {
    throw Error(Cannot(part) + error.what());
  }
  catch (const std::bad_alloc&)
  {
    // A damaged header asks for any amount; so does a file that is too large.
    throw Error(Cannot(part) + "it asks for more memory than there is");
  }
}

/// The .vtu files of all parts. Surfaces (.vtp) that a collection lists beside the volume are
/// noted.
std::vector<GridPart> ListFiles(const std::vector<GridPart>& parts, std::vector<std::string>& notes)
{
  std::vector<GridPart> files;
  for (const auto& part : parts)
  {
    const std::string suffix = LowerSuffix(part.file);
    if (suffix == ".pvtu")
    {
      const auto pieces = ReadPieces(part);
      files.insert(files.end(), pieces.begin(), pieces.end());
    }
    else if (suffix == ".vtp" || suffix == ".pvtp")
    {
      notes.push_back("'" + part.file + "' holds surfaces and is left out.");
    }
    else
    {
      files.push_back(part);
    }
  }
  for (const auto& file : files)
  {
    if (LowerSuffix(file.file) != ".vtu")
    {
      throw Unsupported(
        Cannot(file) + "only .vtu and .pvtu files can be parts of a grid; write it as such");
    }
  }
  if (files.empty())
  {
    throw Error(Cannot(parts.front()) + "it holds no volume");
  }
  return files;
}

/// The highest of its cells; 0: there is none.
int DimensionOf(vtkUnstructuredGrid* grid)
{
  // Cell by cell: what VTK has for the types that there are differs between its versions.
  int highest = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells() && highest < 3; ++cell)
  {
    const int dimension = CellDimension(grid->GetCellType(cell));
    // Unknown: the converter says what it is.
    highest = std::max(highest, dimension < 0 ? 3 : dimension);
  }
  return highest;
}

/// Takes out what only a grid of one part may have.
void StripPart(const GridPart& part, vtkUnstructuredGrid* grid)
{
  if (HasSolverCoefficients(grid))
  {
    throw Unsupported(Cannot(part) +
      "it carries a solver's own coefficients, which are not put together from several parts; "
      "write one file per time step");
  }
  RemoveHighOrderArrays(grid);
  vtkDataArray* ghosts = grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; ghosts && cell < grid->GetNumberOfCells(); ++cell)
  {
    if ((static_cast<int>(ghosts->GetComponent(cell, 0)) & vtkDataSetAttributes::DUPLICATECELL) !=
      0)
    {
      grid->RemoveGhostCells();
      return;
    }
  }
}

using Names = std::set<std::pair<std::string, std::string>>; // kind, name
Names ArrayNames(vtkUnstructuredGrid* grid)
{
  Names names;
  const auto add = [&names](const char* kind, vtkDataSetAttributes* data)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      names.emplace(kind, data->GetArrayName(i) ? data->GetArrayName(i) : "");
    }
  };
  add("point", grid->GetPointData());
  add("cell", grid->GetCellData());
  return names;
}

Grid Append(const std::vector<Grid>& grids, std::vector<std::string>& notes)
{
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOff();
  append->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  Names names;
  for (const auto& grid : grids)
  {
    append->AddInputData(grid);
    names.merge(ArrayNames(grid));
  }
  append->Update();
  const Names kept = ArrayNames(append->GetOutput());
  for (const auto& [kind, name] : names)
  {
    if (!kept.contains({ kind, name }))
    {
      notes.emplace_back("the ")
        .append(kind)
        .append(" array '")
        .append(name)
        .append("' is not in all parts alike and is left out.");
    }
  }
  return append->GetOutput();
}
} // namespace

ReadGrid ReadParts(const std::vector<GridPart>& parts)
{
  ReadGrid result;
  const auto files = ListFiles(parts, result.notes);
  PartReader reader(result.notes);
  if (files.size() == 1)
  {
    result.grid = reader.Read(files[0]);
    return result;
  }
  std::vector<std::pair<Grid, int>> read; // and its dimension
  int dimension = 0;
  for (const auto& file : files)
  {
    const Grid grid = reader.Read(file);
    StripPart(file, grid);
    read.emplace_back(grid, DimensionOf(grid));
    dimension = std::max(dimension, read.back().second);
  }
  if (dimension < 2)
  {
    throw Error(Cannot(parts.front()) + "it holds no volume and no plane mesh");
  }
  std::vector<Grid> volumes;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const auto& [grid, own] = read[i];
    if (own == dimension)
    {
      volumes.push_back(grid);
    }
    else if (grid->GetNumberOfCells() > 0) // an idle process writes an empty file
    {
      result.notes.push_back("'" + files[i].file +
        (dimension == 3 ? "' holds no volume and is left out."
                        : "' holds nothing of two dimensions and is left out."));
    }
  }
  result.grid = volumes.size() == 1 ? volumes[0] : Append(volumes, result.notes);
  return result;
}
} // namespace pixelexact
