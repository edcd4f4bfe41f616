// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/BezierPatch.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// Reads the bicubic patches of a text file: per patch 16 lines "x y z", rows of u. Blank lines and
/// text after # are ignored. Throws Error, naming file and line, for other lines, for numbers that
/// are not finite, and where the last patch lacks points.
std::vector<BezierPatch> ReadPatches(const std::string& file);
} // namespace pixelexact
