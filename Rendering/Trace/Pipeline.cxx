// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Pipeline.h"

#include <algorithm>
#include <utility>

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

std::vector<std::vector<FrameModule*>> Pipeline::Runs() const
{
  std::vector<std::vector<FrameModule*>> runs(1);
  std::vector<FrameModule*> rests;
  const auto addRests = [&]
  {
    if (!rests.empty())
    {
      runs.push_back(std::exchange(rests, {}));
    }
  };
  for (FrameModule* module : modules)
  {
    if (module->Needs().wholeFrame)
    {
      addRests();
      runs.emplace_back();
    }
    runs.back().push_back(module);
    if (FrameModule* rest = module->Rest())
    {
      rests.push_back(rest);
    }
  }
  addRests();
  return runs;
}
} // namespace pixelexact
