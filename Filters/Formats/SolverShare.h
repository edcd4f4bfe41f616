// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <cstdint>
#include <utility>

// What one process of several takes of a solver's files.
namespace pixelexact
{
/// One of `count` parts, counted from 0.
struct PieceOf
{
  int piece = 0;
  int count = 1;

  [[nodiscard]] bool IsWhole() const { return count <= 1; }
  /// The first of so many things that are the part's, and the one behind its last: parts follow
  /// each other, so that what they read is in the order of the whole.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> Of(std::int64_t things) const
  {
    return { things * piece / count, things * (piece + 1) / count };
  }
  bool operator==(const PieceOf&) const = default;
};

/// Drops all elements but those of the part, which follow each other in the file; numbers of
/// elements stay those of the file. Of a model without a mesh, fields alone.
void KeepPiece(const PieceOf& part, SolverModel& model);
} // namespace pixelexact
