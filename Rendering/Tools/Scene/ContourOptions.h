// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/ImageSize.h"

#include "Trace/Appearance/Appearance.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
struct LayerSettings;

/// Parses contours. A positive integer without separator or decimal point is a count ("round"
/// before it changes nothing), everything else is a list of values. A separator after a single
/// number makes it a value. Throws UsageError.
ContourRule ReadContours(const std::string& option, const std::string& text, char separator);

/// Options of the contours that render draws.
class ContourOptions
{
public:
  static constexpr int kMax = 10000; ///< values of a layer

  void AddTo(CLI::App& added);

  /// Throws UsageError for errors that depend on the command line only, and for options that have
  /// no effect.
  void Check(const std::vector<LayerSettings>& layers) const;

  /// Converts lengths in points, as PixelLength::Resolve. The height of labels is rounded.
  void ResolveLengths(const std::optional<double>& dpi);

  /// Whether contours are requested.
  [[nodiscard]] bool AreGiven() const { return Choice.has_value(); }
  /// The contours of layers without their own.
  [[nodiscard]] const ContourRule& OfAll() const { return *Choice; }
  [[nodiscard]] ContourStyle Style() const;
  /// The method that classifies pixels.
  [[nodiscard]] ContourMethod ProofMethod() const;
  /// The colours: one for each value in the given order, or one for all; empty: by the colour map.
  [[nodiscard]] const std::vector<Rgba>& Colors() const { return colors_; }
  [[nodiscard]] bool ByMap() const { return colors_.empty(); }
  /// Whether the surface's colours are left out.
  [[nodiscard]] bool Only() const { return only_; }
  /// The height of labels in pixels; none: no labels.
  [[nodiscard]] std::optional<int> Labels() const;
  /// `background`: the colour that replaces the surface's, with Only.
  [[nodiscard]] ContourAppearance MakeAppearance(const Rgba& background) const;

private:
  void ReadColors(const std::string& text);

  const CLI::App* Command = nullptr;
  std::optional<ContourRule> Choice;
  PixelLength Width;
  ContourMethod Method;
  bool Interval = false; ///< --certifier interval
  double Effort = 0.0;
  int Subdivisions = 0;
  std::vector<Rgba> colors_{ { 0, 0, 0, 255 } };
  bool ShowUndecided = false;
  std::vector<double> UndecidedColor{ 0.0, 0.5, 0.5 };
  bool only_ = false;
  std::optional<PixelLength> LabelHeight;
};
} // namespace pixelexact
