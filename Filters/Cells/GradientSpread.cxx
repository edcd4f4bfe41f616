// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/GradientSpread.h"

#include <algorithm>
#include <array>
#include <cmath>

// J = A + E, |E_cd| <= R_cd. If the largest row sum rho of |A^-1| R is below 1, A + t E is regular
// for all t in [0,1]: det J has the sign of det A, and |det J| >= |det A| (1 - rho)^3, for the
// eigenvalues of A^-1 J are no nearer to 0 than 1 - rho.
namespace pixelexact
{
namespace
{
/// Rounding is far below what this leaves.
constexpr double kLargestRow = 0.999;

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix Cofactors(const Matrix& a)
{
  Matrix cofactors{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t i1 = (i + 1) % 3;
      const std::size_t i2 = (i + 2) % 3;
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      cofactors[i][j] = a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
    }
  }
  return cofactors;
}
} // namespace

GradientSpread::GradientSpread(const Space& space, const LanePoints& samples)
{
  const auto modes = static_cast<std::size_t>(space.Modes());
  const auto padded = static_cast<std::size_t>(PaddedCount(samples.count));
  const auto count = static_cast<std::size_t>(samples.count);
  std::vector<double> unit(modes);
  std::vector<double> table(4 * padded);
  double* value = table.data();
  std::array<double*, 3> gradient{ &table[padded], &table[2 * padded], &table[3 * padded] };
  const KernelSet kernels = KernelsFor(space);
  for (std::size_t mode = 0; mode < modes; ++mode)
  {
    unit[mode] = 1.0;
    kernels.gradient(space, unit.data(), 1, samples, &value, gradient.data());
    unit[mode] = 0.0;
    for (const double* derivative : gradient)
    {
      const auto [least, most] = std::minmax_element(derivative, derivative + count);
      Ranges.push_back({ 0.5 * (*least + *most), 0.5 * (*most - *least) });
    }
  }
}

int GradientSpread::SignOfJacobian(const double* coefficients, double vanishing) const
{
  const std::size_t modes = Ranges.size() / 3;
  Matrix a{};
  Matrix reach{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t mode = 0; mode < modes; ++mode)
    {
      const double coefficient = coefficients[c * modes + mode];
      const double size = std::fabs(coefficient);
      for (std::size_t d = 0; d < 3; ++d)
      {
        a[c][d] += coefficient * Ranges[3 * mode + d].middle;
        reach[c][d] += size * Ranges[3 * mode + d].reach;
      }
    }
  }
  const Matrix cofactors = Cofactors(a);
  const double det =
    a[0][0] * cofactors[0][0] + a[0][1] * cofactors[0][1] + a[0][2] * cofactors[0][2];
  double rho = 0.0;
  double columns = 1.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double row = 0.0;
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      // Row i of the inverse is column i of the cofactors.
      row += std::fabs(cofactors[c][i]) * (reach[c][0] + reach[c][1] + reach[c][2]);
      const double most = std::fabs(a[c][i]) + reach[c][i];
      square += most * most;
    }
    rho = std::max(rho, row);
    columns *= std::sqrt(square);
  }
  rho /= std::fabs(det);
  const double rest = 1.0 - rho;
  if (!(rho <= kLargestRow) || !(std::fabs(det) * rest * rest * rest > vanishing * columns))
  {
    return 0;
  }
  return det > 0.0 ? 1 : -1;
}
} // namespace pixelexact
