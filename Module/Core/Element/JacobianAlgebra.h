// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

// Products with the Jacobian J_ij = d x_i / d xi_j, nine scalars of any type, i slowest.
namespace pixelexact
{
/// The cofactor of J_ij in J, nine numbers row-major.
template <class T>
T Cofactor(std::span<const T> J, std::size_t i, std::size_t j)
{
  const std::size_t i1 = (i + 1) % 3;
  const std::size_t i2 = (i + 2) % 3;
  const std::size_t j1 = (j + 1) % 3;
  const std::size_t j2 = (j + 2) % 3;
  return J[3 * i1 + j1] * J[3 * i2 + j2] - J[3 * i1 + j2] * J[3 * i2 + j1];
}

template <class T>
T Determinant(std::span<const T> J)
{
  return J[0] * Cofactor(J, 0, 0) + J[1] * Cofactor(J, 0, 1) + J[2] * Cofactor(J, 0, 2);
}

/// Component k of J^-T v det J.
template <class T>
T Covariant(std::span<const T> J, std::span<const T> v, std::size_t k)
{
  return Cofactor(J, k, 0) * v[0] + Cofactor(J, k, 1) * v[1] + Cofactor(J, k, 2) * v[2];
}

/// Component k of J v.
template <class T>
T Contravariant(std::span<const T> J, std::span<const T> v, std::size_t k)
{
  return J[3 * k] * v[0] + J[3 * k + 1] * v[1] + J[3 * k + 2] * v[2];
}
} // namespace pixelexact
