// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/FacePixels.h"

#include "Core/Element/Kernels.h"

#include <initializer_list>

namespace pixelexact
{
void FacePixels::Begin(std::size_t most)
{
  Size = 0;
  Stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(most)));
  if (Storage.size() < kColumns * Stride)
  {
    Storage.resize(kColumns * Stride);
  }
}

void FacePixels::Add(double u, double v, const Vec3& xi, const Vec3& position, const Vec3& normal)
{
  double* to = Storage.data() + Size;
  const auto put = [&to, this](double value)
  {
    *to = value;
    to += Stride;
  };
  put(u);
  put(v);
  for (const Vec3* const one : { &xi, &position, &normal })
  {
    put(one->x);
    put(one->y);
    put(one->z);
  }
  ++Size;
}
} // namespace pixelexact
