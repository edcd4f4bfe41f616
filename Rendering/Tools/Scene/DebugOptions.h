// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/CutJumps.h"
#include "Trace/Modules/DebugColors.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

class ShotAppearance;
class Table;
struct LayerSettings;
struct Shot;

/// What render shows and tells beyond the field: how sound the mesh is where it is cut, and how far
/// the values are proven. Nothing of it costs a render that does not ask.
class DebugOptions
{
public:
  void AddTo(CLI::App& added);

  /// Throws UsageError for options that exclude each other or have no effect; `samples`: in a
  /// pixel.
  void Check(int samples, const std::vector<LayerSettings>& layers) const;
  /// Whether a legend's colours are painted in the place of the field's.
  [[nodiscard]] bool IsInPlace() const { return Owners || Show != "field"; }
  /// Whether colours are a legend's, and must not be mixed.
  [[nodiscard]] bool NeedsPureColors() const { return IsInPlace() || ShowUndecided; }

  /// The buffers that it takes.
  [[nodiscard]] Buffer Needs() const;

  /// Adds what was asked for to a pipeline that shows the field, or puts it in the field's place:
  /// of a frame whose samples are there, and whose buffer of jumps it fills. What is pointed to
  /// lives here.
  void AddTo(Pipeline& pipeline, const Shot& shot, const ShotAppearance& appearance, Frame& frame);

  /// The colour of undecided pixels, where the frame that was counted has some.
  [[nodiscard]] std::optional<Rgba> UndecidedMark() const;

  /// Counts what was found in a frame.
  void Count(const Frame& frame);

  /// What was found: call after Count.
  void AddTo(Table& table) const;
  void AddTo(nlohmann::ordered_json& summary) const;

private:
  using Counts = std::vector<std::int64_t>; ///< pixels per entry of a legend

  void CountValidity(const Frame& frame);
  void CountCoverage(const Frame& frame);
  void CountEnclosures(const Frame& frame);

  const CLI::App* Command = nullptr;
  bool Owners = false;
  bool Enclosures = false;
  bool ShowUndecided = false;
  std::string Show = "field";
  std::vector<double> UndecidedColor{ 1.0, 0.0, 0.5 };

  std::shared_ptr<SampleColors> InPlace; ///< of the field's colours
  std::shared_ptr<UndecidedColors> OnTop;
  std::vector<Validity> Verdicts; ///< of elements
  std::optional<FoundJumps> Jumps;

  Counts Coverages;  ///< by Coverage
  Counts Validities; ///< by Validity
  std::int64_t ColorUndecided = 0;
  std::int64_t Unbounded = 0;
  double Widest = 0.0;
};
} // namespace pixelexact
