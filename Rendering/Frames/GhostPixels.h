// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <vector>

// Elements that another process also holds (HighOrderModel::IsGhost). They support their
// neighbours' edges and contours at pixels' corners; the owning process draws them.
namespace pixelexact
{
class HighOrderModel;

/// The model has ghost elements. False for composite data: if another block contains the same
/// element, location may find the copy.
[[nodiscard]] bool HasGhosts(const HighOrderModel& model);

/// For a model with ghost elements: removes the depths of samples in them, so that they are not
/// drawn. The samples must hold Buffer::Element.
void HideGhosts(
  const SampleBuffers& samples, const HighOrderModel& model, std::vector<float>& depths);
} // namespace pixelexact
