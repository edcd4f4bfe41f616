// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderDifference.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Frames/DifferenceImage.h"
#include "HighOrderModel.h"
#include "MessageWords.h"
#include "Surfaces/SeenCut.h"
#include "Surfaces/VtkSurface.h"
#include "Views/FieldChoice.h"
#include "Views/FittedView.h"
#include "Views/GridModel.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <initializer_list>

vtkStandardNewMacro(vtkHighOrderDifference);

namespace
{
using namespace pixelexact;

void AddNumbers(vtkFieldData* data, const char* name, std::initializer_list<double> numbers)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double number : numbers)
  {
    array->InsertNextValue(number);
  }
  data->AddArray(array);
}

void AddNumbers(vtkFieldData* data, const DifferenceNumbers& numbers)
{
  const Vec3& at = numbers.largestAt;
  AddNumbers(data, "Largest", { numbers.largest });
  AddNumbers(data, "LargestAt", { at.x, at.y, at.z });
  AddNumbers(data, "Mean", { numbers.mean });
  AddNumbers(data, "RootMeanSquare", { numbers.rootMeanSquare });
  AddNumbers(data, "FirstRootMeanSquare", { numbers.firstRootMeanSquare });
  if (numbers.bounded)
  {
    AddNumbers(data, "LargestBound", { numbers.largestBound });
    AddNumbers(data, "LargestTrue", { numbers.largestTrue.lower, numbers.largestTrue.upper });
    AddNumbers(data, "Unbounded", { static_cast<double>(numbers.unbounded) });
  }
  AddNumbers(data, "Both", { static_cast<double>(numbers.both) });
  AddNumbers(data, "OnlyFirst", { static_cast<double>(numbers.onlyFirst) });
  AddNumbers(data, "OnlySecond", { static_cast<double>(numbers.onlySecond) });
  AddNumbers(data, "Unknown", { static_cast<double>(numbers.unknown) });
  AddNumbers(data, "NotFinite", { static_cast<double>(numbers.notFinite) });
}
} // namespace

vtkHighOrderDifference::vtkHighOrderDifference()
  : Cut(std::make_unique<SeenCut>())
  , FirstModel(std::make_unique<GridModel>())
  , SecondModel(std::make_unique<GridModel>())
{
  this->SetNumberOfInputPorts(2);
}

vtkHighOrderDifference::~vtkHighOrderDifference() = default;

void vtkHighOrderDifference::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Cut->Print(os, indent, this->Size);
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "SecondFieldName: " << this->SecondFieldName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Bounds: " << this->Bounds << "\n";
}

vtkMTimeType vtkHighOrderDifference::GetMTime()
{
  return this->Cut->Latest(this->Superclass::GetMTime());
}

void vtkHighOrderDifference::SetCutFunction(vtkImplicitFunction* function)
{
  if (Replace(this->Cut->function, function))
  {
    this->Modified();
  }
}

vtkImplicitFunction* vtkHighOrderDifference::GetCutFunction()
{
  return this->Cut->function;
}

void vtkHighOrderDifference::SetCamera(vtkCamera* camera)
{
  if (Replace(this->Cut->camera, camera))
  {
    this->Modified();
  }
}

vtkCamera* vtkHighOrderDifference::GetCamera()
{
  return this->Cut->camera;
}

int vtkHighOrderDifference::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkHighOrderDifference::RequestInformation(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0 };
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkHighOrderDifference::RequestUpdateExtent(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* /*outputVector*/)
{
  AskForWhole(inputVector[0]);
  AskForWhole(inputVector[1]);
  return 1;
}

bool vtkHighOrderDifference::Compare(
  vtkDataObject* first, vtkDataObject* second, vtkImageData* output)
{
  this->Cut->Require(this->Size);
  const auto firstModel = this->FirstModel->Of(first);
  const auto secondModel = this->SecondModel->Of(second);
  const FieldChoice choice{ this->FieldName };
  const Field& field = choice.In(*firstModel);
  const FieldChoice otherChoice{ this->SecondFieldName.empty() ? field.name
                                                               : this->SecondFieldName };
  const Field& other = otherChoice.In(*secondModel);
  RequireComponent(field, this->Component);
  const DifferenceScene scene{ { &firstModel->GetLocator(), &field },
    { &secondModel->GetLocator(), &other },
    ToSurface(this->Cut->function, { firstModel->GetLocator().Bounds() }),
    this->Component == -1 ? kMagnitude : this->Component };
  const Box3& bounds = firstModel->GetLocator().Bounds();
  const pixelexact::Camera camera =
    CameraOfFilter(this->Cut->camera, *scene.surface, bounds, this->Size[0], this->Size[1]);
  const FieldDifference found = TraceDifference(scene, camera, Buffer::None, this->Bounds,
    [this](double part)
    {
      this->UpdateProgress(part);
      return this->GetAbortExecute() == 0;
    });
  if (found.side.empty())
  {
    return false;
  }
  output->ShallowCopy(ToImageData(found, firstModel->SourceCells(), secondModel->SourceCells()));
  AddNumbers(output->GetFieldData(), NumbersOf(found));
  return true;
}

int vtkHighOrderDifference::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkImageData::GetData(outputVector);
  try
  {
    if (!this->Compare(
          vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(inputVector[1]), output))
    {
      output->Initialize();
    }
    return 1;
  }
  catch (const std::exception& error) // memory may run out too
  {
    output->Initialize();
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
}
