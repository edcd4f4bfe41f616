// SPDX-License-Identifier: BSD-3-Clause
#include "Files/GridFiles.h"

#include "Conversion/GridCheck.h"
#include "Core/Base/Error.h"
#include "Grids/ReaderMessages.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <filesystem>
#include <new>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

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
} // namespace

std::string CannotRead(const GridPart& part)
{
  return "cannot read '" + part.file + "'" +
    (part.list.empty() ? "" : ", which '" + part.list + "' names") + ": ";
}

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
        CannotRead(file) + "only .vtu and .pvtu files can be parts of a grid; write it as such");
    }
  }
  if (files.empty())
  {
    throw Error(CannotRead(parts.front()) + "it holds no volume");
  }
  return files;
}

vtkSmartPointer<vtkUnstructuredGrid> GridFileReader::Read(const GridPart& part)
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
    throw Error(CannotRead(part) + error.what());
  }
  catch (const std::bad_alloc&)
  {
    // A damaged header asks for any amount; so does a file that is too large.
    throw Error(CannotRead(part) + "it asks for more memory than there is");
  }
}
} // namespace pixelexact
