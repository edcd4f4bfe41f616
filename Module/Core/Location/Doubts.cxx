// SPDX-License-Identifier: BSD-3-Clause
// Decides points that an element's own Newton iteration leaves open.
#include "Core/Base/StageClock.h"
#include "Core/Location/BatchScratch.h"
#include "Core/Location/RootCheck.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
/// Drops the element's doubts from the first one on that the filter has not tested before and now
/// excludes.
void Locator::Batch::DropExcluded(std::span<PointChunk> chunks, std::size_t firstDoubt)
{
  const auto chunkOf = [&](const Doubt& doubt)
  { return static_cast<std::size_t>(doubt.index - chunks[0].begin) / kChunkPoints; };
  const auto bitOf = [&](const Doubt& doubt)
  {
    return std::uint64_t{ 1 } << static_cast<unsigned>(doubt.index - chunks[0].begin) %
      kChunkPoints;
  };
  const auto isUntested = [&](const Doubt& doubt)
  {
    const std::size_t chunk = chunkOf(doubt);
    return !Work.untested.empty() &&
      (Work.untested[chunk / ChunkBoxes::kGroup] >> chunk % ChunkBoxes::kGroup & 1U) != 0;
  };
  const auto doubts = std::span(Work.doubtful).subspan(firstDoubt);
  if (std::ranges::none_of(doubts, isUntested))
  {
    return;
  }
  auto& late = Work.late;
  late.assign(chunks.begin(), chunks.end());
  for (PointChunk& chunk : late)
  {
    chunk.open = 0;
  }
  for (const Doubt& doubt : doubts)
  {
    late[chunkOf(doubt)].open |= isUntested(doubt) ? bitOf(doubt) : 0;
  }
  for (std::size_t first = 0; first < late.size(); first += ChunkBoxes::kGroup)
  {
    const auto group =
      std::span(late).subspan(first, std::min(late.size() - first, ChunkBoxes::kGroup));
    std::uint64_t near = 0;
    for (std::size_t k = 0; k < group.size(); ++k)
    {
      near |= group[k].open != 0 ? std::uint64_t{ 1 } << k : 0;
    }
    Work.filter.Run(*Index.TreeOf(Element), Points, group, near, Work.kept);
    for (std::size_t k = 0; k < group.size(); ++k)
    {
      group[k].open = (near >> k & 1U) != 0 ? Work.kept[k] : 0;
    }
  }
  const auto isExcluded = [&](const Doubt& doubt)
  { return isUntested(doubt) && (late[chunkOf(doubt)].open & bitOf(doubt)) == 0; };
  const auto first = Work.doubtful.begin() + static_cast<std::ptrdiff_t>(firstDoubt);
  Work.doubtful.erase(std::remove_if(first, Work.doubtful.end(), isExcluded), Work.doubtful.end());
}

Vec3 Locator::Batch::PointAt(int index) const
{
  return { Points.x[0][index], Points.x[1][index], Points.x[2][index] };
}

