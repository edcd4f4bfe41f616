// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Compare/LinearSurface.h"
#include "Trace/Compare/PictureErrors.h"
#include "Trace/Scene.h"
#include "Trace/Tracer.h"

#include <vector>

namespace pixelexact
{
/// The exact picture of a scene of one layer, with `colors` made tile by tile where there are any,
/// and with contours where there are iso-values. Throws Error as Trace does. Of no size where
/// `progress` aborted it.
[[nodiscard]] Picture TracePicture(const Scene& scene, const Camera& camera,
  const std::vector<const SampleColors*>& colors, const std::vector<double>& isoValues,
  const ContourMethod& method, const Progress& progress = {});

/// What a linear pipeline would show of the same view. Of no size where `progress` aborted it.
[[nodiscard]] Picture TracePicture(const LinearSurface& surface, const Camera& camera,
  const std::vector<double>& isoValues, const Progress& progress = {});
} // namespace pixelexact
