// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include "Trace/Frame.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>
#include <vector>

namespace pixelexact
{
class ColorOptions;
class Table;
struct Shot;

/// What render shows and tells beyond the field: how sound the mesh is where it is cut, and how far
/// the values are proven. Nothing of it costs a render that does not ask.
class DebugOptions
{
public:
  void AddTo(CLI::App& command);

  /// Throws UsageError for options that exclude each other.
  void Check() const;

  /// The buffers that it takes.
  [[nodiscard]] Buffer Needs() const;

  /// Gives the frame its colours: the field's, or those that were asked for in their place.
  void Paint(
    Frame& frame, const Shot& shot, const ColorOptions& colors, const std::array<double, 2>& range);

  /// What was found: call after Paint.
  void AddTo(Table& table) const;
  void AddTo(nlohmann::ordered_json& summary) const;

private:
  using Counts = std::vector<std::int64_t>; ///< pixels per entry of a legend

  void PaintValidity(Frame& frame, const Shot& shot);
  void CountCoverage(const Frame& frame);
  void CountEnclosures(const Frame& frame);

  bool Owners = false;
  bool Enclosures = false;
  bool ShowUndecided = false;
  std::string Show = "field";
  std::vector<double> UndecidedColor{ 1.0, 0.0, 0.5 };

  Counts Coverages;  ///< by Coverage
  Counts Validities; ///< by Validity
  std::int64_t ColorUndecided = 0;
  std::int64_t Unbounded = 0;
  double Widest = 0.0;
};
} // namespace pixelexact
