// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceKernels.h"

#include <algorithm>

namespace pixelexact
{
void PiecePairs::DropEnded()
{
  std::array<int, kStride / kLanePadding> kept{};
  std::size_t packs = 0;
  double* isOpen = Column(kOpenColumn);
  std::fill_n(isOpen + count, kLanePadding, 0.0);
  for (int i = 0; i < count; i += kLanePadding)
  {
    if (std::any_of(isOpen + i, isOpen + i + kLanePadding, [](double one) { return one != 0.0; }))
    {
      kept[packs++] = i;
    }
  }
  if (static_cast<int>(packs) * kLanePadding >= count)
  {
    return;
  }
  for (int column = 0; column < kPairColumns; ++column)
  {
    double* numbers = Column(column);
    for (std::size_t k = 0; k < packs; ++k)
    {
      std::copy_n(numbers + kept[k], kLanePadding, numbers + k * kLanePadding);
    }
  }
  count = static_cast<int>(packs) * kLanePadding;
}
} // namespace pixelexact
