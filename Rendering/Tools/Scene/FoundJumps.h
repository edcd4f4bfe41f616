// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/CutJumps.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <span>

namespace pixelexact
{
class Table;
struct Shot;

/// The jumps of a shot's fields between elements, for --show jumps and its report.
class FoundJumps
{
public:
  /// Fills the frame's buffer of jumps. All layers must have fields.
  FoundJumps(const Shot& shot, Frame& frame);

  /// 0 where no value jumps.
  [[nodiscard]] double Largest() const { return Jumps.largest ? Jumps.largest->jump : 0.0; }

  void AddTo(Table& table) const;
  void AddTo(nlohmann::ordered_json& summary) const;

private:
  [[nodiscard]] std::array<std::int64_t, 2> Cells() const;

  CutJumps Jumps;
  std::size_t Layers = 1;
  std::span<const std::int64_t> SourceCells; ///< by element, the numbers that users know
};
} // namespace pixelexact
