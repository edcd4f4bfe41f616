// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderFileReader.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Files/SolverGrid.h"
#include "Formats/FileText.h"
#include "Formats/SolverModel.h"
#include "Grids/ColorDefaults.h"
#include "Grids/FilterWork.h"
#include "MessageWords.h"
#include "Parts/PartExchange.h"
#include "vtkHighOrderGrid.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>

using namespace pixelexact;
using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkHighOrderFileReader::vtkHighOrderFileReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHighOrderFileReader::~vtkHighOrderFileReader() = default;

void vtkHighOrderFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName.empty() ? "none" : this->FileName) << "\n";
  os << indent << "Cells: " << (this->Cells == CORNER_CELLS ? "corners" : "Lagrange") << "\n";
  os << indent << "MaximumNumberOfNodes: " << this->MaximumNumberOfNodes << "\n";
  os << indent << "ColorDefaults: " << this->ColorDefaults << "\n";
  os << indent << "Steps: " << this->Times.size() << "\n";
}

int vtkHighOrderFileReader::CanReadFile(const char* name)
{
  constexpr std::size_t kHead = std::size_t{ 1 } << 16U;
  const std::string head = name ? ReadFileHead(name, kHead) : std::string();
  return !head.empty() && this->IsHead(head) ? 1 : 0;
}

void vtkHighOrderFileReader::SetFileName(const char* name)
{
  const std::string wanted = name ? name : "";
  if (this->FileName != wanted)
  {
    this->FileName = wanted;
    this->Modified();
  }
}

const char* vtkHighOrderFileReader::GetFileName()
{
  return this->FileName.c_str();
}

std::vector<double> vtkHighOrderFileReader::ReadTimes()
{
  return {};
}

int vtkHighOrderFileReader::RequestInformation(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  output->Remove(Pipeline::TIME_STEPS());
  output->Remove(Pipeline::TIME_RANGE());
  output->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  try
  {
    this->Times = this->ReadTimes();
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
  if (!this->Times.empty())
  {
    const double range[2] = { this->Times.front(), this->Times.back() };
    output->Set(Pipeline::TIME_STEPS(), this->Times.data(), static_cast<int>(this->Times.size()));
    output->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

int vtkHighOrderFileReader::RequestedStep(vtkInformation* output)
{
  if (this->Times.empty() || !output->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    return 0;
  }
  const double time = output->Get(Pipeline::UPDATE_TIME_STEP());
  const auto after = std::ranges::upper_bound(this->Times, time);
  return std::max(0, static_cast<int>(after - this->Times.begin()) - 1);
}

CellLayout vtkHighOrderFileReader::ChooseLayout(const Mesh& mesh, const SolverModel& model)
{
  this->LayoutNote.clear();
  if (this->Cells == CORNER_CELLS)
  {
    return CornerLayout(mesh);
  }
  CellLayout layout = NodeLayout(mesh, model.fields);
  const std::int64_t nodes = layout.NodeCount(mesh);
  if (nodes <= this->MaximumNumberOfNodes)
  {
    return layout;
  }
  this->LayoutNote = "VTK's cells are linear, between the elements' vertices, since Lagrange cells "
                     "would have " +
    Counted(nodes, "node") + " and MaximumNumberOfNodes is " +
    std::to_string(this->MaximumNumberOfNodes) +
    "; PixelExact's classes use the coefficients all the same; for VTK's filters raise that "
    "number.";
  return CornerLayout(mesh);
}

SolverModel vtkHighOrderFileReader::ReadPart(int step, bool wantMesh)
{
  SolverModel model;
  std::string problem;
  try
  {
    if (this->FileName.empty())
    {
      throw InvalidData("no file is named; call SetFileName.");
    }
    model = this->ReadModel(step, wantMesh);
  }
  catch (const std::exception& error)
  {
    // The error is thrown later, because the other processes wait for this one.
    problem = error.what();
  }
  PieceCounts counts{ model.piecesOfRun, {} };
  for (const ReadPiece& piece : model.pieces)
  {
    counts.elements.emplace_back(piece.piece, piece.elements);
  }
  const auto before = ElementsBefore(counts, { this->Piece, this->Pieces }, problem);
  if (model.piecesOfRun == 0)
  {
    KeepPiece({ this->Piece, this->Pieces }, model);
    return model;
  }
  std::size_t next = 0;
  for (std::size_t p = 0; p < model.pieces.size() && !model.mesh.number.empty(); ++p)
  {
    const auto shift = before[p] - static_cast<std::int64_t>(next);
    for (std::int64_t e = 0; e < model.pieces[p].elements; ++e)
    {
      model.mesh.number[next++] += shift;
    }
  }
  return model;
}

int vtkHighOrderFileReader::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  auto* output = vtkHighOrderGrid::GetData(outputVector);
  output->Initialize();
  this->ClearDiagnostics();
  try
  {
    vtkInformation* asked = outputVector->GetInformationObject(0);
    const int step = this->RequestedStep(asked);
    const PieceOf part = PieceAskedFor(asked);
    this->Piece = part.piece;
    this->Pieces = part.count;
    const int meshStep = this->StepOfMesh(step);
    const bool wantMesh = !this->MeshGrid || this->MeshTime < this->GetMTime() ||
      meshStep != this->MeshStep || PieceOf{ this->MeshPiece, this->MeshPieces } != part;
    SolverModel model = this->ReadPart(step, wantMesh);
    ReturnFreedMemory();
    this->UpdateProgress(0.6);
    if (wantMesh)
    {
      this->MeshGrid = vtkSmartPointer<vtkHighOrderGrid>::New();
      this->MeshLayout = std::make_unique<CellLayout>(StoreSolverMesh(
        std::move(model.mesh), [&](const Mesh& mesh) { return this->ChooseLayout(mesh, model); },
        this->MeshGrid));
      StoreParameters(model.parameters, this->MeshGrid);
      this->MeshTime.Modified();
      this->MeshStep = meshStep;
      this->MeshPiece = part.piece;
      this->MeshPieces = part.count;
    }
    output->ShallowCopy(this->MeshGrid);
    // A list of its own: the fields of a step must not be added to what steps share.
    vtkNew<vtkFieldData> fieldData;
    fieldData->ShallowCopy(this->MeshGrid->GetFieldData());
    output->SetFieldData(fieldData);
    this->UpdateProgress(0.8);
    for (auto& field : model.fields)
    {
      StoreSolverField(std::move(field), *this->MeshLayout, output);
    }
    if (this->ColorDefaults)
    {
      StoreColorDefaults(output);
    }
    ReturnFreedMemory();
    if (!this->Times.empty())
    {
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Times[step]);
    }
    for (const auto& line : model.notes)
    {
      this->Report(line);
    }
    if (!this->LayoutNote.empty())
    {
      this->Report(this->LayoutNote);
    }
    return 1;
  }
  catch (const std::exception& error)
  {
    // An incomplete result is not kept.
    output->Initialize();
    this->MeshGrid = nullptr;
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
}
