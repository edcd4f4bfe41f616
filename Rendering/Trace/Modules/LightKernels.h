// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Math/Mat.h"
#include "Trace/Modules/Lighting.h"

#include <array>
#include <span>

namespace pixelexact
{
/// What samples of a matt material are lit by, and how they are seen.
struct MattLights
{
  const LitView& view;
  const Mat3& normalMatrix; ///< of view.linear
  const Material& material; ///< its specular is 0
  std::span<const ParallelLight> lights;
};

/// Samples, coordinate by coordinate, in their own space; arrays have room for whole packs.
struct LitSamples
{
  LanePoints position;
  LanePoints normal;
  std::array<double*, 3> color; ///< unlit from 0 to 1, then lit, not clamped
  double* isLit;                ///< 1; 0 where something is not finite
  int count;
};

/// In lanes, dispatched at run time to the instruction set. All of them give the same bits, and
/// those of one sample after the other.
struct LightKernels
{
  void (*shine)(const MattLights& lights, const LitSamples& samples);
};

const LightKernels& GetLightKernels();
} // namespace pixelexact
