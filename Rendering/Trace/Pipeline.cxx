// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Pipeline.h"

#include <algorithm>

namespace pixelexact
{
void SampleNeeds::Add(const SampleNeeds& other)
{
  centres = centres | other.centres;
  welcome = welcome | other.welcome;
  corners = corners | other.corners;
  edges = edges | other.edges;
  edgeLevel = std::max(edgeLevel, other.edgeLevel);
  coloredCorners = coloredCorners || other.coloredCorners;
  wholeFrame = wholeFrame || other.wholeFrame;
}

Buffer Pipeline::ColorNeeds() const
{
  Buffer needs = Buffer::None;
  for (const auto* painter : colors)
  {
    needs = needs | painter->Needs();
  }
  return needs;
}

SampleNeeds Pipeline::Needs() const
{
  SampleNeeds needs{ .centres = ColorNeeds() };
  for (const auto* module : modules)
  {
    needs.Add(module->Needs());
  }
  if (needs.coloredCorners)
  {
    needs.corners = needs.corners | ColorNeeds();
  }
  return needs;
}

std::vector<std::span<FrameModule* const>> Pipeline::Runs() const
{
  std::vector<std::span<FrameModule* const>> runs;
  const std::span<FrameModule* const> all = modules;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i]->Needs().wholeFrame)
    {
      runs.push_back(all.subspan(begin, i - begin));
      begin = i;
    }
  }
  runs.push_back(all.subspan(begin));
  return runs;
}
} // namespace pixelexact
