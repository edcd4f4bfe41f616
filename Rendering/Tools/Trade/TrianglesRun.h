// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Shot.h"
#include "Trade/TradeRun.h"

#include "Trace/Compare/LinearSurface.h"
#include "Trace/Compare/TracedPicture.h"

#include <cstddef>
#include <optional>

namespace pixelexact
{
/// A run that leaves triangles, without VTK's filters.
class TrianglesRun : public TradeRun
{
public:
  explicit TrianglesRun(const TradeScene& scene)
    : scene_(scene)
  {
  }

  Picture Show() override
  {
    return TracePicture(*Linear, scene_.shot->MakeCamera(), scene_.isoValues);
  }

  [[nodiscard]] std::size_t Triangles() const override { return Linear ? Linear->Count() : 0; }

protected:
  const TradeScene& scene_;
  std::optional<LinearSurface> Linear; ///< of the last Measure
};
} // namespace pixelexact
