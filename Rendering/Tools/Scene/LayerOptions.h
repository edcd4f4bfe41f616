// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Scene/ContourOptions.h"
#include "Scene/LayerRanges.h"

#include "Core/Location/Sample.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The settings of one surface in the command line; none: as for all surfaces.
struct LayerSettings
{
  std::optional<std::string> field;
  std::optional<int> component; ///< or kMagnitude
  std::optional<Precision> precision;
  double opacity = 1.0;
  std::optional<std::string> colormap;
  std::optional<RangeRule> range;
  std::optional<std::array<double, 3>> color; ///< replaces the colour map
  std::optional<bool> lights;
  std::optional<ContourRule> contours;
};

/// Surfaces with settings of their own: --layer, any number of times.
class LayerOptions
{
public:
  void AddTo(CLI::App& command);

  /// The settings of each surface. Throws UsageError for settings that are not understood, and for
  /// numbers of surfaces that do not exist.
  [[nodiscard]] std::vector<LayerSettings> Make(std::size_t surfaces) const;

private:
  std::vector<std::string> Texts;
};

/// Parses "magnitude" or a number from 0; none otherwise.
std::optional<int> ParseComponent(const std::string& text);
} // namespace pixelexact
