// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/FilterWork.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <exception>

namespace pixelexact
{
int FillOutput(vtkAlgorithm* filter, vtkDataObject* output, const std::function<bool()>& fill)
{
  try
  {
    if (!fill())
    {
      output->Initialize();
    }
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorWithObjectMacro(filter, << error.what());
    return 0;
  }
}

StepProgress ProgressOf(vtkAlgorithm* filter, double from, double to)
{
  return [filter, from, to](double part)
  {
    filter->UpdateProgress(from + (to - from) * part);
    return filter->GetAbortExecute() == 0;
  };
}
} // namespace pixelexact
