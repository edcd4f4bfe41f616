// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

namespace pixelexact
{
/// Values to straight RGBA bytes. Called from several threads at once, with NaN among the values.
using ColorMap = std::function<void(std::span<const double> values, std::uint8_t* rgba)>;

/// The colour mapping module (paper, section 5.2): each exact pixel gets the colour of its own
/// value; pixels whose verdict is Unknown get `unknownColor`; the rest stays transparent.
class ColorMapping final : public FrameModule
{
public:
  explicit ColorMapping(
    ColorMap map, std::array<std::uint8_t, 4> unknownColor = { 255, 0, 255, 255 });

  [[nodiscard]] SampleNeeds Needs() const override;
  void Process(Frame& frame) const override;

private:
  ColorMap Map;
  std::array<std::uint8_t, 4> UnknownColor;
};
} // namespace pixelexact
