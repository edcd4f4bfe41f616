// SPDX-License-Identifier: BSD-3-Clause
// How a NURBS mesh's knot spans are divided, until polynomials come near enough on each part.
#include "Core/Base/Error.h"
#include "Formats/MFEM/Nurbs/ForParts.h"
#include "Formats/MFEM/Nurbs/NurbsModel.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pixelexact::mfem
{
namespace
{
/// The place in its knot vector of a patch's span.
std::size_t SpanOf(
  const PatchTopology::Line& line, int place, const std::vector<std::vector<int>>& parts)
{
  const auto spans = static_cast<int>(parts[static_cast<std::size_t>(line.vector)].size());
  return static_cast<std::size_t>(line.isReversed ? spans - 1 - place : place);
}
} // namespace

/// The mesh of all parts, whose vertices are numbered as those of a mesh refined so.
void NurbsModel::MakeParts()
{
  std::vector<int> counts;
  std::ranges::transform(PartsOfSpan, std::back_inserter(counts),
    [](const auto& parts) { return std::accumulate(parts.begin(), parts.end(), 0) + 1; });
  const PatchNumbering vertices(Mesh.topology, counts);
  if (vertices.Size() > std::numeric_limits<std::int32_t>::max())
  {
    throw Unsupported(
      Name + ": its knot spans would have to be divided into more than 2^31 parts.");
  }
  std::vector<GridPlace> places;
  Drawn = MakeGridMesh(Mesh.topology, vertices, places);
  std::vector<std::int32_t> firstElement{ 0 };
  for (const GridPlace& place : Mesh.places)
  {
    firstElement.resize(place.patch + 2, 0);
    ++firstElement.back();
  }
  std::partial_sum(firstElement.begin(), firstElement.end(), firstElement.begin());
  PartList.clear();
  for (const GridPlace& place : places)
  {
    rational::ElementPart part;
    std::int32_t element = 0;
    for (int d = Mesh.topology.dimension; d-- > 0;)
    {
      const PatchTopology::Line& line = Mesh.topology.lines[place.patch].at(d);
      const auto& parts = PartsOfSpan[static_cast<std::size_t>(line.vector)];
      const auto spans = static_cast<int>(parts.size());
      int span = 0;
      int at = place.at.at(d);
      while (at >= parts[SpanOf(line, span, PartsOfSpan)])
      {
        at -= parts[SpanOf(line, span++, PartsOfSpan)];
      }
      part.part.at(d) = at;
      part.of.at(d) = parts[SpanOf(line, span, PartsOfSpan)];
      element = element * spans + span;
    }
    part.element = firstElement[place.patch] + element;
    PartList.push_back(part);
  }
}

bool NurbsModel::Divide(const Function& function, int most)
{
  MapOrder = most;
  for (auto& parts : PartsOfSpan)
  {
    std::ranges::fill(parts, 1);
  }
  MakeParts();
  Extent.assign(File.elements.size(), 0.0);
  ForParts(PartList.size(),
    [&](std::size_t i) { Extent[i] = rational::ExtentOf(ElementOf(function, i)); });
  while (true)
  {
    std::vector<int> worst(PartList.size(), -1);
    ForParts(PartList.size(),
      [&](std::size_t i)
      {
        const double target = kLoss * Extent[static_cast<std::size_t>(PartList[i].element)];
        const rational::OrderEstimate estimate =
          rational::EstimateOrders(ElementOf(function, i), target, most, Tables);
        worst[i] = estimate.order ? -1 : estimate.worst;
      });
    auto divided = PartsOfSpan;
    for (std::size_t i = 0; i < worst.size(); ++i)
    {
      if (worst[i] < 0)
      {
        continue;
      }
      const GridPlace& place = Mesh.places[static_cast<std::size_t>(PartList[i].element)];
      const PatchTopology::Line& line = Mesh.topology.lines[place.patch].at(worst[i]);
      const std::size_t span = SpanOf(line, place.at.at(worst[i]), PartsOfSpan);
      const auto vector = static_cast<std::size_t>(line.vector);
      divided[vector][span] = 2 * PartsOfSpan[vector][span];
    }
    if (divided == PartsOfSpan)
    {
      return true;
    }
    PartsOfSpan = std::move(divided);
    if (MostPartsOfSpan() > kMaxParts)
    {
      return false;
    }
    MakeParts();
  }
}

int NurbsModel::MostPartsOfSpan() const
{
  int most = 1;
  for (const GridPlace& place : Mesh.places)
  {
    int parts = 1;
    for (int d = 0; d < Mesh.topology.dimension; ++d)
    {
      const PatchTopology::Line& line = Mesh.topology.lines[place.patch].at(d);
      parts *= PartsOfSpan[static_cast<std::size_t>(line.vector)]
                          [SpanOf(line, place.at.at(d), PartsOfSpan)];
    }
    most = std::max(most, parts);
  }
  return most;
}
} // namespace pixelexact::mfem
