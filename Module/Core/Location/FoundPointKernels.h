// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

// Processes whole packs of points after the inverse map.
namespace pixelexact
{
/// Lists which of `count` are not RootInside, in ascending order, and returns their number.
int FindOthers(const double* status, int count, int* others);

/// Moves xi, residuals and numbers of points with RootInside to the front, in order, fills the
/// result's arrays up with the last to whole packs, and returns their number. Status and margins
/// stay unchanged.
int KeepInside(const InverseResult& result, int count, int* numbers);
} // namespace pixelexact
