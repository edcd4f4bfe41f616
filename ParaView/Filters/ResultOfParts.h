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
/// The data objects of each port's connections.
using InputPorts = std::vector<std::vector<vtkSmartPointer<vtkDataObject>>>;

/// RequestData in a parallel run. `gather` returns the data of all processes, or null on those that
/// make no result, whose output is empty. `make` is RequestData with these data as inputs.
/// Exceptions become errors of the filter. All processes must call it.
int ResultOfParts(vtkAlgorithm* filter, vtkInformationVector* output,
  const std::function<InputPorts()>& gather,
  const std::function<int(vtkInformationVector** inputs)>& make);
} // namespace pixelexact
