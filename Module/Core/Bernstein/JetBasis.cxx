// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/JetBasis.h"

namespace pixelexact
{
// The lines are filled below.
JetBasis::JetBasis(const Degrees& degree, const Parameters& t, Parts parts)
  : Degree(degree)
{
  for (std::size_t d = 0; d < 3; ++d)
  {
    FillBasis(degree[d], t[d], Basis[d]);
    if (parts == Parts::Jets)
    {
      FillSlopes(degree[d], t[d], Slope[d]);
    }
  }
}

/// B_0 .. B_n at t, by convex combinations.
void JetBasis::FillBasis(int n, double t, Line& basis)
{
  basis[0] = 1.0;
  for (int level = 1; level <= n; ++level)
  {
    basis[static_cast<std::size_t>(level)] = t * basis[static_cast<std::size_t>(level - 1)];
    for (auto i = static_cast<std::size_t>(level - 1); i > 0; --i)
    {
      basis[i] = (1.0 - t) * basis[i] + t * basis[i - 1];
    }
    basis[0] *= 1.0 - t;
  }
}

/// Derivatives of B_0 .. B_n at t.
void JetBasis::FillSlopes(int n, double t, Line& slope)
{
  if (n == 0)
  {
    slope[0] = 0.0;
    return;
  }
  Line lower;
  FillBasis(n - 1, t, lower);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i)
  {
    const double left = i > 0 ? lower[i - 1] : 0.0;
    const double right = i < static_cast<std::size_t>(n) ? lower[i] : 0.0;
    slope[i] = n * (left - right);
  }
}

double JetBasis::ValueOf(std::span<const double> coefficients) const
{
  double value = 0.0;
  const double* b = coefficients.data();
  for (std::size_t i = 0; i <= static_cast<std::size_t>(Degree[0]); ++i)
  {
    double row = 0.0;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(Degree[1]); ++j)
    {
      double line = 0.0;
      for (std::size_t k = 0; k <= static_cast<std::size_t>(Degree[2]); ++k, ++b)
      {
        line += *b * Basis[2][k];
      }
      row += Basis[1][j] * line;
    }
    value += Basis[0][i] * row;
  }
  return value;
}

Jet JetBasis::JetOf(std::span<const double> coefficients) const
{
  Jet jet;
  const double* b = coefficients.data();
  for (std::size_t i = 0; i <= static_cast<std::size_t>(Degree[0]); ++i)
  {
    double row = 0.0;
    double row1 = 0.0;
    double row2 = 0.0;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(Degree[1]); ++j)
    {
      double line = 0.0;
      double line2 = 0.0;
      for (std::size_t k = 0; k <= static_cast<std::size_t>(Degree[2]); ++k, ++b)
      {
        line += *b * Basis[2][k];
        line2 += *b * Slope[2][k];
      }
      row += Basis[1][j] * line;
      row1 += Slope[1][j] * line;
      row2 += Basis[1][j] * line2;
    }
    jet.value += Basis[0][i] * row;
    jet.gradient[0] += Slope[0][i] * row;
    jet.gradient[1] += Basis[0][i] * row1;
    jet.gradient[2] += Basis[0][i] * row2;
  }
  return jet;
}
} // namespace pixelexact
