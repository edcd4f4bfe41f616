// SPDX-License-Identifier: BSD-3-Clause
#include "Input.h"

#include "Command.h"
#include "VtkMessages.h"

#include "Core/Base/Error.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <new>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Files = std::vector<std::string>;

[[noreturn]] void CannotRead(const std::string& file, const std::string& why)
{
  throw Error("cannot read '" + file + "': " + why);
}

/// What the operating system can tell before a reader guesses.
void CheckFile(const std::string& file)
{
  std::error_code failure;
  const auto status = std::filesystem::status(file, failure);
  if (!std::filesystem::exists(status))
  {
    CannotRead(file, "there is no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    CannotRead(file, "it is a folder; name a file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    CannotRead(file, "it cannot be opened; check its permissions");
  }
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    CannotRead(file, "it is empty");
  }
}

void CheckAlone(const Files& files)
{
  if (files.size() > 1)
  {
    throw UsageError("'" + files[0] + "' holds mesh and fields, but " +
      std::to_string(files.size()) + " files were given; name it alone");
  }
}

/// Cells that point beyond the points and arrays of other lengths than their data set's would be
/// read out of bounds later.
void CheckConsistency(vtkUnstructuredGrid& grid)
{
  const vtkIdType points = grid.GetNumberOfPoints();
  const vtkIdType cells = grid.GetNumberOfCells();
  // A file that ends before its cells leaves none of the arrays.
  if (vtkCellArray* connectivity = cells > 0 ? grid.GetCells() : nullptr)
  {
    if (grid.GetCellTypesArray()->GetNumberOfTuples() != cells)
    {
      throw InvalidData("the numbers of cells and of cell types differ");
    }
    if (!connectivity->IsValid())
    {
      throw InvalidData("the offsets of its cells do not fit their list of points");
    }
    vtkIdType cell = 0;
    const auto iterator = vtk::TakeSmartPointer(connectivity->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
         iterator->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(count, ids);
      if (std::any_of(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; }))
      {
        throw InvalidData(
          "cell " + std::to_string(cell) + " has a point that the file does not hold");
      }
    }
  }
  const auto checkArrays = [](vtkDataSetAttributes& data, vtkIdType expected, const char* what)
  {
    for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    {
      const vtkAbstractArray* array = data.GetAbstractArray(i);
      if (array->GetNumberOfTuples() != expected)
      {
        const char* name = data.GetArrayName(i);
        throw InvalidData(std::string(what) + " array '" + (name != nullptr ? name : "") +
          "' holds " + std::to_string(array->GetNumberOfTuples()) + " values for " +
          std::to_string(expected) + " " + what + "s");
      }
    }
  };
  checkArrays(*grid.GetPointData(), points, "point");
  checkArrays(*grid.GetCellData(), cells, "cell");
}

template <class Reader>
Grid ReadWith(Reader& reader, const std::string& file)
{
  const VtkMessages messages;
  reader.SetFileName(file.c_str());
  reader.Update();
  if (const std::string error = messages.FirstError(); !error.empty())
  {
    CannotRead(file, error);
  }
  if (reader.GetErrorCode() != vtkErrorCode::NoError)
  {
    CannotRead(file, vtkErrorCode::GetStringFromErrorCode(reader.GetErrorCode()));
  }
  // Readers warn of what they leave out: the rest is not what the file's author meant.
  if (const std::string warning = messages.FirstWarning(); !warning.empty())
  {
    CannotRead(file, warning);
  }
  return reader.GetOutput();
}

Grid ReadXml(const Files& files)
{
  CheckAlone(files);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  if (!reader->CanReadFile(files[0].c_str()))
  {
    CannotRead(files[0], "it is not a VTK XML file of type UnstructuredGrid, or cut short");
  }
  return ReadWith(*reader, files[0]);
}

Grid ReadLegacy(const Files& files)
{
  CheckAlone(files);
  vtkNew<vtkUnstructuredGridReader> reader;
  {
    const VtkMessages messages;
    reader->SetFileName(files[0].c_str());
    if (!reader->IsFileUnstructuredGrid())
    {
      CannotRead(files[0], "it is not a legacy VTK file that holds an UNSTRUCTURED_GRID");
    }
  }
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllFieldsOn();
  return ReadWith(*reader, files[0]);
}

Grid NotYet(const Files& files)
{
  CannotRead(files[0],
    "files of this kind are not supported yet; "
    "write it as .vtu with Lagrange cells");
}

// A new format is a line here and a function above.
struct Format
{
  const char* suffix;
  const char* what;
  Grid (*read)(const Files&);
};
constexpr std::array kFormats{
  Format{ ".vtu", "VTK XML", &ReadXml },
  Format{ ".vtk", "VTK legacy", &ReadLegacy },
  Format{ ".mesh", "MFEM", &NotYet },
  Format{ ".gf", "MFEM", &NotYet },
  Format{ ".saved", "GLVis", &NotYet },
  Format{ ".xml", "Nektar++", &NotYet },
  Format{ ".fld", "Nektar++", &NotYet },
  Format{ ".chk", "Nektar++", &NotYet },
  Format{ ".rst", "Nektar++", &NotYet },
};

std::string LowerSuffix(const std::string& file)
{
  std::string suffix = std::filesystem::path(file).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}
} // namespace

vtkSmartPointer<vtkUnstructuredGrid> ReadInput(const std::vector<std::string>& files)
{
  for (const std::string& file : files)
  {
    CheckFile(file);
  }
  const std::string suffix = LowerSuffix(files[0]);
  const auto format = std::find_if(kFormats.begin(), kFormats.end(),
    [&suffix](const Format& candidate) { return suffix == candidate.suffix; });
  if (format == kFormats.end())
  {
    CannotRead(files[0], "its suffix is of no format known here; .vtu and .vtk are read");
  }
  try
  {
    Grid grid = format->read(files);
    CheckConsistency(*grid);
    return grid;
  }
  catch (const InvalidData& error)
  {
    CannotRead(files[0], error.what());
  }
  catch (const std::bad_alloc&)
  {
    // A damaged header asks for any amount; so does a file that is too large.
    CannotRead(files[0], "it asks for more memory than there is");
  }
}

void AddInputOption(CLI::App& command, std::vector<std::string>& files)
{
  command
    .add_option("INPUT", files,
      "The mesh file (.vtu or .vtk) and, where the format keeps them apart, its field files")
    ->required()
    ->type_name("FILE");
}
} // namespace pixelexact
