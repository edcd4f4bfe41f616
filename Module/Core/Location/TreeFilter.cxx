// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/TreeFilter.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Boxes that bend less than this part of their size are not halved.
constexpr double kAffineEnough = 0.04;
/// Of the frame's deviation, in xi.
constexpr double kBent = 0.2;
/// Halvings of an element, and nanoseconds that they may take: all of them together but for coarse
/// nodes, and those that one point needs.
constexpr int kMostHalvings = 9;
constexpr std::int64_t kMostGrowth = 4'000'000;
constexpr std::int64_t kMostOfPoint = 2'200'000;
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
  Tree = &tree;
  Kept = kept;
  Points = &points;
  Chunks = chunks;
  Scaled = 0;
  const InverseProblem& problem = tree.Problem();
  if (tree.BeginCost() > kMostOfPoint)
  {
    for (std::size_t k = 0; k < chunks.size(); ++k)
    {
      kept[k] = chunks[k].open;
    }
    return;
  }
  const std::int64_t cost = tree.SplitCost();
  const int whole =
    static_cast<int>(std::bit_width(static_cast<std::uint64_t>(kMostGrowth / cost)));
  MostHalvings = std::min(
    { kMostHalvings, whole - 1 + tree.CoarseHalvings(), static_cast<int>(kMostOfPoint / cost) });
  if (Y.size() < 3 * kGroupPoints * chunks.size())
  {
    Y.resize(3 * kGroupPoints * chunks.size());
  }
  ChunkBits open{};
  for (std::uint64_t left = near; left != 0; left &= left - 1)
  {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    const PointChunk& chunk = chunks[k];
    kept[k] = 0;
    open[k] = chunk.open;
    for (int d = 0; d < 3; ++d)
    {
      const double lower = (chunk.box.lower[d] - problem.centre[d]) * problem.inverseSize;
      const double upper = (chunk.box.upper[d] - problem.centre[d]) * problem.inverseSize;
      const double middle = 0.5 * (lower + upper);
      Boxes.middle.x[d][k] = middle;
      Boxes.reach.x[d][k] = std::max(upper - middle, middle - lower);
    }
  }
  for (const auto& piece : tree.Pieces())
  {
    Visit(*piece, 0, near, open);
  }
}

/// The points of a chunk in the element's units, made when a box leaves some of them open.
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
  const NodeJudgement boxes = Kernels.judgeBoxesWidely(frame, Boxes, active);
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
    else if (mine[k] != 0)
    {
      const auto y = InUnits(k);
      const NodeJudgement points = Kernels.judgeWidely(frame, y.data(), mine[k]);
      // No smaller box will exclude what is held here.
      Kept[k] |= points.held;
      mine[k] = points.near & ~points.held;
      left |= mine[k] != 0 ? std::uint64_t{ 1 } << k : 0;
    }
  }
  if (left == 0)
  {
    return;
  }
  if (depth >= MostHalvings || frame.IsNearlyAffine(kAffineEnough) || !Tree->Split(node))
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
