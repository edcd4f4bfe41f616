// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Compare/LinearSurface.h"
#include "Trace/Compare/PictureErrors.h"
#include "Trace/Scene.h"
#include "Trace/Tracer.h"

#include <vector>

namespace pixelexact
{
/// The exact picture of a scene of one layer. `colors`, if any, are made tile by tile. Contours are
/// classified if there are iso-values. Throws Error as Trace does. Returns an empty picture if
/// `progress` aborted it.
[[nodiscard]] Picture TracePicture(const Scene& scene, const Camera& camera,
  const std::vector<const SampleColors*>& colors, const std::vector<double>& isoValues,
  const ContourMethod& method, const Progress& progress = {});

/// The picture of the same view in a linear pipeline. Empty if `progress` aborted it.
[[nodiscard]] Picture TracePicture(const LinearSurface& surface, const Camera& camera,
  const std::vector<double>& isoValues, const Progress& progress = {});
} // namespace pixelexact
