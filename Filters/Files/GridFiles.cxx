// SPDX-License-Identifier: BSD-3-Clause
#include "Files/GridFiles.h"

#include "Conversion/SourceCells.h"
#include "Core/Base/Error.h"
#include "Files/VtkHdfGrid.h"
#include "Formats/FileText.h"
#include "Formats/Hdf5/Hdf5File.h"
#include "Grids/GridCopies.h"
#include "HighOrderArrays.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGridReader.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <tuple>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// Reads one piece of a file as if it were the only one. VTK's way of joining pieces changes some:
/// below version 2.1 it permutes the higher-order hexahedra of a piece once more for each piece
/// after it; it takes arrays by their places and types in the first piece; and ghost levels of
/// later pieces stay levels.
class PieceReader : public vtkXMLUnstructuredGridReader
{
public:
  static PieceReader* New();
  vtkTypeMacro(PieceReader, vtkXMLUnstructuredGridReader);

protected:
  void ReadXMLData() override
  {
    const int piece = this->GetCurrentOutputInformation()->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
    if (piece <= 0 || piece >= this->NumberOfPieces)
    {
      this->Superclass::ReadXMLData();
      return;
    }
    // The superclasses take what arrays there are from the first piece.
    const auto first = std::tuple(this->NumberOfPoints[0], this->PointElements[0],
      this->PointDataElements[0], this->CellDataElements[0]);
    this->NumberOfPoints[0] = this->NumberOfPoints[piece];
    this->PointElements[0] = this->PointElements[piece];
    this->PointDataElements[0] = this->PointDataElements[piece];
    this->CellDataElements[0] = this->CellDataElements[piece];
    this->SetDataArraySelections(this->PointDataElements[0], this->PointDataArraySelection);
    this->SetDataArraySelections(this->CellDataElements[0], this->CellDataArraySelection);
    this->Superclass::ReadXMLData();
    std::tie(this->NumberOfPoints[0], this->PointElements[0], this->PointDataElements[0],
      this->CellDataElements[0]) = first;
  }
};
vtkStandardNewMacro(PieceReader);

void CheckDone(vtkAlgorithm& reader, const ReaderMessages& messages)
{
  const unsigned long code = reader.GetErrorCode();
  if (!messages.error.empty())
  {
    throw InvalidData(messages.error);
  }
  if (code != vtkErrorCode::NoError)
  {
    throw InvalidData(vtkErrorCode::GetStringFromErrorCode(code));
  }
}

/// Reads all pieces, also those without cells.
std::vector<Grid> ReadXml(const std::string& file, std::vector<std::string>& warnings)
{
  const vtkNew<PieceReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    throw InvalidData(
      "it is neither a VTK XML file of type UnstructuredGrid nor a legacy VTK file, or cut short");
  }
  const vtkNew<ReaderMessages> messages;
  messages->Watch(reader);
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  const int count = std::max(static_cast<int>(reader->GetNumberOfPieces()), 1);
  std::vector<Grid> pieces;
  for (int piece = 0; piece < count; ++piece)
  {
    reader->UpdatePiece(piece, count, 0);
    CheckDone(*reader, *messages);
    pieces.push_back(Grid::New());
    pieces.back()->ShallowCopy(reader->GetOutput());
    CheckConsistency(*pieces.back());
    if (count > 1 && HasHighOrderArrays(pieces.back()))
    {
      // Its coefficients are of all pieces together.
      reader->UpdatePiece(0, 1, 0);
      CheckDone(*reader, *messages);
      pieces = { reader->GetOutput() };
      CheckConsistency(*pieces.back());
      break;
    }
  }
  warnings = messages->warnings;
  return pieces;
}

/// ", but POLYDATA; ...": what else a legacy file holds; empty where that is not known.
std::string DescribeDataset(const std::string& file)
{
  constexpr int kHead = 6; // lines
  std::ifstream stream(file);
  std::string line;
  for (int i = 0; i < kHead && std::getline(stream, line); ++i)
  {
    std::istringstream words(line);
    std::string key;
    std::string what;
    if (words >> key >> what && (key == "DATASET" || key == "FIELD"))
    {
      return ", but " + (key == "FIELD" ? key : what) +
        "; make one of its cells (vtkAppendFilter; ParaView: Append Datasets) and write that";
    }
  }
  return {};
}

Grid ReadLegacy(const std::string& file, std::vector<std::string>& warnings)
{
  const vtkNew<vtkUnstructuredGridReader> reader;
  const vtkNew<ReaderMessages> messages;
  reader->AddObserver(vtkCommand::ErrorEvent, messages);
  reader->AddObserver(vtkCommand::WarningEvent, messages);
  reader->SetFileName(file.c_str());
  if (!reader->IsFileUnstructuredGrid())
  {
    throw InvalidData(
      "it is not a legacy VTK file that holds an UNSTRUCTURED_GRID" + DescribeDataset(file));
  }
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  CheckDone(*reader, *messages);
  Grid grid = reader->GetOutput();
  CheckConsistency(*grid);
  warnings = messages->warnings;
  return grid;
}

