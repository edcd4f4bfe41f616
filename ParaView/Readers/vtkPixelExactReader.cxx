// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactReader.h"

#include "Grids/ColorDefaults.h"
#include "HighOrderArrays.h"
#include "MessageWords.h"
#include "vtkHighOrderFileReader.h"

#include "Core/Base/Error.h"

#include "vtkCellData.h"
#include "vtkDataArraySelection.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
void RemoveField(vtkUnstructuredGrid* grid, const std::string& name)
{
  const std::string prefix = pixelexact::kFieldPrefix + name + ".";
  vtkFieldData* arrays = grid->GetFieldData();
  for (int i = arrays->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const std::string array = arrays->GetArrayName(i);
    // Excludes fields whose names continue after the point.
    if (array.starts_with(prefix) && array.find('.', prefix.size()) == std::string::npos)
    {
      arrays->RemoveArray(i);
    }
  }
  grid->GetPointData()->RemoveArray(name.c_str());
  grid->GetCellData()->RemoveArray(name.c_str());
}
} // namespace

//------------------------------------------------------------------------------
vtkPixelExactReader::vtkPixelExactReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkPixelExactReader::~vtkPixelExactReader() = default;

//------------------------------------------------------------------------------
void vtkPixelExactReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const std::string& name : this->FileNames)
  {
    os << indent << "FileName: " << name << "\n";
  }
  os << indent << "Cells: " << this->Cells << "\n";
  os << indent << "MaximumNumberOfNodes: " << this->MaximumNumberOfNodes << "\n";
  this->Fields->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkPixelExactReader::SetFileName(const char* name)
{
  this->RemoveAllFileNames();
  this->AddFileName(name);
}

//------------------------------------------------------------------------------
void vtkPixelExactReader::AddFileName(const char* name)
{
  if (name != nullptr && name[0] != '\0')
  {
    this->FileNames.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactReader::RemoveAllFileNames()
{
  this->FileNames.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkPixelExactReader::GetFieldSelection()
{
  return this->Fields;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPixelExactReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Fields->GetMTime());
}

//------------------------------------------------------------------------------
void vtkPixelExactReader::Offer(const std::string& field, bool chosen)
{
  if (this->Fields->ArrayExists(field.c_str()) == 0)
  {
    this->Fields->AddArray(field.c_str(), chosen);
  }
}

//------------------------------------------------------------------------------
bool vtkPixelExactReader::IsChosen(const std::string& field)
{
  return this->Fields->ArrayIsEnabled(field.c_str()) != 0;
}

//------------------------------------------------------------------------------
int vtkPixelExactReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  output->Remove(Pipeline::TIME_STEPS());
  output->Remove(Pipeline::TIME_RANGE());
  output->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  try
  {
    if (this->FileNames.empty())
    {
      throw pixelexact::InvalidData("no file is named; open one");
    }
    if (this->PrepareTime < this->GetMTime())
    {
      this->Prepare();
      if (auto* reader = vtkHighOrderFileReader::SafeDownCast(this->GetSource()))
      {
        reader->SetCells(this->Cells);
        reader->SetMaximumNumberOfNodes(this->MaximumNumberOfNodes);
      }
      this->PrepareTime.Modified();
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
  this->GetSource()->UpdateInformation();
  vtkInformation* source = this->GetSource()->GetOutputInformation(0);
  for (vtkInformationDoubleVectorKey* key : { Pipeline::TIME_STEPS(), Pipeline::TIME_RANGE() })
  {
    output->CopyEntry(source, key);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPixelExactReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  output->Initialize();
  if (this->PrepareTime < this->GetMTime())
  {
    return 0; // RequestInformation said why
  }
  // Each process its piece, by which vtkHighOrderFileReader and vtkHighOrderSeriesReader choose.
  const int piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int pieces = std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  const bool hasTime = info->Has(Pipeline::UPDATE_TIME_STEP()) != 0;
  const bool done = hasTime
    ? this->GetSource()->UpdateTimeStep(info->Get(Pipeline::UPDATE_TIME_STEP()), piece, pieces) != 0
    : this->GetSource()->UpdatePiece(piece, pieces, 0) != 0;
  if (!done)
  {
    return 0; // the source said why
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->GetSource()->GetOutputDataObject(0));
  output->ShallowCopy(grid);
  for (const std::string& name : pixelexact::StoredFieldNames(grid))
  {
    this->Offer(name, true);
    if (!this->IsChosen(name))
    {
      RemoveField(output, name);
    }
  }
  this->PrepareTime.Modified(); // what was offered now needs nothing else to be read
  pixelexact::StoreColorDefaults(output);
  vtkInformation* made = grid->GetInformation();
  if (made->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    output->GetInformation()->Set(
      vtkDataObject::DATA_TIME_STEP(), made->Get(vtkDataObject::DATA_TIME_STEP()));
  }
  return 1;
}
