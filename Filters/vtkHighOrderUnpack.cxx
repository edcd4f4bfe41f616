// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderUnpack.h"

#include "Conversion/ModelSource.h"
#include "Grids/FilterInput.h"
#include "Grids/FilterWork.h"
#include "HighOrderModel.h"
#include "PackedArrays.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHighOrderUnpack);

vtkHighOrderUnpack::vtkHighOrderUnpack() = default;
vtkHighOrderUnpack::~vtkHighOrderUnpack() = default;

void vtkHighOrderUnpack::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkHighOrderUnpack::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  pixelexact::TakeGrids(info);
  return 1;
}

int vtkHighOrderUnpack::RequestDataObject(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  pixelexact::MakeOutputLikeInput(inputVector, outputVector);
  return 1;
}

int vtkHighOrderUnpack::RequestData(vtkInformation* /*request*/, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  return pixelexact::FillOutput(this, output,
    [&]
    {
      pixelexact::ForLeafGrids(vtkDataObject::GetData(inputVector[0]), output,
        [](vtkUnstructuredGrid* grid) -> vtkSmartPointer<vtkUnstructuredGrid>
        {
          if (!pixelexact::IsPacked(grid))
          {
            return grid;
          }
          auto unpacked = pixelexact::Unpack(grid);
          (void)pixelexact::HighOrderModel::From(unpacked); // throws where it is stale
          return unpacked;
        });
      return true;
    });
}
