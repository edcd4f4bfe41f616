// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Nurbs/PatchTopology.h"

// The knot vectors along the edges of a NURBS mesh's patches.
namespace pixelexact::mfem
{
/// Where the file lists none: by what patches share, edges on opposite sides having the same one.
/// Sets `knots` and `vectors`.
void MakeKnotVectors(PatchTopology& topology);

/// Turns edges so that all of a patch's direction run in one sense, beginning with the last patch,
/// and sets `lines`. Fails by `scanner` where that cannot be.
void OrientKnotVectors(const TextScanner& scanner, PatchTopology& topology);
} // namespace pixelexact::mfem
