// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

namespace pixelexact
{
struct BenchFigureOptions
{
  ImageSize size;
  int repeat = 5;
  int largest = 200000; ///< elements
  bool json = false;
};

/// The paper's figure 10 (a) to (c) on this machine, printed to stdout: frames of a plane that
/// fills the image, through made meshes of each shape, straight and curved; by order, by number of
/// elements and by pixels; on one thread and on all.
void RunFigures(const BenchFigureOptions& options);
} // namespace pixelexact
