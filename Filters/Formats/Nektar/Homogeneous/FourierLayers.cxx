// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Homogeneous/FourierLayers.h"

#include "Core/Basis/Space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact::nektar
{
FourierLayers::FourierLayers(const Periodic& along)
  : Along(along)
{
  for (std::size_t f = 0; f < along.functions.size(); ++f)
  {
    Count = std::max(Count, Wave(f));
  }
  for (std::size_t f = 0; f < along.functions.size(); ++f)
  {
    for (unsigned n = 0; n <= kMaxOrder; ++n)
    {
      Bessel.push_back(std::sph_bessel(n, Phase(Wave(f))));
    }
  }
}

long double FourierLayers::Phase(int wave) const
{
  return std::numbers::pi_v<long double> * wave / Count;
}

double FourierLayers::Value(std::size_t function, double s) const
{
  const long double angle = 2 * std::numbers::pi_v<long double> * Wave(function) *
    (s / static_cast<long double>(Along.length));
  return static_cast<double>(
    Along.functions[function] % 2 == 0 ? std::cos(angle) : -std::sin(angle));
}

double FourierLayers::Coefficient(int layer, std::size_t function, int n) const
{
  // cos(a + t x) and -sin(a + t x): the real part of exp(i (a + t x)), and minus the imaginary one.
  const long double t = Phase(Wave(function));
  const long double a = t * (2 * layer + 1);
  const long double amplitude = (2 * n + 1) * Bessel[function * (kMaxOrder + 1) + n];
  const long double parts[4] = { std::cos(a), -std::sin(a), -std::cos(a), std::sin(a) };
  const int turn = Along.functions[function] % 2 == 0 ? n : n + 1;
  return static_cast<double>(amplitude * parts[turn % 4]);
}

double FourierLayers::Loss(std::size_t function, int order) const
{
  // The terms (2 n + 1) t^n / (2 n + 1)!! = t^n / (2 n - 1)!! fall by t / (2 n + 1) each.
  const long double t = Phase(Wave(function));
  if (t == 0)
  {
    return 0.0;
  }
  long double term = 1.0L;
  long double sum = 0.0L;
  for (int n = 1; n < 200; ++n)
  {
    term *= t / (2 * n - 1);
    sum += n > order ? term : 0.0L;
  }
  return static_cast<double>(sum) * (1 + 1e-12);
}
} // namespace pixelexact::nektar
