// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/GhostPixels.h"

#include "Frames/FrameCompositor.h"
#include "HighOrderModel.h"

namespace pixelexact
{
bool HasGhosts(const HighOrderModel& model)
{
  if (!model.Blocks().empty())
  {
    return false;
  }
  for (int e = 0; e < model.GetMesh().Elements(); ++e)
  {
    if (model.IsGhost(e))
    {
      return true;
    }
  }
  return false;
}

void HideGhosts(
  const SampleBuffers& samples, const HighOrderModel& model, std::vector<float>& depths)
{
  for (std::size_t i = 0; i < samples.element.size(); ++i)
  {
    if (samples.element[i] >= 0 && model.IsGhost(static_cast<int>(samples.element[i])))
    {
      depths[i] = kNoDepth;
    }
  }
}
} // namespace pixelexact
