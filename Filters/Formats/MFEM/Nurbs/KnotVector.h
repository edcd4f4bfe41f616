// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Text/TextScanner.h"
#include "Formats/Rational/LineMatrix.h"

#include <vector>

namespace pixelexact::mfem
{
/// A knot vector as in MFEM: ascending, with degree + 1 more knots than control points.
struct KnotVector
{
  int degree = 1;
  std::vector<double> knots;

  [[nodiscard]] int Points() const { return static_cast<int>(knots.size()) - degree - 1; }
  /// The first control points of the knot spans that are not empty, which are MFEM's elements.
  [[nodiscard]] std::vector<int> Spans() const;
  /// Whether functions are continuous: no inner knot occurs more than `degree` times.
  [[nodiscard]] bool IsContinuous() const;
  /// Whether the knot vector equals its reverse up to rounding.
  [[nodiscard]] bool IsSymmetric() const;
  /// The reversed knot vector, with MFEM's roundings.
  [[nodiscard]] KnotVector Flipped() const;
  /// The knot vector of degree `to` that MFEM makes, which has the same number of inner knots.
  [[nodiscard]] KnotVector Elevated(int to) const;
  /// The matrix from the degree + 1 control points of the span that begins with control point
  /// `first` to Bernstein's coefficients on part `part` of `parts` equal ones. Its rows are means
  /// with weights that are not negative.
  [[nodiscard]] rational::LineMatrix Extraction(int first, int part, int parts) const;
};

/// Reads degree, number of control points and knots. Throws InvalidData where the knots descend or
/// span nothing, Unsupported for degrees above kMaxOrder.
KnotVector ReadKnotVector(TextScanner& scanner);
} // namespace pixelexact::mfem
