// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/PolynomialSystem.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <string>

namespace pixelexact
{
namespace
{
void Check(int variables, const TensorPolynomial& polynomial, std::size_t index)
{
  const std::string name = "polynomial " + std::to_string(index);
  for (int d = 0; d < 3; ++d)
  {
    const int degree = polynomial.degree[static_cast<std::size_t>(d)];
    if (degree < 0 || degree > kMaxDegree || (d >= variables && degree > 0))
    {
      throw InvalidData(name + " has degree " + std::to_string(degree) + " in parameter " +
        std::to_string(d) + "; it must be from 0 to " +
        std::to_string(d < variables ? kMaxDegree : 0) + ".");
    }
  }
  if (polynomial.coefficients.size() != CoefficientCount(polynomial.degree))
  {
    throw InvalidData(name + " has " + std::to_string(polynomial.coefficients.size()) +
      " coefficients; its degrees need " + std::to_string(CoefficientCount(polynomial.degree)) +
      ".");
  }
  if (!(polynomial.error >= 0.0))
  {
    throw InvalidData(name + " has a negative error.");
  }
}
} // namespace

PolynomialSystem::PolynomialSystem(int variables, std::span<const TensorPolynomial> polynomials)
  : variables_(variables)
{
  if (variables < 1 || variables > 3 || polynomials.empty() || polynomials.size() > 3)
  {
    throw InvalidData("a system has 1 to 3 variables and 1 to 3 polynomials, not " +
      std::to_string(variables) + " and " + std::to_string(polynomials.size()) + ".");
  }
  for (std::size_t k = 0; k < polynomials.size(); ++k)
  {
    Check(variables, polynomials[k], k);
    for (std::size_t d = 0; d < 3; ++d)
    {
      degree_[d] = std::max(degree_[d], polynomials[k].degree[d]);
    }
  }
  const std::size_t size = CoefficientCount(degree_);
  coefficients_.resize(polynomials.size() * size);
  for (std::size_t k = 0; k < polynomials.size(); ++k)
  {
    const TensorPolynomial& polynomial = polynomials[k];
    const auto to = std::span(coefficients_).subspan(k * size, size);
    if (polynomial.degree == degree_)
    {
      std::ranges::copy(polynomial.coefficients, to.begin());
      Error.push_back(polynomial.error);
      continue;
    }
    Elevate(polynomial.degree, degree_, polynomial.coefficients, to);
    Error.push_back(rounding::Above(
      polynomial.error + ElevationError(degree_, LargestMagnitude(polynomial.coefficients))));
  }
}
} // namespace pixelexact
