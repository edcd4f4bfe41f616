// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

// What a search does with whole packs of points after the inverse map.
namespace pixelexact
{
/// Which of `count` are not RootInside, in ascending order; returns how many.
int FindOthers(const double* status, int count, int* others);

/// Moves xi, residuals and numbers of those that are RootInside to the front, in order, and fills
/// the result's arrays up with the last, to whole packs; returns how many. Status and margins are
/// left as they are.
int KeepInside(const InverseResult& result, int count, int* numbers);
} // namespace pixelexact
