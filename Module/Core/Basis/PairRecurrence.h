// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Recurrence.h"
#include "Core/Math/DoublePair.h"

namespace pixelexact
{
/// The recurrences' constants, which are quotients of whole numbers below 2^53, to 2^-105.
template <>
class Recurrence<DoublePair>
{
public:
  static RecurrenceStep<DoublePair> Legendre(int n)
  {
    return { Quotient(2 * n + 1, n + 1), {}, Quotient(n, n + 1) };
  }
  static RecurrenceStep<DoublePair> Jacobi(int alpha, int n)
  {
    const double m = 2 * n + alpha;
    const double denominator = 2.0 * (n + 1) * (n + alpha + 1) * m;
    return { Quotient((m + 1) * (m + 2) * m, denominator),
      Quotient((m + 1) * alpha * alpha, denominator),
      Quotient(2.0 * n * (n + alpha) * (m + 2), denominator) };
  }
};
} // namespace pixelexact
