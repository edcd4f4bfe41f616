// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/BezierPatch.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// The bicubic patches of a text file: per patch 16 lines "x y z", rows of u; blank lines count
/// nothing, nor does what stands behind a #. Throws Error, naming file and line, for what is no
/// such line, for numbers that are not finite, and where the last patch lacks points.
std::vector<BezierPatch> ReadPatches(const std::string& file);
} // namespace pixelexact