/// Reads the parts of a file in VTK's HDF format.
std::vector<Grid> ReadHdf(const GridPart& part, std::vector<std::string>& warnings)
{
  if (!part.list.empty() && VtkHdfTimes(part.file).size() > 1)
  {
    throw Unsupported("it has several time steps, and the list gives it one time; name it alone");
  }
  std::vector<Grid> pieces = ReadVtkHdfParts(part.file, part.step, warnings);
  for (std::string& warning : warnings)
  {
    warning.erase(warning.find_last_not_of('.') + 1);
  }
  std::ranges::for_each(pieces, [](const Grid& piece) { CheckConsistency(*piece); });
  if (pieces.size() > 1 && HasHighOrderArrays(pieces.front()))
  {
    // Its coefficients are of all pieces together.
    const Grid whole = AppendedGrids(pieces);
    whole->GetFieldData()->ShallowCopy(pieces.front()->GetFieldData());
    CheckConsistency(*whole);
    return { whole };
  }
  return pieces;
}

std::vector<Grid> ReadPiecesOf(const GridPart& part, std::vector<std::string>& warnings)
{
  constexpr std::string_view kLegacyMark = "# vtk DataFile";
  std::string begin(kLegacyMark.size(), '\0');
  std::ifstream(part.file, std::ios::binary)
    .read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (IsHdf5(begin) || IsVtkHdfName(part.file))
  {
    return ReadHdf(part, warnings);
  }
  return begin == kLegacyMark ? std::vector{ ReadLegacy(part.file, warnings) }
                              : ReadXml(part.file, warnings);
}
} // namespace

void ReaderMessages::Execute(vtkObject* /*caller*/, unsigned long event, void* data)
{
  const std::string_view message = data ? static_cast<const char*>(data) : "";
  if (event == vtkCommand::WarningEvent)
  {
    AddWarning(warnings, message);
  }
  else if (error.empty())
  {
    error = MessageEssence(message);
  }
}

void ReaderMessages::Watch(vtkXMLReader* reader)
{
  reader->SetReaderErrorObserver(this);
  reader->SetParserErrorObserver(this);
  reader->AddObserver(vtkCommand::WarningEvent, this);
}

std::string MessageEssence(std::string_view text)
{
  if (const auto line = text.find('\n'); line != std::string_view::npos)
  {
    text.remove_prefix(line + 1);
  }
  if (const auto object = text.find("): "); object != std::string_view::npos)
  {
    text.remove_prefix(object + 3);
  }
  std::string essence;
  for (const char c : text)
  {
    const bool space = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!space)
    {
      essence += c;
    }
    else if (!essence.empty() && essence.back() != ' ')
    {
      essence += ' ';
    }
  }
  while (!essence.empty() && (essence.back() == ' ' || essence.back() == '.'))
  {
    essence.pop_back();
  }
  return essence;
}

void AddWarning(std::vector<std::string>& lines, std::string_view text)
{
  const std::string essence = MessageEssence(text);
  if (!essence.starts_with("Could not locate key vtkExodusIIReader::"))
  {
    AddOnce(lines, essence);
  }
}

void AddOnce(std::vector<std::string>& lines, const std::string& line)
{
  if (std::ranges::find(lines, line) == lines.end())
  {
    lines.push_back(line);
  }
}

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
    const std::string suffix = LowerSuffix(file.file);
    if (suffix != ".vtu" && suffix != ".vtk" && !IsVtkHdfName(file.file))
    {
      throw Unsupported(CannotRead(file) +
        "only .vtu, .pvtu, .vtk and .vtkhdf files can be parts of a grid; write it as such");
    }
  }
  if (files.empty())
  {
    throw Error(CannotRead(parts.front()) + "it holds no volume");
  }
  return files;
}

std::vector<Grid> GridFileReader::Read(const GridPart& part)
{
  try
  {
    std::error_code failure;
    if (!std::filesystem::exists(part.file, failure))
    {
      throw InvalidData("there is no such file");
    }
    if (IsPipeOrDevice(part.file))
    {
      throw InvalidData(kPipeRemedy);
    }
    std::vector<std::string> warnings;
    std::vector<Grid> pieces = ReadPiecesOf(part, warnings);
    for (const std::string& warning : warnings)
    {
      if (Said.insert(warning).second)
      {
        Notes.emplace_back("'").append(part.file).append("': ").append(warning).append(".");
      }
    }
    const auto idle = std::remove_if(
      pieces.begin(), pieces.end(), [](const Grid& grid) { return grid->GetNumberOfCells() == 0; });
    pieces.erase(idle == pieces.begin() ? idle + 1 : idle, pieces.end());
    return pieces;
  }
  catch (const Error& error)
  {
    throw Error(CannotRead(part) + error.what());
  }
  catch (const std::bad_alloc&)
  {
    // A damaged header may request any amount of memory, and so does a file that is too large.
    throw Error(CannotRead(part) + "it asks for more memory than there is");
  }
}
} // namespace pixelexact
