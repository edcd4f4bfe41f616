// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Drawing/Image.h"
#include "Scene/LayerRanges.h"

#include "Trace/Modules/ColorMapping.h"

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkLookupTable;

namespace pixelexact
{
/// How values become colours, and what is behind them.
class ColorOptions
{
public:
  void AddTo(CLI::App& command);
  /// Declares how pixels that are not proven are painted.
  void AddUndecidedTo(CLI::App& command);

  /// Throws UsageError for what the command line alone shows to be wrong.
  void Check() const;

  /// Of all layers that do not say so themselves.
  [[nodiscard]] const RangeRule& Range() const { return range_; }
  [[nodiscard]] bool Logarithm() const { return Log; }
  /// The colour in the place of the map's; none: by value.
  [[nodiscard]] std::optional<std::array<double, 3>> Solid() const;
  /// The colours without bands. `map`: another map than that of all layers. Throws UsageError where
  /// there is no such map.
  [[nodiscard]] ColorMap MapOver(
    const std::array<double, 2>& range, const std::optional<std::string>& map = {}) const;

  /// The same in bands, as a table of a scalar bar.
  [[nodiscard]] vtkSmartPointer<vtkLookupTable> TableOver(
    const std::array<double, 2>& range, const std::optional<std::string>& map = {}) const;

  /// So many steps of colour in the place of a smooth map; none: smooth.
  [[nodiscard]] std::optional<int> Bands() const { return bands_; }
  /// The colour of pixels that are not proven; none: they are not marked.
  [[nodiscard]] std::optional<Rgba> Undecided() const;

  /// Of alpha 0 where there is none.
  [[nodiscard]] Rgba BackgroundColor() const;
  /// The frame's colours in front of the background; with alpha where there is none.
  [[nodiscard]] Image Flatten(const Frame& frame) const;

private:
  /// Sets what does not depend on the table's colours: the logarithm and the colour of NaN.
  void SetScale(vtkLookupTable& table) const;

  std::string Map = "viridis";
  RangeRule range_;
  std::vector<double> Color;
  bool Log = false;
  std::vector<double> NanColor;
  std::optional<int> bands_;
  bool ShowUndecided = false;
  std::vector<double> UndecidedColor{ 1.0, 0.0, 0.5 };
  std::optional<std::array<double, 3>> Background{ { 1.0, 1.0, 1.0 } };
};

/// Throws UsageError where there is no such colour map, Error where it is a file's and that cannot
/// be read.
void CheckMap(const char* option, const std::string& map);

/// Throws UsageError where a logarithm is asked for over a range that is not above 0.
void CheckLogarithm(const char* option, const RangeRule& range);
} // namespace pixelexact
