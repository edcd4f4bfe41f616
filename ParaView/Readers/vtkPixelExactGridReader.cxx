// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactGridReader.h"

#include "ConversionLoss.h"
#include "Files/TimeSeries.h"
#include "Files/VtkHdfGrid.h"
#include "HighOrderArrays.h"
#include "vtkHighOrderSeriesReader.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "Formats/FileText.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataArraySelection.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>

vtkStandardNewMacro(vtkPixelExactGridReader);

namespace
{
constexpr std::size_t kHead = std::size_t{ 1 } << 16U;

/// Reads only the cells' types of a .vtu.
class CellTypes : public vtkXMLUnstructuredGridReader
{
public:
  vtkTypeMacro(CellTypes, vtkXMLUnstructuredGridReader);
  static CellTypes* New()
  {
    auto* const made = new CellTypes;
    made->InitializeObjectBase();
    return made;
  }

  bool HasCurved = false; ///< a cell has a type that is not linear

protected:
  int ReadPieceData() override
  {
    const vtkIdType cells = this->NumberOfCells[this->Piece];
    vtkXMLDataElement* const element = this->CellElements[this->Piece]
      ? this->FindDataArrayWithName(this->CellElements[this->Piece], "types")
      : nullptr;
    if (element == nullptr || this->HasCurved)
    {
      return 1;
    }
    const auto array = vtkSmartPointer<vtkAbstractArray>::Take(this->CreateArray(element));
    auto* const types = vtkDataArray::SafeDownCast(array);
    if (types == nullptr)
    {
      return 1;
    }
    types->SetNumberOfTuples(cells);
    if (this->ReadArrayValues(element, 0, types, 0, cells))
    {
      for (vtkIdType cell = 0; cell < cells; ++cell)
      {
        const auto type = static_cast<int>(types->GetComponent(cell, 0));
        this->HasCurved = this->HasCurved ||
          (type >= VTK_QUADRATIC_EDGE && type <= VTK_TRIQUADRATIC_PYRAMID) ||
          (type >= VTK_LAGRANGE_CURVE && type <= VTK_BEZIER_PYRAMID);
      }
    }
    return 1;
  }
};

/// Turns off the messages of all VTK objects during its lifetime.
class Silence
{
public:
  Silence() { vtkObject::GlobalWarningDisplayOff(); }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(Before); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  vtkTypeBool Before = vtkObject::GetGlobalWarningDisplay();
};

/// The first files that a .pvtu or .pvd names.
std::vector<std::filesystem::path> PartsIn(const std::filesystem::path& file)
{
  constexpr std::size_t kMax = 8;
  const std::string text = pixelexact::ReadFileHead(file, kHead);
  const std::string word = pixelexact::LowerSuffix(file) == ".pvd" ? "file=" : "Source=";
  std::vector<std::filesystem::path> parts;
  for (std::size_t at = text.find(word); at != std::string::npos && parts.size() < kMax;
       at = text.find(word, at + 1))
  {
    const std::size_t begin = at + word.size();
    const std::size_t end = begin < text.size() ? text.find(text[begin], begin + 1) : begin;
    if (end != std::string::npos && end > begin)
    {
      parts.push_back(file.parent_path() / text.substr(begin + 1, end - begin - 1));
    }
  }
  return parts;
}

/// Prefix of the names of arrays that belong to coefficients.
constexpr const char* kOurs = "PixelExact";

/// Whether a file holds cells that are not linear, or coefficients. For linear cells ParaView's own
/// readers suffice.
bool HasHighOrderCells(const std::filesystem::path& file)
{
  const std::string suffix = pixelexact::LowerSuffix(file);
  if (suffix == ".pvtu" || suffix == ".pvd")
  {
    const auto parts = PartsIn(file);
    return std::ranges::any_of(parts,
      [&](const auto& part)
      { return pixelexact::LowerSuffix(part) != suffix && HasHighOrderCells(part); });
  }
  if (pixelexact::IsVtkHdfName(file))
  {
    return pixelexact::HasCurvedVtkHdfCells(file);
  }
  vtkNew<CellTypes> types;
  if (types->CanReadFile(file.c_str()) == 0)
  {
    return false;
  }
  const Silence silence; // what is wrong with a file is said by the reader that reads it
  types->SetFileName(file.c_str());
  types->UpdateInformation();
  for (int i = 0; i < types->GetNumberOfCellArrays(); ++i)
  {
    if (std::string(types->GetCellArrayName(i)).starts_with(kOurs))
    {
      return true;
    }
  }
  types->GetPointDataArraySelection()->DisableAllArrays();
  types->GetCellDataArraySelection()->DisableAllArrays();
  types->Update();
  return types->HasCurved;
}
} // namespace

//------------------------------------------------------------------------------
vtkPixelExactGridReader::vtkPixelExactGridReader()
{
  this->Convert->SetInputConnection(this->Reader->GetOutputPort());
}

//------------------------------------------------------------------------------
vtkPixelExactGridReader::~vtkPixelExactGridReader() = default;

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetNodePlacement(int placement)
{
  this->Convert->SetNodePlacement(placement);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetMirroredWedges(bool mirrored)
{
  this->Convert->SetMirroredWedges(mirrored);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetSurfaceElements(bool surfaces)
{
  this->Reader->SetSurfaceElements(surfaces);
  this->Convert->SetSurfaceElements(surfaces);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetDiagnose(bool diagnose)
{
  this->Convert->SetDiagnose(diagnose);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPixelExactGridReader::CanReadFile(const char* name)
{
  return name != nullptr && HasHighOrderCells(name) ? 1 : 0;
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkPixelExactGridReader::GetSource()
{
  return this->Convert;
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::Prepare()
{
  this->Reader->ClearFileNames();
  for (const std::string& file : this->FileNames)
  {
    this->Reader->AddFileName(file.c_str());
  }
  if (pixelexact::LowerSuffix(this->FileNames.front()) != ".vtu")
  {
    return; // what fields there are is known when it has been read
  }
  vtkNew<vtkXMLUnstructuredGridReader> head;
  if (!head->CanReadFile(this->FileNames.front().c_str()))
  {
    return; // a legacy file; the reader says what else it is
  }
  head->SetFileName(this->FileNames.front().c_str());
  head->UpdateInformation();
  for (int i = 0; i < head->GetNumberOfPointArrays(); ++i)
  {
    this->Offer(head->GetPointArrayName(i), true);
  }
  for (int i = 0; i < head->GetNumberOfCellArrays(); ++i)
  {
    const std::string name = head->GetCellArrayName(i);
    if (name != pixelexact::kElementIds && name != pixelexact::kLinearizedOrder)
    {
      this->Offer(name, true);
    }
  }
}
