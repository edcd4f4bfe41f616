// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/PieceStore.h"

namespace pixelexact
{
namespace
{
/// Here and not in the header: libraries that destroy stores count in the same place.
std::atomic<std::int64_t> bytesKept{ 0 };
} // namespace

bool PieceBytes::AreLeft()
{
  return bytesKept.load(std::memory_order_relaxed) < kMaxBytes;
}

void PieceBytes::Add(std::int64_t bytes)
{
  bytesKept.fetch_add(bytes, std::memory_order_relaxed);
}
} // namespace pixelexact
