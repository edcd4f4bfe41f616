// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Math/Mat.h"
#include "Trace/Modules/Lighting.h"

#include <array>
#include <span>

namespace pixelexact
{
/// The lights, view and material of samples without specular reflection.
struct MattLights
{
  const LitView& view;
  const Mat3& normalMatrix; ///< of view.linear
  const Material& material; ///< its specular is 0
  std::span<const ParallelLight> lights;
};

/// Samples as a structure of arrays, in their own space; arrays are padded to whole packs.
struct LitSamples
{
  LanePoints position;
  LanePoints normal;
  std::array<double*, 3> color; ///< unlit from 0 to 1, then lit, not clamped
  double* isLit;                ///< 1, or 0 where a number is not finite
  int count;
};

/// Kernels in lanes, dispatched at run time to the instruction set. All instruction sets give the
/// same bits as Lighting's loop over single samples.
struct LightKernels
{
  void (*shine)(const MattLights& lights, const LitSamples& samples);
};

const LightKernels& GetLightKernels();
} // namespace pixelexact
