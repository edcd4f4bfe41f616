// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

namespace pixelexact
{
/// Seconds that the bare evaluation kernel takes for `points` points, on all threads: random xi of
/// one element of the most frequent space, without location, colour or memory traffic. It is the
/// limit that a frame is measured against.
double KernelSeconds(const Expansion& field, std::int64_t points);
} // namespace pixelexact
