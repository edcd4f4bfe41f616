// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// A positive integer without separator or decimal point is a count ("round" before it changes
/// nothing), everything else values; a separator behind a single number makes it a value. Throws
/// UsageError.
ContourRule ReadContours(const std::string& option, const std::string& text, char separator);

/// Which contours render draws, and how.
class ContourOptions
{
public:
  static constexpr int kMax = 10000; ///< values of a layer

  void AddTo(CLI::App& added);

  /// Throws UsageError for what the command line alone shows to be wrong, and for options that have
  /// no effect.
  void Check(const std::vector<LayerSettings>& layers) const;

  /// Whether there are any.
  [[nodiscard]] bool AreGiven() const { return Choice.has_value(); }
  /// Of all layers that do not say so themselves.
  [[nodiscard]] const ContourRule& OfAll() const { return *Choice; }
  [[nodiscard]] ContourStyle Style() const;
  /// How pixels are told.
  [[nodiscard]] ContourMethod ProofMethod() const;
  /// One for each value in the order given, or one for all; empty: by the colour map.
  [[nodiscard]] const std::vector<Rgba>& Colors() const { return colors_; }
  [[nodiscard]] bool ByMap() const { return colors_.empty(); }
  /// Without the colours of the surface.
  [[nodiscard]] bool Only() const { return only_; }
  /// The height of labels in pixels; none: no labels.
  [[nodiscard]] std::optional<int> Labels() const;
  /// `background`: the colour in the place of the surface's, with Only.
  [[nodiscard]] ContourAppearance MakeAppearance(const Rgba& background) const;

private:
  void ReadColors(const std::string& text);

  const CLI::App* Command = nullptr;
  std::optional<ContourRule> Choice;
  double Width = 0.0;
  ContourMethod Method;
  bool Interval = false; ///< --certifier interval
  double Effort = 0.0;
  int Subdivisions = 0;
  std::vector<Rgba> colors_{ { 0, 0, 0, 255 } };
  bool ShowUndecided = false;
  std::vector<double> UndecidedColor{ 0.0, 0.5, 0.5 };
  bool only_ = false;
  std::optional<double> LabelHeight;
};
} // namespace pixelexact
