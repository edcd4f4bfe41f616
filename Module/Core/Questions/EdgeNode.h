// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeFunctions.h"

#include <array>
#include <atomic>
#include <cmath>
#include <memory>

namespace pixelexact
{
/// An end of a box of eta, in xi: points inside are at a depth >= 0.
struct EdgeNodeEnd
{
  double normal[3]{}; ///< outwards
  double offset = 0.0;
  bool ofElement = false; ///< a face of the element

  [[nodiscard]] double DepthOf(const Vec3& xi) const
  {
    return offset - (normal[0] * xi.x + normal[1] * xi.y + normal[2] * xi.z);
  }
  /// Bounds the change of depth by a displacement of at most `off`.
  [[nodiscard]] double Across(const double (&off)[3]) const
  {
    return std::fabs(normal[0]) * off[0] + std::fabs(normal[1]) * off[1] +
      std::fabs(normal[2]) * off[2];
  }
};

/// The six ends of a box, in the order of EndNormals.
[[nodiscard]] std::array<EdgeNodeEnd, 6> EndsOf(Shape shape, const EtaBox& box);

/// Bounds for a box of eta, computed once. Derivatives are by xi and in the element's units, and
/// all bounds hold over `wide`, the box and a margin.
struct EdgeNode
{
  EtaBox box;
  EtaBox wide;     ///< the margin ends at the element's faces
  Box3 bounds;     ///< holds the image of `wide`, in world coordinates
  Interval values; ///< of the component over `wide`

  /// The map is so nearly affine over `wide` that M J = I + E with |E| at most `turn`, and |(I +
  /// E)^-1| at most `solution`.
  bool regular = false;
  /// The box is regular whatever the unit of xi. In thin elements that bend, this holds only for
  /// boxes that bend by less than the thickness; subdivision improves the bounds of other boxes.
  bool straight = false;
  bool flat = false;      ///< no child would be regular: the map has no thickness
  Vec3 centre{ 0.0 };     ///< in xi
  Vec3 origin{ 0.0 };     ///< its image, in the element's units
  double inverse[3][3]{}; ///< M
  double turn[3][3]{};
  double solution[3][3]{};
  double reach[3]{}; ///< |xi - centre| of the points of `wide`
  /// The map about the centre, d = xi - centre: M (Phi(xi) - origin) = linear d + 1/2 (bend + b) d
  /// d up to `error`, |b| at most `radius`, mixed ones twice.
  struct MapModel
  {
    double linear[3][3];
    double bend[3][6];
    double radius[3][6];
    double error[3];
  };
  std::unique_ptr<const MapModel> model; ///< where it is much closer than the affine map
  double bend[3][6]{}; ///< of solved M Phi'': 11, 12, 13, 22, 23, 33; mixed ones twice
  double slope[3]{};   ///< |dF / dxi|
  /// F is the sum of a function with the second derivatives below and of one whose derivatives by
  /// xi are at most this: 0 for polynomials.
  double beside[3]{};
  double curve[6]{}; ///< |F''| + slope . bend: of F along straight lines in the world
  /// The part of `curve` that smaller nodes lower: the remainders of affine bounds, or all of it.
  double rough[6]{};
  /// Ranges of the second derivatives of Phi and, last, of F: 11, 12, 13, 22, 23, 33. For a norm,
  /// ranges of the norm of F''.
  std::array<std::array<Interval, 6>, 4> second;
  /// If known, M Phi'' and F'' as affine bounds in xi - centre, mixed ones twice (LocalCurves).
  struct Slopes
  {
    std::array<EdgePolynomials::SecondBounds, 3> bend;
    EdgePolynomials::SecondBounds curve;
  };
  std::unique_ptr<const Slopes> slopes;
  double valueError = 0.0; ///< EdgeFunctions::ErrorsWith
  double slopeError = 0.0;
  double shift[3]{}; ///< by how much a located point's xi may be off
  std::array<EdgeNodeEnd, 6> boxEnds;
  std::array<EdgeNodeEnd, 6> wideEnds;
  double lean[3]{}; ///< by how much it moves, for a unit in y
  int subdivisions = 0;

  int direction = 0; ///< of eta, across which it is subdivided

  mutable std::atomic<const std::array<EdgeNode, 2>*> children{ nullptr };

  EdgeNode() = default;
  ~EdgeNode() { delete children.load(std::memory_order_relaxed); }
  EdgeNode(const EdgeNode&) = delete;
  EdgeNode& operator=(const EdgeNode&) = delete;

  /// Computes all bounds for `box`. `those`: encloses the component's values over `wide`.
  void Describe(const EdgeFunctions& functions, const Interval& those);

private:
  /// Returns whether the map is regular. Sets `straight`, and otherwise the direction of the
  /// subdivision.
  bool DescribeMap(const EdgeFunctions& functions, const EdgeFunctions::MapRanges& map);
  void DescribeCurves(
    const EdgeFunctions& functions, const EdgeFunctions::Derivatives& derivatives);
  void DescribeSlopes(const EdgePolynomials::Curves& curves);
  void DescribeModel(
    const EdgeFunctions& functions, const std::array<HessianFunction::XiRanges, 3>& ranges);
};
} // namespace pixelexact
