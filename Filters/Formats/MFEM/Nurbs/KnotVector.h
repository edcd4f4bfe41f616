// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Text/TextScanner.h"
#include "Formats/Rational/LineMatrix.h"

#include <vector>

namespace pixelexact::mfem
{
/// A knot vector as MFEM has it: ascending, with degree + 1 knots more than control points.
struct KnotVector
{
  int degree = 1;
  std::vector<double> knots;

  [[nodiscard]] int Points() const { return static_cast<int>(knots.size()) - degree - 1; }
  /// The first control points of the spans that are not empty: MFEM's elements.
  [[nodiscard]] std::vector<int> Spans() const;
  /// Whether functions are continuous: no inner knot is there more than `degree` times.
  [[nodiscard]] bool IsContinuous() const;
  /// Whether it is the same from the other end, up to rounding.
  [[nodiscard]] bool IsSymmetric() const;
  /// Run through from the other end, with MFEM's roundings.
  [[nodiscard]] KnotVector Flipped() const;
  /// Of a higher degree, as MFEM makes it: the inner knots are as many as before.
  [[nodiscard]] KnotVector Elevated(int to) const;
  /// From the degree + 1 control points of the span that begins with control point `first` to
  /// Bernstein's coefficients on part `part` of `parts` equal ones: means with weights that are not
  /// negative.
  [[nodiscard]] rational::LineMatrix Extraction(int first, int part, int parts) const;
};

/// Reads degree, number of control points and knots. Throws InvalidData where the knots descend or
/// span nothing, Unsupported for degrees above kMaxOrder.
KnotVector ReadKnotVector(TextScanner& scanner);
} // namespace pixelexact::mfem
