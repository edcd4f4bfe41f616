// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"
#include "Trace/Pipeline.h"

namespace pixelexact
{
/// Paints the pixels at which elements or layers meet: centre and corners are all Exact, but not
/// all of one element and layer. So the surface's end has no outline. Of translucent layers the
/// nearest sheet counts. Changes only the frame's image; without colours it does nothing. Belongs
/// after Antialiasing, which would smooth the lines.
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
