// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkInformationVector;

namespace pixelexact
{
/// Of each port the data of its connections.
using InputPorts = std::vector<std::vector<vtkSmartPointer<vtkDataObject>>>;

/// RequestData in a parallel run: `gather` gives what all processes have, null on those that make
/// no result, whose output is empty; `make` is RequestData with that in the inputs' places. What
/// throws is the filter's error. All processes must call it.
int ResultOfParts(vtkAlgorithm* filter, vtkInformationVector* output,
  const std::function<InputPorts()>& gather,
  const std::function<int(vtkInformationVector** inputs)>& make);
} // namespace pixelexact
