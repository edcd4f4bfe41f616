// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/Krawczyk.h"

#include "Core/Bernstein/JetBasis.h"
#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Rounding.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
struct LinearModel
{
  Parameters value{};
  SmallMatrix jacobian{};
};

LinearModel ModelAt(const LocalSystem& system, const Parameters& t)
{
  LinearModel model;
  const JetBasis basis(system.degree, t, JetBasis::Parts::Jets);
  for (int k = 0; k < system.variables; ++k)
  {
    const Jet jet = basis.JetOf(system.Polynomial(k));
    model.value[static_cast<std::size_t>(k)] = jet.value;
    model.jacobian[static_cast<std::size_t>(k)] = jet.gradient;
  }
  return model;
}

Parameters CentreOf(int size)
{
  Parameters centre{};
  std::fill_n(centre.begin(), size, 0.5);
  return centre;
}

/// Newton's iteration from the centre; where it leaves the cube, the centre.
Parameters NewtonPoint(const LocalSystem& system, double reach)
{
  constexpr int kSteps = 10;
  const auto n = static_cast<std::size_t>(system.variables);
  Parameters t = CentreOf(system.variables);
  for (int step = 0; step < kSteps; ++step)
  {
    const LinearModel model = ModelAt(system, t);
    const auto inverse = Inverse(system.variables, model.jacobian);
    if (!inverse)
    {
      return CentreOf(system.variables);
    }
    double longest = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      double delta = 0.0;
      for (std::size_t k = 0; k < n; ++k)
      {
        delta += (*inverse)[i][k] * model.value[k];
      }
      t[i] -= delta;
      longest = std::max(longest, std::fabs(delta));
      if (!(t[i] > -reach && t[i] < 1.0 + reach))
      {
        return CentreOf(system.variables);
      }
    }
    if (longest < 1e-15)
    {
      break;
    }
  }
  return t;
}

using IntervalMatrix = std::array<ParameterIntervals, 3>;

/// (C f)'(U), C a matrix of numbers: of the products' coefficients, for C times the hulls of f'
/// would say nothing of a system whose equations are nearly dependent.
IntervalMatrix Precondition(const LocalSystem& system, const SmallMatrix& inverse, double reach)
{
  const auto n = static_cast<std::size_t>(system.variables);
  IntervalMatrix result{};
  std::vector<double> product;
  for (std::size_t i = 0; i < n; ++i)
  {
    double error = 0.0;
    std::array<const double*, 3> rows{};
    product.resize(system.Polynomial(0).size());
    for (std::size_t k = 0; k < n; ++k)
    {
      const auto f = system.Polynomial(static_cast<int>(k));
      const double factor = inverse[i][k];
      rows[k] = f.data();
      // A product and up to three sums.
      error += std::fabs(factor) * (system.error[k] + Gamma(4) * LargestMagnitude(f));
    }
    Combine({ inverse[i].data(), n }, rows.data(), product);
    error = error * (1.0 + Gamma(16)) + 0x1p-1000;
    for (std::size_t j = 0; j < n; ++j)
    {
      result[i][j] = EncloseDerivative(system.degree, static_cast<int>(j), product, error, reach);
    }
  }
  return result;
}

/// fixed + deviation (box - m).
ParameterIntervals Image(std::size_t n, const ParameterIntervals& fixed,
  const IntervalMatrix& deviation, const ParameterIntervals& box, const Parameters& m)
{
  ParameterIntervals image = fixed;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < n; ++j)
    {
      image[i] += deviation[i][j] * (box[j] - Interval(m[j]));
    }
  }
  return image;
}

