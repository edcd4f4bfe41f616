// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
class ColorOptions;
class Looks;
struct Frame;
struct Shot;

/// A picture with what a reader needs: bars of the colours with ticks and the fields' names, a
/// title, the time, the axes, a scale where lengths in the picture have one, and what pixels show
/// no value.
class FigureOptions
{
public:
  void AddTo(CLI::App& command);

  [[nodiscard]] bool IsAsked() const { return Asked; }
  /// Throws UsageError where a figure of this size has no room for a picture.
  void Check(const ImageSize& size) const;
  /// Of the picture in a figure: what is left of it and above are margins.
  [[nodiscard]] ImageSize PictureSize(const ImageSize& figure) const;

  /// The figure around a frame's picture; three bytes a pixel, lower left first. `bars`: the map's
  /// colours are seen.
  [[nodiscard]] std::vector<std::uint8_t> Draw(const ImageSize& figure, const Shot& shot,
    const Looks& looks, const Frame& frame, const ColorOptions& colors, bool bars) const;

private:
  /// In pixels.
  [[nodiscard]] int FontOf(const ImageSize& figure) const;

  bool Asked = false;
  std::string Title;
  std::optional<double> FontSize;
};
} // namespace pixelexact
