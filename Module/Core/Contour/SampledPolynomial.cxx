// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/SampledPolynomial.h"

#include "Core/Bernstein/TensorPolynomial.h"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace pixelexact
{
namespace
{
std::vector<double> ChebyshevPoints(int degree)
{
  std::vector<double> t;
  for (int i = 0; i <= degree; ++i)
  {
    t.push_back(0.5 - 0.5 * std::cos((2 * i + 1) * std::numbers::pi / (2 * degree + 2)));
  }
  return t;
}

/// Takes values at the points to Bernstein coefficients.
Eigen::MatrixXd FromValues(const std::vector<double>& t)
{
  const auto n = static_cast<int>(t.size()) - 1;
  Eigen::MatrixXd basis(n + 1, n + 1);
  for (int row = 0; row <= n; ++row)
  {
    const double at = t[static_cast<std::size_t>(row)];
    double binomial = 1.0;
    for (int i = 0; i <= n; ++i)
    {
      basis(row, i) = binomial * std::pow(at, i) * std::pow(1.0 - at, n - i);
      binomial = binomial * (n - i) / (i + 1);
    }
  }
  return basis.inverse();
}
} // namespace

BoxPolynomial SamplePolynomial(int degree, const Box3& box, const SampledFunction& function)
{
  const std::vector<double> t = ChebyshevPoints(degree);
  std::vector<Vec3> points;
  for (const double a : t)
  {
    for (const double b : t)
    {
      for (const double c : t)
      {
        points.push_back(box.lower + Vec3(a, b, c) * (box.upper - box.lower));
      }
    }
  }
  BoxPolynomial result{ { degree, degree, degree }, std::vector<double>(points.size()), 0.0 };
  function(points, result.b);
  const Eigen::MatrixXd change = FromValues(t);
  Eigen::VectorXd line(degree + 1);
  for (int d = 0; d < 3; ++d)
  {
    const std::size_t stride = StrideOf(result.degree, d);
    const std::size_t count = t.size();
    for (std::size_t start = 0; start < result.b.size(); ++start)
    {
      if (start / stride % count != 0)
      {
        continue;
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        line[static_cast<Eigen::Index>(i)] = result.b[start + i * stride];
      }
      const Eigen::VectorXd changed = change * line;
      for (std::size_t i = 0; i < count; ++i)
      {
        result.b[start + i * stride] = changed[static_cast<Eigen::Index>(i)];
      }
    }
  }
  return result;
}
} // namespace pixelexact
