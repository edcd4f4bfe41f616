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
/// What the command line says of one surface; none: as all.
struct LayerSettings
{
  std::optional<std::string> field;
  std::optional<int> component; ///< or kMagnitude
  std::optional<Precision> precision;
  double opacity = 1.0;
  std::optional<std::string> colormap;
  std::optional<RangeRule> range;
  std::optional<std::array<double, 3>> color; ///< in the place of a colour map
  std::optional<bool> lights;
  std::optional<ContourRule> contours;
};

/// Surfaces that are shown in a way of their own: --layer, any number of times.
class LayerOptions
{
public:
  void AddTo(CLI::App& command);

  /// One for each surface. Throws UsageError for what is not understood, and for numbers of
  /// surfaces that are not there.
  [[nodiscard]] std::vector<LayerSettings> Make(std::size_t surfaces) const;

private:
  std::vector<std::string> Texts;
};

/// "magnitude" or a number from 0; none otherwise.
std::optional<int> ParseComponent(const std::string& text);
} // namespace pixelexact
