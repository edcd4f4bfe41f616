// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Pipeline.h"

#include <algorithm>
#include <iterator>
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
  std::vector<std::vector<FrameModule*>> rests; // first ones, what these left, ...
  const auto addRests = [&]
  { std::ranges::move(std::exchange(rests, {}), std::back_inserter(runs)); };
  for (FrameModule* module : modules)
  {
    if (module->Needs().wholeFrame)
    {
      addRests();
      runs.emplace_back();
    }
    runs.back().push_back(module);
    std::size_t after = 0;
    for (FrameModule* rest = module->Rest(); rest != nullptr; rest = rest->Rest(), ++after)
    {
      rests.resize(std::max(rests.size(), after + 1));
      rests[after].push_back(rest);
    }
  }
  addRests();
  return runs;
}
} // namespace pixelexact
