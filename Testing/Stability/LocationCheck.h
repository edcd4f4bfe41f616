// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Stability/Reference.h"

#include "Core/Base/Verdict.h"

namespace pixelexact::testing
{
/// Results of the locator and of the field's evaluation at a point.
struct FoundPoint
{
  Verdict verdict;
  int element;
  Vec3 xi;
  double residual;
  double value;
};

/// The errors of a point and their bounds; see LocationStudy.h.
struct PointErrors
{
  double condition = 0.0;
  double xiError = 0.0;
  double xiBound = 0.0;
  bool firstOrder = true; ///< whether xiBound holds
  double backwardOverBound = 0.0;
  double valueError = 0.0;
  double value = 0.0;
  double magnitude = 0.0; ///< sum |c| |mode| of the field
  double valueBound = 0.0;
};

/// Compares with the reference, for points of one element.
class LocationCheck
{
public:
  /// `box`: the locator's box of the element.
  LocationCheck(const Mesh& mesh, int element, const Box3& box, const Field& field);

  /// `near`: a xi close to the point's preimage.
  [[nodiscard]] PointErrors Measure(const Vec3& near, const Vec3& x, const FoundPoint& found) const;

  /// Whether the point is farther out than twice the tolerance at faces.
  [[nodiscard]] bool IsKnownOutside(const Vec3& near, const Vec3& x) const;

private:
  using Triple = std::array<double, 3>;
  [[nodiscard]] const double* Component(std::size_t c) const;
  [[nodiscard]] Triple Rounding(const Vec3& xi, const QuadVec3& y) const;
  [[nodiscard]] double Curvature(const QuadPreimage& at) const;
  [[nodiscard]] double Backward(
    const QuadVec3& xi, const QuadVec3& y, const Triple& rounding, const Triple& stored) const;
  void MeasureValue(const FoundPoint& found, const QuadVec3& xi, PointErrors& errors) const;
  [[nodiscard]] Triple Uncertainty() const;

  const Mesh& Elements;
  const Field& field_;
  const Space& MapSpace;
  int Element;
  Box3 Box;
};
} // namespace pixelexact::testing
