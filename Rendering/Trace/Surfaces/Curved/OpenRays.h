// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/RayBundle.h"

#include <vector>

namespace pixelexact
{
/// A ray that a look at a piece leaves open, and where in the piece its roots may be.
enum OpenColumn
{
  kOpenRayColumn,
  kOpenSlackColumn,                        ///< how far off places may be, in the element's units
  kOpenSlopeColumn,                        ///< 2: of the ray
  kOpenPlaceColumn = kOpenSlopeColumn + 2, ///< 2: as of a pair
  kOpenLowerColumn = kOpenPlaceColumn + 2, ///< 3: xi, from the piece's centre
  kOpenUpperColumn = kOpenLowerColumn + 3, ///< 3
  kOpenXiColumn = kOpenUpperColumn + 3,    ///< 3: a point of the piece near the root
  kOpenSideColumn = kOpenXiColumn + 3,     ///< 3: as of a pair
  kOpenLeastColumn = kOpenSideColumn + 3,
  kOpenColumns
};

/// A ray may be there twice, with two places.
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
