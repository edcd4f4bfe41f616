// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Pipeline.h"

#include <algorithm>

namespace pixelexact
{
void SampleNeeds::Add(const SampleNeeds& other)
{
  centres = centres | other.centres;
  corners = corners | other.corners;
  edges = edges | other.edges;
  edgeLevel = std::max(edgeLevel, other.edgeLevel);
  cornersAround = std::max(cornersAround, other.cornersAround);
  coloredCorners = coloredCorners || other.coloredCorners;
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
} // namespace pixelexact
