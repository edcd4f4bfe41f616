// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
/// The kernels of LookKernels and PieceKernels for pieces of faces. They work in the two xi of the
/// face's chart, so that a ray gives two equations for two unknowns. In lanes, with the same bits
/// on all instruction sets.
struct FacePieceKernels
{
  /// As LookKernels::look, but appends pairs.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const RaySet& rays, PiecePairs& pairs);
  /// As PieceKernels::step, with other `values`: y (3), an unused row, and the derivatives of y by
  /// the chart's u and v (6).
  void (*step)(const RayBundle& bundle, const ElementFrame& frame, const double* values,
    std::size_t stride, PiecePairs& pairs, double* const position[3], double* result);
};

const FacePieceKernels& GetFacePieceKernels();
} // namespace pixelexact
