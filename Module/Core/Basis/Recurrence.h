// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

#include <array>

// Three-term recurrences of the one-dimensional families behind the canonical basis, as constants
// in the scalar they are used with: double for the kernels, long double for changes of basis.
namespace pixelexact
{
/// P_{n+1} = (a z + b) P_n - c P_{n-1}.
template <class Scalar>
struct RecurrenceStep
{
  Scalar a{};
  Scalar b{};
  Scalar c{};
};

template <class Scalar>
class Recurrence
{
public:
  /// Legendre, alpha = 0; n = 0 .. kMaxOrder - 1.
  static constexpr RecurrenceStep<Scalar> Legendre(int n)
  {
    return { Scalar(2 * n + 1) / Scalar(n + 1), Scalar(0), Scalar(n) / Scalar(n + 1) };
  }

  /// Jacobi P^{(alpha,0)}, alpha >= 1 (Abramowitz and Stegun, 22.7.1, with beta = 0).
  static constexpr RecurrenceStep<Scalar> Jacobi(int alpha, int n)
  {
    const auto m = Scalar(2 * n + alpha);
    const Scalar denominator = Scalar(2 * (n + 1)) * Scalar(n + alpha + 1) * m;
    return { (m + 1) * (m + 2) * m / denominator,
      (m + 1) * Scalar(alpha) * Scalar(alpha) / denominator,
      Scalar(2 * n) * Scalar(n + alpha) * (m + 2) / denominator };
  }
};

/// Steps n = 0 .. kMaxOrder - 1 for alpha 0 (Legendre) to 2 kMaxOrder + 2.
template <class Scalar>
using Recurrences = std::array<std::array<RecurrenceStep<Scalar>, kMaxOrder>, 2 * kMaxOrder + 3>;

template <class Scalar>
constexpr Recurrences<Scalar> MakeRecurrences()
{
  Recurrences<Scalar> steps{};
  for (int alpha = 0; alpha <= 2 * kMaxOrder + 2; ++alpha)
  {
    for (int n = 0; n < kMaxOrder; ++n)
    {
      steps[alpha][n] =
        alpha == 0 ? Recurrence<Scalar>::Legendre(n) : Recurrence<Scalar>::Jacobi(alpha, n);
    }
  }
  return steps;
}

/// Constants computed once.
template <class Scalar>
struct RecurrenceTable
{
  static const RecurrenceStep<Scalar>* Row(int alpha)
  {
    static const auto steps = MakeRecurrences<Scalar>();
    return steps[static_cast<std::size_t>(alpha)].data();
  }
};

/// The kernels' recurrences, known to the compiler.
inline constexpr auto kRecurrences = MakeRecurrences<double>();
template <>
struct RecurrenceTable<double>
{
  static constexpr const RecurrenceStep<double>* Row(int alpha)
  {
    return kRecurrences[static_cast<std::size_t>(alpha)].data();
  }
};
} // namespace pixelexact
