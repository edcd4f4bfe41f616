// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/StageClock.h"
#include "Core/Location/BatchScratch.h"
#include "Core/Location/PointKernels.h"
#include "Core/Location/RootCheck.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace pixelexact
{
namespace
{
/// A group of points that meets more candidates than this is subdivided, down to a pack: a query
/// costs about as much as testing a few hundred points.
constexpr std::size_t kManyCandidates = 48;
constexpr std::size_t kManyCandidatesOfChunk = 12;
constexpr int kSmallChunk = 8;

bool Overlap(const Box3& a, const Box3& b)
{
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
    b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}
} // namespace

Locator::Batch::Batch(const Locator& locator, const LanePoints& points, LocationSink& sink)
  : Owner(locator)
  , Index(locator.index_)
  , mesh_(Index.GetMesh())
  , Points(points)
  , Sink(sink)
  , Kernels(GetPointKernels())
  , Work(*Lease)
{
}

Locator::Batch::~Batch() = default;

void Locator::Batch::Run()
{
  const StageScope scope(Stage::Candidates);
  Work.Fit(Points.count);
  auto& chunks = Work.chunks;
  chunks.clear();
  for (int begin = 0; begin < Points.count; begin += kChunkPoints)
  {
    chunks.push_back(
      Kernels.chunk(Points, begin, std::min(kChunkPoints, Points.count - begin), Index.Bounds()));
  }
  Search(chunks);
  auto& counters = Owner.counters_;
  counters.queries += Queries;
  counters.candidates += Candidates;
  counters.careful += Careful;
  counters.unknown += Unknown;
  int most = counters.mostBoxes;
  while (most < MostBoxes && !counters.mostBoxes.compare_exchange_weak(most, MostBoxes))
  {
  }
}

void Locator::Batch::Search(std::span<PointChunk> chunks)
{
  Box3 region{ Vec3(kInfinity), Vec3(-kInfinity) };
  for (const PointChunk& chunk : chunks)
  {
    region.lower = glm::min(region.lower, chunk.box.lower);
    region.upper = glm::max(region.upper, chunk.box.upper);
  }
  if (!(region.lower.x <= region.upper.x))
  {
    return;
  }
  if (Work.candidates.size() <= Work.depth)
  {
    Work.candidates.resize(Work.depth + 1);
  }
  auto& elements = Work.candidates[Work.depth];
  Index.FindNear(region, elements);
  ++Queries;
  if (chunks.size() > 1 ? elements.size() > kManyCandidates
                        : elements.size() > kManyCandidatesOfChunk && chunks[0].count > kSmallChunk)
  {
    SearchChildren(chunks);
    return;
  }
  Work.doubtful.clear();
  Work.boxes.Fill(chunks);
  // Elements come in ascending order and found points leave, so the lowest element wins.
  for (const int element : elements)
  {
    SearchElement(chunks, element);
  }
  Decide(chunks);
}

void Locator::Batch::SearchChildren(std::span<PointChunk> chunks)
{
  ++Work.depth;
  if (chunks.size() > 1)
  {
    Search(chunks.first(chunks.size() / 2));
    Search(chunks.subspan(chunks.size() / 2));
  }
  else
  {
    // Keeps whole packs together.
    const int count = chunks[0].count;
    const int half = PaddedCount(count / 2);
    PointChunk first = Kernels.chunk(Points, chunks[0].begin, half, Index.Bounds());
    PointChunk second = Kernels.chunk(Points, chunks[0].begin + half, count - half, Index.Bounds());
    Search(std::span(&first, 1));
    Search(std::span(&second, 1));
  }
  --Work.depth;
}

void Locator::Batch::SearchElement(std::span<PointChunk> chunks, int element)
{
  const ElementBounds* bounds = nullptr;
  const int count = Select(chunks, element, bounds);
  Candidates += count;
  if (count > 0)
  {
    Invert(chunks, *bounds, count);
  }
}

int Locator::Batch::Select(std::span<PointChunk> chunks, int element, const ElementBounds*& bounds)
{
  // The element's bounds are computed when a point lies in its box, because most are never needed.
  if (!Index.HasBounds(element) && !AnyInBox(chunks, Index.ElementBox(element)))
  {
    return 0;
  }
  bounds = &Index.BoundsOf(element);
  Problem = MakeInverseProblem(mesh_, element, *bounds);
  Element = element;
  int count = 0;
  const bool isBent = TreeFilter::IsWorthIt(*bounds);
  Work.untested.assign(isBent ? (chunks.size() - 1) / ChunkBoxes::kGroup + 1 : 0, 0);
  for (std::size_t first = 0; first < chunks.size(); first += ChunkBoxes::kGroup)
  {
    const auto [near, inner] = Kernels.near(*bounds, Problem, Work.boxes.Group(first));
    const bool filtered = near != 0 && isBent;
    if (filtered)
    {
      const auto group = chunks.subspan(first, std::min(chunks.size() - first, ChunkBoxes::kGroup));
      Work.untested[first / ChunkBoxes::kGroup] =
        Work.filter.RunButInner(*Index.TreeOf(element), *bounds, Points, group, near, Work.kept);
    }
    for (std::uint64_t left = near; left != 0; left &= left - 1)
    {
      const auto which = static_cast<std::size_t>(std::countr_zero(left));
      PointChunk& chunk = chunks[first + which];
      PointChunk asked = chunk;
      if (filtered)
      {
        asked.open = Work.kept[which];
      }
      if (asked.open == 0)
      {
        continue;
      }
      double* const selected[3] = { Work[0] + count, Work[1] + count, Work[2] + count };
      const std::uint64_t bits = Kernels.select(*bounds, Problem, Points, asked,
        (inner >> which & 1U) != 0, selected, &Work.selected[static_cast<std::size_t>(count)]);
      // Closes all points as if they were found inside, as most are. Invert opens the others again.
      chunk.open &= ~bits;
      count += std::popcount(bits);
    }
  }
  return count;
}

bool Locator::Batch::AnyInBox(std::span<const PointChunk> chunks, const Box3& box) const
{
  return std::ranges::any_of(chunks,
    [&](const PointChunk& chunk)
    {
      return chunk.open != 0 && Overlap(chunk.box, box) &&
        Kernels.inBox(Points, chunk.begin, chunk.open, box) != 0;
    });
}

void Locator::Batch::Invert(std::span<PointChunk> chunks, const ElementBounds& bounds, int count)
{
  for (int k = count; k < PaddedCount(count); ++k)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      Work[d][k] = Work[d][count - 1];
    }
  }
  const InverseResult result{ { Work[3], Work[4], Work[5] }, Work[6], Work[7], Work[8] };
  {
    const StageScope scope(Stage::Inversion);
    KernelsFor(Problem.space).invert(Problem, { { Work[0], Work[1], Work[2] }, count }, result);
  }
  for (int k = 0; mesh_.isShell && k < count; ++k)
  {
    // Beneath a surface in space. Another xi may be on it.
    if (result.status[k] == static_cast<double>(NewtonStatus::RootInside) &&
      !IsOnShell(Problem, { result.xi[0][k], result.xi[1][k], result.xi[2][k] }))
    {
      result.status[k] = static_cast<double>(NewtonStatus::NotConverged);
    }
  }
  const int others = FindOthers(result.status, count, Work.others.data());
  const std::size_t firstDoubt = Work.doubtful.size();
  for (const int k : std::span(Work.others).first(static_cast<std::size_t>(others)))
  {
    const int index = Work.selected[static_cast<std::size_t>(k)];
    const auto at = static_cast<std::size_t>(index - chunks[0].begin);
    chunks[at / kChunkPoints].open |= std::uint64_t{ 1 } << at % kChunkPoints;
    const bool converged = result.status[k] == static_cast<double>(NewtonStatus::RootOutside);
    if (!converged || !(result.margin[k] >= -bounds.injectiveMargin))
    {
      Work.doubtful.push_back({ index, Element,
        converged ? Vec3(result.xi[0][k], result.xi[1][k], result.xi[2][k])
                  : Vec3(std::numeric_limits<double>::quiet_NaN()) });
    }
  }
  DropExcluded(chunks, firstDoubt);
  if (others > 0)
  {
    KeepInside(result, count, Work.selected.data());
  }
  if (others < count)
  {
    const double* const xi[3] = { result.xi[0], result.xi[1], result.xi[2] };
    Sink.Inside(Element,
      std::span<const int>(Work.selected).first(static_cast<std::size_t>(count - others)), xi,
      result.residual);
  }
}
} // namespace pixelexact
