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

  /// The largest jump; 0 where no value jumps.
  [[nodiscard]] double Largest() const { return Jumps.largest ? Jumps.largest->jump : 0.0; }

  void AddTo(Table& table) const;
  void AddTo(nlohmann::ordered_json& summary) const;

private:
  [[nodiscard]] std::array<std::int64_t, 2> Cells() const;

  CutJumps Jumps;
  std::size_t Layers = 1;
  std::span<const std::int64_t> SourceCells; ///< by element, the numbers shown to users
};

struct LayerSettings;

/// Options that show and report the validity of the mesh at the cut, and what is proven about
/// values. They cost nothing where they are not given.
class DebugOptions
{
public:
  void AddTo(CLI::App& added);

  /// Throws UsageError for options that exclude each other or have no effect. `samples`: per pixel.
  void Check(int samples, const std::vector<LayerSettings>& layers) const;
  /// Whether a legend's colours replace those of the field.
  [[nodiscard]] bool IsInPlace() const { return Owners || Show != "field"; }
  /// Whether the colours are those of jumps, which have a bar.
  [[nodiscard]] bool ShowsJumps() const { return Show == "jumps"; }
  /// Whether colours are those of a legend and must not be mixed.
  [[nodiscard]] bool NeedsPureColors() const { return IsInPlace() || MarksUndecided(); }

  /// The buffers that the options need.
  [[nodiscard]] Buffer Needs() const;

  /// Replaces a pipeline's colours by those of a legend, where requested. The frame must contain
  /// its samples; its buffer of jumps is filled. The pipeline points to this object.
  void AddTo(Pipeline& pipeline, const Shot& shot, Frame& frame);

  /// Counts the results in a frame. `undecided`: the painter's; null: no pixels are marked.
  void Count(const Frame& frame, const UndecidedColors* undecided);
  /// The number of pixels in the counted frame whose colour is not proven.
  [[nodiscard]] std::int64_t UndecidedPixels() const { return ColorUndecided; }

  /// The entries of the legend whose colours a painted frame shows, but those of a colour bar.
  /// Empty where the colours are those of the field.
  [[nodiscard]] std::vector<ColorMeaning> SeenLegend(const Frame& frame) const;
  /// The largest jump of --show jumps, at the end of its colours; 0: there is none.
  [[nodiscard]] double LargestJump() const { return Jumps ? Jumps->Largest() : 0.0; }

  /// Adds the results. Must be called after Count.
  void AddTo(Table& table) const;
  void AddTo(nlohmann::ordered_json& summary) const;

private:
  using Counts = std::vector<std::int64_t>; ///< pixels per entry of a legend

  /// Whether --show-undecided is given.
  [[nodiscard]] bool MarksUndecided() const;
  void CountValidity(const Frame& frame);
  void CountCoverage(const Frame& frame);
  void CountEnclosures(const Frame& frame);

  const CLI::App* Command = nullptr;
  bool Owners = false;
  bool Enclosures = false;
  std::string Show = "field";

  std::shared_ptr<SampleColors> InPlace; ///< replaces the field's colours
  std::vector<Validity> Verdicts;        ///< of elements
  std::optional<FoundJumps> Jumps;

  Counts Coverages;  ///< by Coverage
  Counts Validities; ///< by Validity
  std::int64_t ColorUndecided = 0;
  std::int64_t Unbounded = 0;
  double Widest = 0.0;
};
} // namespace pixelexact
