// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/FollowedGrid.h"
#include "Conversion/GridConversion.h"
#include "Conversion/ModelSource.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Grids/FilterInput.h"
#include "HighOrderArrays.h"
#include "MessageWords.h"
#include "PackedArrays.h"
#include "Parts/PartExchange.h"
#include "vtkHighOrderGrid.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <exception>

vtkStandardNewMacro(vtkUnstructuredGridToHighOrderGrid);

using namespace pixelexact;

vtkUnstructuredGridToHighOrderGrid::vtkUnstructuredGridToHighOrderGrid()
  : Kept(std::make_unique<KeptMesh>())
{
}

vtkUnstructuredGridToHighOrderGrid::~vtkUnstructuredGridToHighOrderGrid() = default;

void vtkUnstructuredGridToHighOrderGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  PrintFields(os, indent, this->Fields.All());
  os << indent << "NodePlacement: "
     << (this->NodePlacement == GAUSS_LOBATTO ? "Gauss-Lobatto-Legendre\n" : "equispaced\n");
  os << indent << "MirroredWedges: " << this->MirroredWedges << "\n";
  os << indent << "SurfaceElements: " << this->SurfaceElements << "\n";
  os << indent << "Diagnose: " << this->Diagnose << "\n";
  os << indent << "NumberOfSkippedCells: " << this->NumberOfSkippedCells << "\n";
}

bool vtkUnstructuredGridToHighOrderGrid::IsConverted(vtkUnstructuredGrid* grid)
{
  return IsComplete(grid);
}

int vtkUnstructuredGridToHighOrderGrid::GetNumberOfNonFiniteElements(const std::string& field)
{
  const auto found = this->NonFiniteElements.find(field);
  return found == this->NonFiniteElements.end() ? 0 : found->second;
}

int vtkUnstructuredGridToHighOrderGrid::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  auto* output = vtkHighOrderGrid::SafeDownCast(vtkDataObject::GetData(outputVector));
  this->NumberOfSkippedCells = 0;
  this->NonFiniteElements.clear();
  this->ClearDiagnostics();
  try
  {
    if (!input || !output)
    {
      throw InvalidData("there is no input grid; connect a vtkUnstructuredGrid.");
    }
    if (input->GetNumberOfCells() == 0 &&
      !PieceAskedFor(outputVector->GetInformationObject(0)).IsWhole())
    {
      output->ShallowCopy(input); // a process without a share of the data
      return 1;
    }
    const bool keeps = HasSolverCoefficients(input) || IsPacked(input);
    const bool loses = HasHighOrderArrays(input) && OrderLostByConversion(input) >= 0;
    if (HasSolverMesh(input))
    {
      try
      {
        const FollowedGrid followed = FollowGrid(input);
        output->ShallowCopy(followed.grid);
        for (const std::string& line : followed.notes)
        {
          this->Report(line);
        }
        return 1;
      }
      catch (const StaleData& error)
      {
        if (loses)
        {
          throw;
        }
        this->Report(std::string("the solver's own coefficients no longer fit and are replaced by "
                                 "nodal ones: ") +
          error.what());
      }
    }
    else if (keeps || loses)
    {
      const std::string problem = vtkHighOrderGrid::CheckCoefficients(input);
      if (problem.empty() && keeps)
      {
        output->ShallowCopy(IsPacked(input) ? Unpack(input).Get() : input);
        return 1;
      }
      if (loses && !problem.empty())
      {
        throw StaleData(problem);
      }
      if (keeps)
      {
        this->Report("the " + std::string(IsPacked(input) ? "packed" : "solver's own") +
          " coefficients no longer fit and are replaced by nodal ones: " + problem);
      }
    }
    const auto report = ConvertGrid(input,
      { this->Fields.All(), this->Diagnose,
        { this->NodePlacement == GAUSS_LOBATTO, this->MirroredWedges }, this->SurfaceElements,
        [this](double done) { this->UpdateProgress(done); } },
      *this->Kept, output);
    this->NumberOfSkippedCells = report.skippedCells;
    this->NonFiniteElements = report.nonFinite;
    for (const auto& line : report.diagnostics)
    {
      this->Report(line);
    }
    return 1;
  }
  catch (const std::exception& error) // memory may run out too
  {
    if (output)
    {
      output->Initialize();
    }
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
}
