// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Mat.h"

#include <array>

namespace pixelexact
{
/// Eigenvalues, the largest first, and orthonormal eigenvectors of a symmetric 3 x 3 matrix, by
/// Jacobi's rotations (C. Jacobi, 1846; G. Golub and C. Van Loan, Matrix Computations, section
/// 8.5): errors are some roundings of the largest entry. NaN where an entry is not finite.
class SymmetricEigen
{
public:
  /// Entries xx, yy, zz, xy, yz, xz.
  explicit SymmetricEigen(const std::array<double, 6>& matrix);

  [[nodiscard]] double Value(int number) const { return Values[number]; }
  [[nodiscard]] Vec3 Vector(int number) const { return Vectors[number]; }

private:
  Vec3 Values{ 0.0 };
  Mat3 Vectors{ 1.0 }; ///< columns
};
} // namespace pixelexact
