// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/ChebyshevModel.h"

#include <array>

namespace pixelexact
{
/// Chebyshev's polynomials in Bernstein's form of degree ChebyshevModel::kDegree over [-1, 1].
struct ChebyshevInBernstein
{
  static constexpr std::size_t kCount = ChebyshevModel::kDegree + 1;

  static const ChebyshevInBernstein& Get();

  std::array<std::array<double, kCount>, kCount> column{}; ///< [n][i]
  double largest = 1.0;                                    ///< of the magnitudes

private:
  ChebyshevInBernstein();
};
} // namespace pixelexact
