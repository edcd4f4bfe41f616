// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderPack.h"

#include "Conversion/ModelSource.h"
#include "Core/Base/Error.h"
#include "Grids/FilterInput.h"
#include "MessageWords.h"
#include "PackedArrays.h"
#include "Parts/PartExchange.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <exception>
#include <string>

vtkStandardNewMacro(vtkHighOrderPack);

using namespace pixelexact;

vtkHighOrderPack::vtkHighOrderPack()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkHighOrderPack::~vtkHighOrderPack() = default;

void vtkHighOrderPack::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MinimumModes: " << this->MinimumModes << "\n";
  os << indent << "Controller: " << (this->Controller ? this->Controller->GetClassName() : "(none)")
     << "\n";
}

void vtkHighOrderPack::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkHighOrderPack::GetController()
{
  return this->Controller;
}

int vtkHighOrderPack::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  TakeGrids(info);
  return 1;
}

int vtkHighOrderPack::RequestDataObject(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  MakeOutputLikeInput(inputVector, outputVector);
  return 1;
}

int vtkHighOrderPack::RequestData(vtkInformation* /*request*/, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  std::string problem;
  PackedWidths widths;
  const auto carrying = vtkSmartPointer<vtkDataObject>::Take(output->NewInstance());
  try
  {
    if (input == nullptr)
    {
      throw InvalidData("there is no high-order grid; connect a vtkUnstructuredGrid.");
    }
    ForLeafGrids(input, carrying,
      [&](vtkUnstructuredGrid* grid)
      {
        auto carries = WithCoefficients(grid, this);
        Widen(widths, WidthsFor(carries));
        Widen(widths, WidthsForModes(carries, this->MinimumModes));
        return carries;
      });
  }
  catch (const std::exception& error) // memory may run out too
  {
    // The error is thrown later, because the other processes wait for this one's widths.
    problem = error.what();
  }
  widths = CommonWidths(widths, this->Controller);
  try
  {
    if (!problem.empty())
    {
      throw Error(problem);
    }
    ForLeafGrids(
      carrying, output, [&widths](vtkUnstructuredGrid* grid) { return Pack(grid, widths); });
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
}
