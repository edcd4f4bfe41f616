// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <vector>

// Elements that another process holds, too (HighOrderModel::IsGhost): they are there for what is
// beside them, edges and contours that end at a pixel's corner; whoever holds them draws them.
namespace pixelexact
{
class HighOrderModel;

/// Whether the model has some. Not of composite data: where another block has the same element, the
/// copy may be the one that is found.
[[nodiscard]] bool HasGhosts(const HighOrderModel& model);

/// Of a model that has some: takes the depths away from samples in such elements, so that they are
/// not drawn; the samples must hold Buffer::Element.
void HideGhosts(
  const SampleBuffers& samples, const HighOrderModel& model, std::vector<float>& depths);
} // namespace pixelexact