/// The one root of `cube` is in every box m +- v of it that its image does not leave, by Brouwer's
/// fixed point theorem: |fixed - m| + |deviation| v <= v. Such a v is near the solution of that as
/// an equation.
void Tighten(std::size_t n, const ParameterIntervals& fixed, const IntervalMatrix& deviation,
  const Parameters& m, const ParameterIntervals& cube, ParameterIntervals& image)
{
  SmallMatrix matrix{};
  Parameters off{};
  for (std::size_t i = 0; i < n; ++i)
  {
    off[i] = fixed[i].RadiusAround(m[i]) + 0x1p-1000;
    for (std::size_t j = 0; j < n; ++j)
    {
      matrix[i][j] = (i == j ? 1.0 : 0.0) - deviation[i][j].Magnitude();
    }
  }
  const auto inverse = Inverse(static_cast<int>(n), matrix);
  if (!inverse)
  {
    return;
  }
  ParameterIntervals box{};
  Parameters v{};
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < n; ++j)
    {
      v[i] += (*inverse)[i][j] * off[j] * (1.0 + 0x1p-20);
    }
    box[i] = Interval::Around(m[i], v[i]);
  }
  bool holds = true;
  for (std::size_t i = 0; i < n; ++i)
  {
    double reached = off[i];
    for (std::size_t j = 0; j < n; ++j)
    {
      reached += deviation[i][j].Magnitude() * v[j];
    }
    holds = holds && v[i] > 0.0 && reached * (1.0 + Gamma(8)) <= v[i] && cube[i].Contains(box[i]);
  }
  for (std::size_t i = 0; holds && i < n; ++i)
  {
    image[i] = Intersect(image[i], box[i]);
  }
}
} // namespace

std::optional<SmallMatrix> Inverse(int size, SmallMatrix matrix)
{
  const auto n = static_cast<std::size_t>(size);
  SmallMatrix inverse{};
  for (std::size_t i = 0; i < n; ++i)
  {
    inverse[i][i] = 1.0;
  }
  for (std::size_t column = 0; column < n; ++column)
  {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < n; ++row)
    {
      pivot = std::fabs(matrix[row][column]) > std::fabs(matrix[pivot][column]) ? row : pivot;
    }
    std::swap(matrix[pivot], matrix[column]);
    std::swap(inverse[pivot], inverse[column]);
    const double scale = 1.0 / matrix[column][column];
    for (std::size_t j = 0; j < n; ++j)
    {
      matrix[column][j] *= scale;
      inverse[column][j] *= scale;
    }
    for (std::size_t row = 0; row < n; ++row)
    {
      const double factor = row == column ? 0.0 : matrix[row][column];
      for (std::size_t j = 0; j < n; ++j)
      {
        matrix[row][j] -= factor * matrix[column][j];
        inverse[row][j] -= factor * inverse[column][j];
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < n; ++j)
    {
      if (!std::isfinite(inverse[i][j]))
      {
        return std::nullopt;
      }
    }
  }
  return inverse;
}

std::optional<KrawczykImage> ApplyKrawczyk(const LocalSystem& system, double reach)
{
  const auto n = static_cast<std::size_t>(system.variables);
  const Parameters m = NewtonPoint(system, reach);
  const auto inverse = Inverse(system.variables, ModelAt(system, m).jacobian);
  if (!inverse)
  {
    return std::nullopt;
  }
  IntervalMatrix deviation = Precondition(system, *inverse, reach);
  ParameterIntervals fixed{};
  ParameterIntervals cube{};
  ParameterIntervals value{};
  for (std::size_t k = 0; k < n; ++k)
  {
    value[k] =
      EncloseValue(system.degree, system.Polynomial(static_cast<int>(k)), system.error[k], m);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    fixed[i] = m[i];
    cube[i] = { -reach, 1.0 + reach };
    for (std::size_t j = 0; j < n; ++j)
    {
      deviation[i][j] = Interval(i == j ? 1.0 : 0.0) - deviation[i][j];
    }
    for (std::size_t k = 0; k < n; ++k)
    {
      fixed[i] -= Interval((*inverse)[i][k]) * value[k];
    }
  }
  KrawczykImage result;
  result.image = Image(n, fixed, deviation, cube, m);
  result.unique = true;
  for (std::size_t i = 0; i < n; ++i)
  {
    result.unique = result.unique && cube[i].ContainsInside(result.image[i]);
  }
  if (result.unique)
  {
    Tighten(n, fixed, deviation, m, cube, result.image);
  }
  return result;
}
} // namespace pixelexact
