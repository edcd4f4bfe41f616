// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/BoxPolynomial.h"

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Index of the coefficient at a corner.
std::size_t CornerIndex(const Degrees& degree, unsigned corner)
{
  std::size_t index = 0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const auto last = static_cast<std::size_t>(degree[d]);
    index = index * (last + 1) + ((corner >> d & 1U) != 0 ? last : 0);
  }
  return index;
}
} // namespace

Interval BoxPolynomial::Hull() const
{
  const pixelexact::Hull hull = HullOf(b);
  return error == 0.0 ? Interval(hull.lower, hull.upper)
                      : rounding::Outward(hull.lower - error, hull.upper + error);
}

bool BoxPolynomial::IsZero() const
{
  return error == 0.0 && std::ranges::all_of(b, [](double c) { return c == 0.0; });
}

Interval BoxPolynomial::AtCorner(unsigned corner) const
{
  const double value = b[CornerIndex(degree, corner)];
  return error == 0.0 ? Interval(value) : Interval::Around(value, error);
}

Interval BoxPolynomial::At(const std::array<double, 3>& t) const
{
  // Any point of the box will do: 1 + t need not be exact.
  const auto unit = [&t](std::size_t d) { return std::clamp(0.5 + t[d] / 2.0, 0.0, 1.0); };
  return EncloseValue(degree, b, error, { unit(0), unit(1), unit(2) });
}

AffineForm BoxPolynomial::Affine() const
{
  AffineForm form;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const double value = b[CornerIndex(degree, corner)] / 8.0;
    form.a += value;
    for (std::size_t d = 0; d < 3; ++d)
    {
      form.b[d] += (corner >> d & 1U) != 0 ? value : -value;
    }
  }
  std::array<std::array<double, kMaxDegree + 1>, 3> linear;
  for (std::size_t d = 0; d < 3; ++d)
  {
    form.b[d] = degree[d] > 0 ? form.b[d] : 0.0;
    for (int i = 0; i <= degree[d]; ++i)
    {
      linear[d][static_cast<std::size_t>(i)] =
        degree[d] > 0 ? form.b[d] * (static_cast<double>(2 * i - degree[d]) / degree[d]) : 0.0;
    }
  }
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  double largest = 0.0;
  const double* next = b.data();
  for (std::size_t i = 0; i <= static_cast<std::size_t>(degree[0]); ++i)
  {
    for (std::size_t j = 0; j <= static_cast<std::size_t>(degree[1]); ++j)
    {
      const double row = form.a + linear[0][i] + linear[1][j];
      for (std::size_t k = 0; k <= static_cast<std::size_t>(degree[2]); ++k, ++next)
      {
        const double left = *next - (row + linear[2][k]);
        lower = std::min(lower, left);
        upper = std::max(upper, left);
        largest = std::max(largest, std::fabs(*next));
      }
    }
  }
  // Two roundings of each linear term, four sums.
  const double size =
    std::fabs(form.a) + std::fabs(form.b[0]) + std::fabs(form.b[1]) + std::fabs(form.b[2]);
  const double radius = error + Gamma(10) * (size + largest) + 0x1p-1000;
  form.e = rounding::Outward(lower - radius, upper + radius);
  return form;
}

double BoxPolynomial::Variation(int direction, int difference) const
{
  const auto n = static_cast<std::size_t>(degree[static_cast<std::size_t>(direction)]);
  const std::size_t stride = StrideOf(degree, direction);
  if (static_cast<int>(n) < difference)
  {
    return 0.0;
  }
  const double most = LargestDifference(b, stride, stride * (n + 1), difference);
  const auto count = static_cast<double>(n);
  return most * (difference == 1 ? count : count * (count - 1.0));
}

BoxPolynomial BoxPolynomial::AtEnd(int direction, bool upper) const
{
  const auto d = static_cast<std::size_t>(direction);
  const std::size_t stride = StrideOf(degree, direction);
  const std::size_t block = stride * static_cast<std::size_t>(degree[d] + 1);
  BoxPolynomial slice{ degree, {}, error };
  slice.degree[d] = 0;
  for (std::size_t start = upper ? block - stride : 0; start < b.size(); start += block)
  {
    slice.b.insert(slice.b.end(), &b[start], &b[start] + stride);
  }
  return slice;
}

BoxPolynomial BoxPolynomial::Subdivide(int direction)
{
  BoxPolynomial upper{ degree, std::vector<double>(b.size()), error };
  const double largest = LargestMagnitude(b);
  pixelexact::Subdivide(degree, direction, b, upper.b);
  error = (error + Gamma(degree[static_cast<std::size_t>(direction)] + 2) * largest + 0x1p-1000) *
    (1.0 + Gamma(4));
  upper.error = error;
  return upper;
}

void BoxPolynomial::Restrict(int direction, double from, double to)
{
  const int n = degree[static_cast<std::size_t>(direction)];
  const double largest = LargestMagnitude(b);
  pixelexact::Restrict(degree, direction, 0.5 + from / 2.0, 0.5 + to / 2.0, b);
  // The two parameters are off by up to two roundoffs; each moves a coefficient by its change
  // times the degree times the largest difference.
  error = (error + RestrictionError(n, largest) + Gamma(8 * n + 4) * largest + 0x1p-1000) *
    (1.0 + Gamma(6));
}
} // namespace pixelexact
