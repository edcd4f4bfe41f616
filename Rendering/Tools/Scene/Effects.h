// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

// An option that changes nothing is a misunderstanding: it is refused, by its name.
namespace pixelexact
{
class ContourOptions;
struct LayerSettings;

/// Throws UsageError for an option of all surfaces that each of them overrides.
void CheckEffects(const CLI::App& command, const std::vector<LayerSettings>& layers);

/// The same for what colours by value, lights and opacity, where `option` paints a legend's colours
/// in their place.
void CheckEffectsBeside(
  const std::string& option, const CLI::App& command, const std::vector<LayerSettings>& layers);

/// The same for what colours surfaces, where none of their colours are shown, but those of
/// contours: these may be the colour map's, and spaced over its range.
void CheckEffectsWithoutColors(const ContourOptions& contours, const CLI::App& command,
  const std::vector<LayerSettings>& layers);

/// Throws Error for an option that needs a field: the input has none.
void CheckEffectsWithoutField(const CLI::App& command, const std::vector<LayerSettings>& layers);
} // namespace pixelexact
