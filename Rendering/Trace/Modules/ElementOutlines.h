// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"
#include "Trace/Pipeline.h"

namespace pixelexact
{
/// Paints the pixels in which elements, or layers, meet: those whose centre and corners are all
/// Exact, and not all of one element and layer. So what is shown has no outline where it ends. Of
/// translucent layers the nearest sheet counts. The frame's image alone changes; without colours it
/// does nothing. Belongs after Antialiasing, which would smooth the lines away.
class ElementOutlines final : public FrameModule
{
public:
  explicit ElementOutlines(const Rgba& color = { 0, 0, 0, 255 });

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;

private:
  Rgba Color;
};
} // namespace pixelexact
