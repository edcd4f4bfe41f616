// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/BoundsCache.h"
#include "Core/Location/InversionTree.h"

#include <map>
#include <memory>
#include <mutex>

namespace pixelexact
{
/// The trees of a mesh's elements: made when a point first needs one and kept, as long as all of
/// them together are within a limit; then all are dropped and made anew. Which are kept changes no
/// answer. Safe to call from several threads.
class InversionTrees
{
public:
  InversionTrees(const Mesh& mesh, const BoundsCache& bounds)
    : TheMesh(mesh)
    , Bounds(bounds)
  {
  }

  std::shared_ptr<InversionTree> Of(int element);
  [[nodiscard]] std::size_t MemoryUsage() const;

  /// Bytes beyond which trees are dropped.
  static constexpr std::size_t kLimit = std::size_t{ 256 } << 20U;

private:
  const Mesh& TheMesh;
  const BoundsCache& Bounds;
  mutable std::mutex Mutex;
  std::map<int, std::shared_ptr<InversionTree>> Trees;
  int Asked = 0;
};
} // namespace pixelexact
