// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/TreeFilter.h"

#include "Core/Location/PointKernels.h"
#include "Core/Math/Bits.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Boxes with a deviation below this fraction of their size are not subdivided. Pyramids are never
/// known to be injective, so each remaining point near one of their faces takes the careful path.
constexpr double kAffineEnough = 0.04;
constexpr double kAffineEnoughOfPyramid = 0.01;
/// The frame's deviation, in xi, above which an element counts as bent.
constexpr double kBent = 0.2;
/// The largest depth of subdivision of an element, and its limits of cost in nanoseconds: for all
/// boxes together except for coarse nodes, and for those that one point needs.
constexpr int kMaxSubdivisions = 9;
constexpr int kMaxSubdivisionsOfPyramid = 12;
constexpr std::int64_t kMaxGrowth = 4'000'000;
constexpr std::int64_t kMaxOfPoint = 2'200'000;
} // namespace

bool TreeFilter::IsWorthIt(const ElementBounds& bounds)
{
  double largest = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    largest = std::max({ largest, std::fabs(bounds.lower[d]), std::fabs(bounds.upper[d]) });
  }
  return !bounds.affine && !(largest <= kBent);
}

void TreeFilter::Run(ElementTree& tree, const LanePoints& points,
  std::span<const PointChunk> chunks, std::uint64_t near, std::span<std::uint64_t> kept)
{
  Begin(tree, points, chunks, near, kept);
  Descend(near);
}

std::uint64_t TreeFilter::RunButInner(ElementTree& tree, const ElementBounds& bounds,
  const LanePoints& points, std::span<const PointChunk> chunks, std::uint64_t near,
  std::span<std::uint64_t> kept)
{
  Begin(tree, points, chunks, near, kept);
  const std::uint64_t inner = InnerChunks(bounds, near);
  ForEachBit(inner, [&](std::size_t k) { kept[k] = chunks[k].open; });
  if (inner != near)
  {
    Descend(near & ~inner);
  }
  return inner;
}

void TreeFilter::Begin(ElementTree& tree, const LanePoints& points,
  std::span<const PointChunk> chunks, std::uint64_t near, std::span<std::uint64_t> kept)
{
  Tree = &tree;
  Kept = kept;
  Points = &points;
  Chunks = chunks;
  Scaled = 0;
  const InverseProblem& problem = tree.Problem();
  ForEachBit(near,
    [&](std::size_t k)
    {
      const PointChunk& chunk = chunks[k];
      kept[k] = 0;
      for (int d = 0; d < 3; ++d)
      {
        const double lower = (chunk.box.lower[d] - problem.centre[d]) * problem.inverseSize;
        const double upper = (chunk.box.upper[d] - problem.centre[d]) * problem.inverseSize;
        const double middle = 0.5 * (lower + upper);
        Boxes.middle.x[d][k] = middle;
        Boxes.reach.x[d][k] = std::max(upper - middle, middle - lower);
      }
    });
}

/// Finds chunks whose middle and some points all over them are well inside.
std::uint64_t TreeFilter::InnerChunks(const ElementBounds& bounds, std::uint64_t near) const
{
  // Corners of a block of 8 x 8 points, and some points between them.
  constexpr std::array<int, 8> kSpread{ 0, 7, 18, 27, 36, 45, 56, 63 };
  const InverseProblem& problem = Tree->Problem();
  const auto& middle = Boxes.middle.x;
  std::uint64_t inner = 0;
  const Bits middles =
    FindInnerPoints(bounds, problem, { { middle[0], middle[1], middle[2] }, kGroupPoints }, near);
  ForEachBit(middles,
    [&](std::size_t k)
    {
      const PointChunk& chunk = Chunks[k];
      alignas(64) std::array<std::array<double, kSpread.size()>, 3> y;
      std::uint64_t some = 0;
      for (std::size_t i = 0; i < kSpread.size(); ++i)
      {
        const int at = std::min(kSpread[i], chunk.count - 1);
        some |= (chunk.open >> static_cast<unsigned>(at) & 1U) << i;
        for (std::size_t d = 0; d < 3; ++d)
        {
          y[d][i] = (Points->x[d][chunk.begin + at] - problem.centre[d]) * problem.inverseSize;
        }
      }
      const LanePoints points{ { y[0].data(), y[1].data(), y[2].data() },
        static_cast<int>(kSpread.size()) };
      inner |= FindInnerPoints(bounds, problem, points, some) == some ? BitOf(k) : 0;
    });
  return inner;
}

