// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
struct Field;
struct Scene;

/// The texture of a line integral convolution, by pixel, lower left first.
struct ConvolvedNoise
{
  /// 0 to 1, with a mean of 0.5; NaN where no surface is visible, or it has no direction.
  std::vector<float> values;
  std::int64_t samples = 0; ///< number of evaluated vectors
};

/// Averages noise along the streamlines of the tangential part of a vector field on the visible
/// surfaces of a scene, so that the texture shows directions at each pixel.
///
/// Sources: B. Cabral, L. Leedom, Imaging vector fields using line integral convolution, 1993; D.
/// Stalling, H.-C. Hege, Fast and resolution independent line integral convolution, 1995 (each
/// streamline serves many pixels). Departure: a streamline is integrated in the picture by the
/// midpoint rule in steps of a pixel, and each of its vectors is evaluated exactly at the point of
/// the surface that the ray of that position hits; no vector is interpolated between pixels or
/// nodes. Streamlines end where the surface ends or another one is in front, where the
/// vector has no tangential part above its rounding, and where nothing is known.
///
/// `halfLength`: pixels along a streamline to each side that are averaged, 1 or more. `field` has 2
/// or 3 components. The result does not depend on the number of threads. Throws Error as tracing
/// does.
[[nodiscard]] ConvolvedNoise ConvolveNoise(const Scene& scene, const CameraView& view, int width,
  int height, const Field& field, int halfLength);
} // namespace pixelexact
