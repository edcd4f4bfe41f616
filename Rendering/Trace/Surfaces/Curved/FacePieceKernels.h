// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
/// What LookKernels and PieceKernels do, for pieces of faces: in the two xi of the face's chart, so
/// that a ray is two equations for two unknowns. In lanes, with the same bits on all instruction
/// sets.
struct FacePieceKernels
{
  /// As LookKernels::look.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const RaySet& rays, PiecePairs& pairs);
  /// As PieceKernels::step, with other `values`: y (3), a row that is not read, and the derivatives
  /// of y by the chart's u and v (6).
  void (*step)(const RayBundle& bundle, const ElementFrame& frame, const double* values,
    std::size_t stride, PiecePairs& pairs, double* const position[3], double* result);
};

const FacePieceKernels& GetFacePieceKernels();
} // namespace pixelexact
