// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Bernstein/PieceForm.h"

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace pixelexact
{
/// Counts the bytes that all stores of the process keep.
class PieceBytes
{
public:
  static constexpr std::int64_t kMaxBytes = std::int64_t{ 256 } << 20;

  [[nodiscard]] static bool AreLeft();
  static void Add(std::int64_t bytes);
};

/// Holds objects that are computed from an element's polynomials over each piece of the cube
/// (PieceForm). Each is computed on first use, and kept as long as all stores of the process
/// together stay within PieceBytes::kMaxBytes; beyond that it is recomputed for each caller.
/// Results do not depend on which of the two happens. Safe to use from several threads. `T` has
/// Bytes().
template <class T>
class PieceStore
{
public:
  /// The cube has 2^level pieces along each direction.
  explicit PieceStore(int level)
    : Level(level)
    , Kept(std::size_t{ 1 } << (3 * level))
  {
  }
  ~PieceStore() { PieceBytes::Add(-Bytes.load()); }
  PieceStore(const PieceStore&) = delete;
  PieceStore& operator=(const PieceStore&) = delete;

  /// The number of a piece, from 0.
  [[nodiscard]] std::size_t NumberOf(const PieceForm::Piece& piece) const
  {
    const int number = (((piece[0] << Level) + piece[1]) << Level) + piece[2];
    return static_cast<std::size_t>(number);
  }

  /// Calls visit(const T&) with what make() returns as a unique_ptr<const T>.
  template <class Make, class Visit>
  void With(const PieceForm::Piece& piece, const Make& make, const Visit& visit) const
  {
    const std::size_t at = NumberOf(piece);
    const T* made = Kept.IfMade(at);
    if (made == nullptr && PieceBytes::AreLeft())
    {
      made = &Kept.Get(at, make);
      // Counts an object twice where two threads created it: still an upper bound, until all of it
      // is returned.
      const auto bytes = static_cast<std::int64_t>(made->Bytes());
      PieceBytes::Add(bytes);
      Bytes.fetch_add(bytes, std::memory_order_relaxed);
    }
    visit(made != nullptr ? *made : *make());
  }

private:
  int Level;
  MadeOnDemand<T> Kept;
  mutable std::atomic<std::int64_t> Bytes{ 0 };
};
} // namespace pixelexact
