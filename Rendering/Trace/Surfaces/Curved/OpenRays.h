// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/RayBundle.h"

#include <vector>

namespace pixelexact
{
/// Columns of a ray that stays open after a look at a piece, and of the box of its roots in the
/// piece.
enum OpenColumn
{
  kOpenRayColumn,
  kOpenSlackColumn,                        ///< error of places, in the element's units
  kOpenSlopeColumn,                        ///< 2: of the ray
  kOpenPlaceColumn = kOpenSlopeColumn + 2, ///< 2: as in PairColumn
  kOpenLowerColumn = kOpenPlaceColumn + 2, ///< 3: xi, relative to the piece's centre
  kOpenUpperColumn = kOpenLowerColumn + 3, ///< 3
  kOpenXiColumn = kOpenUpperColumn + 3,    ///< 3: a point of the piece near the root
  kOpenSideColumn = kOpenXiColumn + 3,     ///< 3: as in PairColumn
  kOpenLeastColumn = kOpenSideColumn + 3,
  kOpenColumns
};

/// Rays that stay open. A ray may occur twice, with two boxes of roots.
struct OpenRays
{
  static constexpr std::size_t kStride = 2 * RayBundle::kMax + 2 * kLanePadding;

  int count = 0;
  std::vector<double> columns = std::vector<double>(kOpenColumns * kStride);

  [[nodiscard]] double* Column(int column)
  {
    return columns.data() + static_cast<std::size_t>(column) * kStride;
  }
};
} // namespace pixelexact
