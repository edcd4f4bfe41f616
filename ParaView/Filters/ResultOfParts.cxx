// SPDX-License-Identifier: BSD-3-Clause
#include "ResultOfParts.h"

#include "Parts/ParallelRun.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

#include <algorithm>
#include <exception>

namespace pixelexact
{
namespace
{
/// The answer of this process.
int OwnResult(vtkAlgorithm* filter, vtkDataObject* output,
  const std::function<InputPorts()>& gather, const std::function<int(vtkInformationVector**)>& make)
{
  try
  {
    std::vector<vtkSmartPointer<vtkInformationVector>> ports;
    std::vector<vtkInformationVector*> inputs;
    for (const auto& connections : gather())
    {
      ports.push_back(vtkSmartPointer<vtkInformationVector>::New());
      inputs.push_back(ports.back());
      for (const auto& data : connections)
      {
        if (data == nullptr)
        {
          output->Initialize();
          return 1;
        }
        vtkNew<vtkInformation> connection;
        connection->Set(vtkDataObject::DATA_OBJECT(), data);
        ports.back()->Append(connection);
      }
    }
    return make(inputs.data());
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorWithObjectMacro(filter, << error.what());
    return 0;
  }
}
} // namespace

int ResultOfParts(vtkAlgorithm* filter, vtkInformationVector* output,
  const std::function<InputPorts()>& gather, const std::function<int(vtkInformationVector**)>& make)
{
  return AnswerOfAll(OwnResult(filter, vtkDataObject::GetData(output), gather, make), output);
}
} // namespace pixelexact
