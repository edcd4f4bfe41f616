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
/// Options of the colours of values, and of the background.
class ColorOptions
{
public:
  void AddTo(CLI::App& command);
  /// Declares the options of the colours of unproven pixels.
  void AddUndecidedTo(CLI::App& command);

  /// Throws UsageError for errors that depend on the command line only.
  void Check() const;

  /// The range rule of layers without their own.
  [[nodiscard]] const RangeRule& Range() const { return range_; }
  [[nodiscard]] bool Logarithm() const { return Log; }
  /// The single colour that replaces the map; none: colours by value.
  [[nodiscard]] std::optional<std::array<double, 3>> Solid() const;
  /// The colours without bands. `map`: the name of another map than the default. Throws UsageError
  /// where it does not exist.
  [[nodiscard]] ColorMap MapOver(
    const std::array<double, 2>& range, const std::optional<std::string>& map = {}) const;

  /// The same in bands, as the table of a scalar bar.
  [[nodiscard]] vtkSmartPointer<vtkLookupTable> TableOver(
    const std::array<double, 2>& range, const std::optional<std::string>& map = {}) const;

  /// The number of bands; none: a smooth map.
  [[nodiscard]] std::optional<int> Bands() const { return bands_; }
  /// The colour of unproven pixels; none: they are not marked.
  [[nodiscard]] std::optional<Rgba> Undecided() const;

  /// The colour of the background; alpha is 0 where there is none.
  [[nodiscard]] Rgba BackgroundColor() const;
  /// The frame's colours over the background; with alpha where there is none.
  [[nodiscard]] Image Flatten(const Frame& frame) const;

private:
  /// Sets the properties that do not depend on the table's colours: the logarithm and the colour of
  /// NaN.
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

/// Throws UsageError where the colour map does not exist, Error where it is in a file that cannot
/// be read.
void CheckMap(const char* option, const std::string& map);

/// Throws UsageError for a logarithm over a range that is not positive.
void CheckLogarithm(const char* option, const RangeRule& range);
} // namespace pixelexact
