// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Math/Vec.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// Points as the kernels take them: coordinate by coordinate, padded with the last.
class LaneBuffer
{
public:
  explicit LaneBuffer(std::span<const Vec3> points)
    : Count(static_cast<int>(points.size()))
    , Storage(3 * static_cast<std::size_t>(PaddedCount(Count)))
  {
    const std::size_t stride = Storage.size() / 3;
    for (std::size_t k = 0; k < stride; ++k)
    {
      const Vec3& x = points[k < points.size() ? k : points.size() - 1];
      for (std::size_t d = 0; d < 3; ++d)
      {
        Storage[d * stride + k] = x[static_cast<int>(d)];
      }
    }
  }

  [[nodiscard]] LanePoints View() const
  {
    const std::size_t stride = Storage.size() / 3;
    return { { Storage.data(), Storage.data() + stride, Storage.data() + 2 * stride }, Count };
  }

private:
  int Count;
  std::vector<double> Storage;
};
} // namespace pixelexact
