// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <cstddef>
#include <vector>

namespace pixelexact
{
/// Pixels that show one element, number by number.
class FacePixels
{
public:
  /// Room for so many; what was there is gone.
  void Begin(std::size_t most);
  void Add(double u, double v, const Vec3& xi, const Vec3& position, const Vec3& normal);

  /// u, v and three coordinates each of xi, position and normal.
  static constexpr std::size_t kColumns = 11;
  [[nodiscard]] const double* Column(std::size_t k) const { return Storage.data() + k * Stride; }
  [[nodiscard]] std::size_t Count() const { return Size; }

private:
  std::size_t Size = 0;
  std::size_t Stride = 0;
  std::vector<double> Storage;
};
} // namespace pixelexact
