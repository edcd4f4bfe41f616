// SPDX-License-Identifier: BSD-3-Clause
#include "InputCut.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <string>

namespace pixelexact
{
void RequireCuts(const std::vector<DescribedCut>& slices, const std::vector<DescribedCut>& clips)
{
  if (slices.empty() && clips.empty())
  {
    throw InvalidData("the input has no slice and no clip; apply PixelExact Slice or PixelExact "
                      "Clip to it, or switch Use Cut Of Input off.");
  }
}

vtkMTimeType InputCut::Latest(vtkMTimeType time) const
{
  return chosen != nullptr ? std::max(time, chosen->GetMTime()) : time;
}

vtkSmartPointer<vtkImplicitFunction> InputCut::In(vtkDataObject* input) const
{
  if (!ofInput)
  {
    return chosen;
  }
  const auto slices = CutsOf(input, kSlices);
  const auto clips = CutsOf(input, kClips);
  RequireCuts(slices, clips);
  if (!slices.empty() && !clips.empty())
  {
    throw InvalidData("the input is a slice of a clip, and this filter clips nothing; apply "
                      "PixelExact Slice to the source of the clip.");
  }
  const auto& cuts = slices.empty() ? clips : slices;
  if (cuts.size() > 1)
  {
    throw InvalidData("the input has " + std::to_string(cuts.size()) +
      " cuts, and this filter takes one; leave one of the Slice Offset Values, or one clip.");
  }
  return cuts.front().function;
}
} // namespace pixelexact