/// The careful path, for points that no element's fast path holds. It proceeds element by element,
/// so that an element's data are computed once.
void Locator::Batch::Decide(std::span<PointChunk> chunks)
{
  auto& doubtful = Work.doubtful;
  const auto isOpen = [&](const Doubt& doubt)
  {
    const int at = doubt.index - chunks[0].begin;
    return (chunks[static_cast<std::size_t>(at / kChunkPoints)].open >>
               static_cast<unsigned>(at % kChunkPoints) &
             1U) != 0;
  };
  std::erase_if(doubtful, [&](const Doubt& doubt) { return !isOpen(doubt); });
  if (doubtful.empty())
  {
    return;
  }
  auto& doubts = Work.doubts;
  doubts.assign(chunks.size() * kChunkPoints, 0);
  const auto doubtsOf = [&](const Doubt& doubt) -> int&
  { return doubts[static_cast<std::size_t>(doubt.index - chunks[0].begin)]; };
  for (const Doubt& doubt : doubtful)
  {
    ++doubtsOf(doubt);
  }
  Work.budgets.clear();
  for (const int count : doubts)
  {
    Work.budgets.emplace_back(count);
  }
  const StageScope scope(Stage::Careful);
  Work.undecided.clear();
  // Doubts are in the order of elements.
  auto& group = Work.group;
  for (std::size_t begin = 0; begin < doubtful.size();)
  {
    const int element = doubtful[begin].element;
    while (begin < doubtful.size() && doubtful[begin].element == element)
    {
      group.clear();
      for (; begin < doubtful.size() && doubtful[begin].element == element &&
           group.size() < static_cast<std::size_t>(kGroupPoints);
           ++begin)
      {
        if (isOpen(doubtful[begin]))
        {
          group.push_back(doubtful[begin]);
        }
      }
      // Gets the tree once per group, so that trees are dropped when they have become large.
      DecideGroup(*Index.TreeOf(element), group, chunks);
    }
  }
  for (const Doubt& doubt : Work.undecided)
  {
    if (isOpen(doubt))
    {
      // Reports one element, however many could not be excluded.
      Close(doubt.index, chunks);
      ++Unknown;
      Sink.Unknown(doubt.index, doubt.element);
    }
  }
}

void Locator::Batch::Close(int index, std::span<PointChunk> chunks)
{
  const int at = index - chunks[0].begin;
  chunks[static_cast<std::size_t>(at / kChunkPoints)].open &=
    ~(std::uint64_t{ 1 } << static_cast<unsigned>(at % kChunkPoints));
}

void Locator::Batch::DecideGroup(
  ElementTree& tree, std::span<const Doubt> doubts, std::span<PointChunk> chunks)
{
  Careful += static_cast<std::int64_t>(doubts.size());
  std::array<SoughtPoint, kGroupPoints> sought;
  std::array<PointBudget*, kGroupPoints> budgets{};
  std::array<Preimages, kGroupPoints> found;
  for (std::size_t k = 0; k < doubts.size(); ++k)
  {
    sought[k] = { PointAt(doubts[k].index), doubts[k].root };
    budgets[k] = &Work.budgets[static_cast<std::size_t>(doubts[k].index - chunks[0].begin)];
  }
  FindWithin(tree, std::span(sought).first(doubts.size()), budgets,
    mesh_.isShell ? Wanted::All : Wanted::First, std::span(found).first(doubts.size()));
  for (std::size_t k = 0; mesh_.isShell && k < doubts.size(); ++k)
  {
    const int element = doubts[k].element;
    const InverseProblem problem = MakeInverseProblem(mesh_, element, Index.BoundsOf(element));
    std::erase_if(
      found[k].roots, [&problem](const InverseRoot& root) { return !IsOnShell(problem, root.xi); });
    found[k].verdict = !found[k].roots.empty() ? Verdict::Inside
      : found[k].complete                      ? Verdict::Outside
                                               : Verdict::Unknown;
  }
  for (std::size_t k = 0; k < doubts.size(); ++k)
  {
    MostBoxes = std::max(MostBoxes, found[k].boxes);
    if (found[k].verdict == Verdict::Inside)
    {
      const InverseRoot& root = found[k].roots.front();
      std::array<std::array<double, kLanePadding>, 3> xi;
      for (int d = 0; d < 3; ++d)
      {
        xi[d].fill(root.xi[d]);
      }
      const double* const lanes[3] = { xi[0].data(), xi[1].data(), xi[2].data() };
      Sink.Inside(
        doubts[k].element, std::span<const int>(&doubts[k].index, 1), lanes, &root.residual);
      Close(doubts[k].index, chunks);
    }
    else if (found[k].verdict == Verdict::Unknown)
    {
      Work.undecided.push_back(doubts[k]);
    }
  }
}
} // namespace pixelexact