/// Tests the chunks, unless the tree costs too much.
void TreeFilter::Descend(std::uint64_t near)
{
  ChunkBits open{};
  ForEachBit(near, [&](std::size_t k) { open[k] = Chunks[k].open; });
  if (Tree->BeginCost() > kMaxOfPoint)
  {
    ForEachBit(near, [&](std::size_t k) { Kept[k] = open[k]; });
    return;
  }
  const bool isPyramid = Tree->Problem().space.shape == Shape::Pyramid;
  AffineEnough = isPyramid ? kAffineEnoughOfPyramid : kAffineEnough;
  const std::int64_t cost = Tree->SplitCost();
  const int whole = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(kMaxGrowth / cost)));
  MaxSubdivisions = std::min({ isPyramid ? kMaxSubdivisionsOfPyramid : kMaxSubdivisions,
    whole - 1 + Tree->CoarseSubdivisions(), static_cast<int>(kMaxOfPoint / cost) });
  if (Y.size() < 3 * kGroupPoints * Chunks.size())
  {
    Y.resize(3 * kGroupPoints * Chunks.size());
  }
  for (const auto& piece : Tree->Pieces())
  {
    Visit(*piece, 0, near, open);
  }
}

/// The points of a chunk in the element's units, computed when a box leaves some of them open.
std::array<const double*, 3> TreeFilter::InUnits(std::size_t chunk)
{
  double* const y = &Y[3 * kGroupPoints * chunk];
  if ((Scaled >> chunk & 1U) == 0)
  {
    const InverseProblem& problem = Tree->Problem();
    double* const to[3] = { y, y + kGroupPoints, y + 2 * kGroupPoints };
    Kernels.scale(
      *Points, Chunks[chunk].begin, Chunks[chunk].count, problem.centre, problem.inverseSize, to);
    Scaled |= std::uint64_t{ 1 } << chunk;
  }
  return { y, y + kGroupPoints, y + 2 * kGroupPoints };
}

void TreeFilter::Visit(
  ElementTree::Node& node, int depth, std::uint64_t active, const ChunkBits& bits)
{
  const NodeFrame& frame = node.Frame();
  const NodeClassification boxes = Kernels.classifyBoxesWidely(frame, Boxes, active);
  ChunkBits mine;
  std::uint64_t left = 0;
  for (std::uint64_t near = boxes.near; near != 0; near &= near - 1)
  {
    const auto k = static_cast<std::size_t>(std::countr_zero(near));
    mine[k] = bits[k] & ~Kept[k];
    if ((boxes.held >> k & 1U) != 0)
    {
      Kept[k] |= mine[k];
    }
    else if ((boxes.whole >> k & 1U) != 0)
    {
      left |= mine[k] != 0 ? std::uint64_t{ 1 } << k : 0;
    }
    else if (mine[k] != 0)
    {
      const auto y = InUnits(k);
      const NodeClassification points = Kernels.classifyWidely(frame, y.data(), mine[k]);
      // No smaller box excludes the points that are held here.
      Kept[k] |= points.held;
      mine[k] = points.near & ~points.held;
      left |= mine[k] != 0 ? std::uint64_t{ 1 } << k : 0;
    }
  }
  if (left == 0)
  {
    return;
  }
  if (depth >= MaxSubdivisions || frame.IsNearlyAffine(AffineEnough) || !Tree->Split(node))
  {
    for (; left != 0; left &= left - 1)
    {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      Kept[k] |= mine[k];
    }
    return;
  }
  Visit(node.Child(0), depth + 1, left, mine);
  Visit(node.Child(1), depth + 1, left, mine);
}
} // namespace pixelexact
