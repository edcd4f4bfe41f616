// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/HitWriter.h"

#include "Core/Location/Locator.h"
#include "Trace/BufferTable.h"
#include "Trace/RayKernels.h"
#include "Trace/Room.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
void CountStatuses(
  const HitResults& found, std::span<const Verdict> verdicts, FrameCounters& counters)
{
  if (!found.slots->HasStatuses())
  {
    return;
  }
  for (std::size_t i = 0; i < verdicts.size(); ++i)
  {
    if (verdicts[i] != Verdict::Outside)
    {
      const HitStatus status = found.Status(i);
      counters.numericHits += status == HitStatus::Numeric ? 1 : 0;
      counters.undecidedHits += status == HitStatus::Undecided ? 1 : 0;
    }
  }
}

std::int64_t CountNonFinite(
  const HitResults& found, std::span<const Verdict> verdicts, bool allExact)
{
  if (found.value.empty() ||
    (allExact &&
      GetRayKernels().areFinite(found.value.data(), static_cast<int>(found.value.size()))))
  {
    return 0;
  }
  std::int64_t count = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i)
  {
    count += verdicts[i] == Verdict::Inside && !std::isfinite(found.value[i]) ? 1 : 0;
  }
  return count;
}
} // namespace

void HitWriter::Write(const Locator& locator, HitResults found, std::span<const std::size_t> place,
  std::span<const int> depth, Sheets& sheets, FrameCounters& counters)
{
  if (!sheets.At(0).coverage.empty())
  {
    CountOwners(locator, found, place, depth, sheets.At(0));
  }
  if (!sheets.At(0).normal.empty() && found.layer->surface->HasCostlyNormals())
  {
    AskNormals(found);
  }
  if (depth.empty())
  {
    WriteSheet(0, found, found.verdict, place, sheets, counters);
    return;
  }
  const auto depthOf = [&](std::size_t i)
  { return depth[static_cast<std::size_t>(found.RayOf(i))]; };
  int deepest = 0;
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    if (found.verdict[i] != Verdict::Outside && depthOf(i) < Sheets::kMost)
    {
      deepest = std::max(deepest, depthOf(i));
    }
  }
  const auto verdicts = Room(OfSheet, place.size());
  for (int sheet = 0; sheet <= deepest; ++sheet)
  {
    for (std::size_t i = 0; i < place.size(); ++i)
    {
      verdicts[i] = depthOf(i) == sheet ? found.verdict[i] : Verdict::Outside;
    }
    WriteSheet(sheet, found, verdicts, place, sheets, counters);
  }
}

void HitWriter::AskNormals(HitResults& found)
{
  const std::size_t count = found.verdict.size();
  Points.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (found.verdict[i] != Verdict::Outside)
    {
      Points.push_back(found.Point(i));
    }
  }
  const auto asked = Room(Asked, Points.size());
  if (!Points.empty())
  {
    found.layer->surface->Normals(Points, asked);
  }
  const auto normals = Room(Normals, count);
  for (std::size_t i = 0, k = 0; i < count; ++i)
  {
    if (found.verdict[i] != Verdict::Outside)
    {
      normals[i] = asked[k++];
    }
  }
  found.normals = normals;
}

void HitWriter::CountOwners(const Locator& locator, const HitResults& found,
  std::span<const std::size_t> place, std::span<const int> depth, SampleBuffers& nearest)
{
  const auto positions = Room(Positions, place.size());
  const auto owners = Room(Counted, place.size());
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    positions[i] = found.Position(i);
  }
  FindOwnersOfTile(locator, positions, owners);
  const Box3& bounds = locator.Bounds();
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    const bool isNearest = depth.empty() || depth[static_cast<std::size_t>(found.RayOf(i))] == 0;
    if (isNearest && (found.verdict[i] != Verdict::Outside || bounds.Contains(positions[i])))
    {
      nearest.owners[place[i]] = owners[i].preimages;
      nearest.coverage[place[i]] = static_cast<std::uint8_t>(owners[i].coverage);
    }
  }
}

void HitWriter::WriteSheet(int sheet, const HitResults& found, std::span<const Verdict> verdicts,
  std::span<const std::size_t> place, Sheets& sheets, FrameCounters& counters)
{
  Writer.Sort(verdicts, place, found.ray == nullptr);
  if (Writer.Exact() + Writer.Unknown() == 0)
  {
    return;
  }
  SampleBuffers& to = sheets.At(sheet);
  ForEachBuffer(
    [&](const auto& row)
    {
      const auto valueOf = [&](std::size_t i) { return row.of(found, i); };
      if (row.written == Written::Inside)
      {
        Writer.WriteInside(to.*row.member, valueOf);
      }
      else if (row.written == Written::Held)
      {
        Writer.WriteHeld(to.*row.member, valueOf);
      }
    });
  CountStatuses(found, verdicts, counters);
  if (sheet == 0)
  {
    counters.exact += Writer.Exact();
    counters.unknown += Writer.Unknown();
    const bool allExact = Writer.Exact() == static_cast<std::int64_t>(verdicts.size());
    counters.nonFinite += CountNonFinite(found, verdicts, allExact);
  }
}
} // namespace pixelexact
