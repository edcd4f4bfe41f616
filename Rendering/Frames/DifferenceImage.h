// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Compare/FieldDifference.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <span>

class vtkImageData;

namespace pixelexact
{
/// A difference's buffers as point arrays of an image, one point per pixel, lower left first
/// (ToImageData), and the arrays First, Second, Side and Seen. `firstCells`, `secondCells`: source
/// cells of the two meshes' elements; empty: element numbers are kept.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkImageData> ToImageData(
  const FieldDifference& difference, std::span<const std::int64_t> firstCells,
  std::span<const std::int64_t> secondCells);
} // namespace pixelexact
