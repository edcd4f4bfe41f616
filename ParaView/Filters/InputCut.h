// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CutDescription.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include "vtkImplicitFunction.h"

#include <vector>

class vtkDataObject;

namespace pixelexact
{
/// The cut function of a filter: the chosen one or that which its input carries from PixelExact
/// Slice or PixelExact Clip.
struct InputCut
{
  vtkSmartPointer<vtkImplicitFunction> chosen;
  bool ofInput = false;

  /// The later of `time` and the modification time of the chosen function.
  [[nodiscard]] vtkMTimeType Latest(vtkMTimeType time) const;

  /// The one function of filters that take no other: that of a slice, or of the cut that closes a
  /// clip. `input` is the filter's data. Throws InvalidData where the input carries none or
  /// several, and for slices of clips.
  [[nodiscard]] vtkSmartPointer<vtkImplicitFunction> In(vtkDataObject* input) const;
};

/// Throws InvalidData where there is neither a slice nor a clip.
void RequireCuts(const std::vector<DescribedCut>& slices, const std::vector<DescribedCut>& clips);
} // namespace pixelexact
