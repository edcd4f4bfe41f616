// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/InversionTrees.h"

namespace pixelexact
{
namespace
{
/// Summing over all trees is not free.
constexpr int kAskedBetweenChecks = 64;
} // namespace

std::shared_ptr<InversionTree> InversionTrees::Of(int element)
{
  if (const std::scoped_lock lock(Mutex); ++Asked < kAskedBetweenChecks)
  {
    if (const auto found = Trees.find(element); found != Trees.end())
    {
      return found->second;
    }
  }
  const bool full = MemoryUsage() > kLimit;
  const std::scoped_lock lock(Mutex);
  Asked = 0;
  if (full)
  {
    // Whoever is using one holds it.
    Trees.clear();
  }
  auto& tree = Trees[element];
  if (!tree)
  {
    tree = std::make_shared<InversionTree>(TheMesh, element, Bounds.Of(element));
  }
  return tree;
}

std::size_t InversionTrees::MemoryUsage() const
{
  const std::scoped_lock lock(Mutex);
  std::size_t bytes = 0;
  for (const auto& [element, tree] : Trees)
  {
    bytes += tree->MemoryUsage();
  }
  return bytes;
}
} // namespace pixelexact
