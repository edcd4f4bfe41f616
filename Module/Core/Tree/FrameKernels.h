// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

// The sums over a box's coefficients that determine a frame (NodeFrame.h), dispatched at run time
// to the instruction set; the bits do not depend on it.
namespace pixelexact
{
/// Three functions over a box and the frame that they are to be compared with. All arrays hold
/// `size` numbers, at least 8; those beyond the coefficients repeat the last.
struct FrameTask
{
  std::size_t size;
  const double* phi[3];
  double shift[3]; ///< taken off phi
  const double* inverse;
  const double* grid[3];     ///< coefficients of xi - centre
  const double (*normal)[3]; ///< of six ends, in xi; null where they are -e_1, e_1, -e_2, ..., e_3
  double* deviation[3];      ///< out: A^-1 (phi - shift) - grid
};

struct FrameSums
{
  double least[3]; ///< of the deviation
  double most[3];
  double outer[6]; ///< the most of normal . A^-1 (phi - shift)
  double inner[6]; ///< the least of normal . deviation
  double all;      ///< zero where everything is finite, else infinite
};

/// The least and the most of differences; both zero where there are none.
struct FrameSteps
{
  double least;
  double most;
};

struct FrameKernels
{
  FrameSums (*measure)(const FrameTask& task);
  /// to[d][k] = from[d] + k step[d] for three arrays of `count` numbers.
  void (*fillLine)(
    const double from[3], const double step[3], std::size_t count, double* const to[3]);
  /// The most of normal . (phi - shift) for six normals in y. All is finite.
  void (*outermost)(const FrameTask& task, const double (*normal)[3], double outer[6]);
  /// The extremes of the differences of neighbours along a direction: `count` coefficients,
  /// `stride` apart. Reads eight numbers beyond the row.
  FrameSteps (*steps)(const double* row, std::size_t size, std::size_t count, std::size_t stride);
};

const FrameKernels& GetFrameKernels();
} // namespace pixelexact
