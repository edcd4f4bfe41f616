// SPDX-License-Identifier: BSD-3-Clause
#include "Views/MapperExecutive.h"

#include "MessageWords.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <vector>

namespace pixelexact
{
vtkStandardNewMacro(MapperExecutive);

vtkDataObject* MapperExecutive::InputOf(vtkAlgorithm* algorithm)
{
  if (algorithm->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  vtkInformation* input = algorithm->GetExecutive()->GetInputInformation(0, 0);
  return input != nullptr ? input->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
}

void MapperExecutive::WarnAgain(vtkAlgorithm* algorithm)
{
  if (auto* executive = MapperExecutive::SafeDownCast(algorithm->GetExecutive()))
  {
    executive->Warned = false;
  }
}

vtkDataObject* MapperExecutive::GetInputData(int port, int connection)
{
  vtkDataObject* input = this->Superclass::GetInputData(port, connection);
  if (input == nullptr)
  {
    return nullptr;
  }
  if (!this->Warned)
  {
    this->Warned = true;
    vtkWarningWithObjectMacro(this->GetAlgorithm(),
      << Worded("A cut-surface has no polygons: whoever asked this mapper for its input "
                "(vtkCellPicker, vtkPointPicker or an exporter) gets an empty vtkPolyData. Pick "
                "with vtkHighOrderPicker, vtkPropPicker or vtkHardwareSelector; to export, write "
                "the picture (vtkWindowToImageFilter), the mapper's GetBuffers(), or polygons of "
                "your own made from its input by GetInput()."));
  }
  if (this->Nothing->GetPoints() == nullptr)
  {
    // Some exporters read the points without checking for null, and vtkSingleVTPExporter omits the
    // normals of all actors if one has none.
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    this->Nothing->SetPoints(vtkNew<vtkPoints>());
    this->Nothing->GetPointData()->SetNormals(normals);
  }
  if (this->Nothing->GetMTime() < input->GetMTime())
  {
    // vtkActor::GetRedrawMTime reads the data's modification time here.
    this->Nothing->Modified();
  }
  return this->Nothing;
}

vtkDataObject* MapperExecutive::GetInputData(
  int port, int connection, vtkInformationVector** inInfoVec)
{
  return this->Superclass::GetInputData(port, connection, inInfoVec);
}

void MapperExecutive::ExecuteDataEnd(
  vtkInformation* request, vtkInformationVector** inInfoVec, vtkInformationVector* outInfoVec)
{
  std::vector<vtkInformation*> released;
  for (int i = 0; i < inInfoVec[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* input = inInfoVec[0]->GetInformationObject(i);
    if (input->Get(RELEASE_DATA()))
    {
      input->Set(RELEASE_DATA(), 0);
      released.push_back(input);
    }
  }
  const vtkTypeBool everywhere = vtkDataObject::GetGlobalReleaseDataFlag();
  vtkDataObject::SetGlobalReleaseDataFlag(0);
  this->Superclass::ExecuteDataEnd(request, inInfoVec, outInfoVec);
  vtkDataObject::SetGlobalReleaseDataFlag(everywhere);
  for (vtkInformation* input : released)
  {
    input->Set(RELEASE_DATA(), 1);
  }
}
} // namespace pixelexact
