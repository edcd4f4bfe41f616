// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/ChebyshevBasis.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
const ChebyshevInBernstein& ChebyshevInBernstein::Get()
{
  static const ChebyshevInBernstein kBasis;
  return kBasis;
}

// T_n has (-1)^(n-i) C(2n, 2i) / C(n, i) in its own degree, which is then raised.
ChebyshevInBernstein::ChebyshevInBernstein()
{
  constexpr int kDegree = ChebyshevModel::kDegree;
  for (int n = 0; n <= kDegree; ++n)
  {
    auto& b = column[static_cast<std::size_t>(n)];
    double even = 1.0; // C(2n, 2i)
    double all = 1.0;  // C(n, i)
    for (int i = 0; i <= n; ++i)
    {
      b[static_cast<std::size_t>(i)] = ((n - i) % 2 == 0 ? 1.0 : -1.0) * even / all;
      even = even * (2 * n - 2 * i) / (2 * i + 1) * (2 * n - 2 * i - 1) / (2 * i + 2);
      all = all * (n - i) / (i + 1);
    }
    for (int m = n; m < kDegree; ++m)
    {
      b[static_cast<std::size_t>(m) + 1] = b[static_cast<std::size_t>(m)];
      for (int i = m; i > 0; --i)
      {
        const double part = static_cast<double>(i) / (m + 1);
        b[static_cast<std::size_t>(i)] =
          part * b[static_cast<std::size_t>(i) - 1] + (1.0 - part) * b[static_cast<std::size_t>(i)];
      }
    }
    for (const double value : b)
    {
      largest = std::max(largest, std::fabs(value));
    }
  }
}
} // namespace pixelexact
