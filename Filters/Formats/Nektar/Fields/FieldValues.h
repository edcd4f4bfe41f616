// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact::nektar
{
/// A field file's numbers, which are let go of as they are taken: else they would stand beside the
/// coefficients that are made of them.
class FieldValues
{
public:
  void Append(std::span<const double> values);
  [[nodiscard]] std::size_t Size() const { return Count; }

  /// Numbers begin to go when all parts that were expected have been taken, each once.
  void Expect(std::size_t begin, std::size_t count);
  /// Copies a part, and lets go of what nobody else expects. From several threads.
  void Take(std::size_t begin, std::span<double> out);

private:
  static constexpr std::size_t kChunk = std::size_t{ 1 } << 16U;
  /// Pages of their own: those that go are the system's at once, not the heap's.
  struct Unmap
  {
    void operator()(double* pages) const;
  };
  struct Chunk
  {
    std::unique_ptr<double[], Unmap> values;
    std::unique_ptr<std::atomic<std::size_t>> expected;
  };
  std::vector<Chunk> Chunks;
  std::size_t Count = 0;
};
} // namespace pixelexact::nektar
