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
  /// By how much points that are off by no more than this may be deeper.
  [[nodiscard]] double Across(const double (&off)[3]) const
  {
    return std::fabs(normal[0]) * off[0] + std::fabs(normal[1]) * off[1] +
      std::fabs(normal[2]) * off[2];
  }
};

/// The six ends of a box, in the order of EndNormals.
[[nodiscard]] std::array<EdgeNodeEnd, 6> EndsOf(Shape shape, const EtaBox& box);

/// What is known of a box of eta, made once: derivatives are by xi and in the element's units, and
/// all bounds hold over `wide`, the box and a margin.
struct EdgeNode
{
  EtaBox box;
  EtaBox wide;     ///< the margin ends at the element's faces
  Box3 bounds;     ///< holds the image of `wide`, in world coordinates
  Interval values; ///< of the component over `wide`

  /// The map is so nearly affine over `wide` that what follows holds: M J = I + E with |E| at most
  /// `turn`, and |(I + E)^-1| at most `solution`.
  bool regular = false;
  /// So it is whatever xi is counted in: thin elements that bend are only where they bend by less
  /// than they are thin. Before that halves tell more of the map.
  bool straight = false;
  bool flat = false;      ///< halves would not be regular, either: the map has no thickness
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
  std::unique_ptr<const MapModel> model; ///< where it tells much more than the affine map
  double bend[3][6]{}; ///< of solved M Phi'': 11, 12, 13, 22, 23, 33; mixed ones twice
  double slope[3]{};   ///< |dF / dxi|
  /// F is the sum of a function with the second derivatives below and of one whose derivatives by
  /// xi are no larger than this: 0 of polynomials.
  double beside[3]{};
  double curve[6]{}; ///< |F''| + slope . bend: of F along straight lines in the world
  /// Ranges of the second derivatives of Phi and, last, of F: 11, 12, 13, 22, 23, 33. Of a norm, of
  /// the norm of F''.
  std::array<std::array<Interval, 6>, 4> second;
  /// Where known: M Phi'' and F'' in terms of xi - centre, mixed ones twice (LocalCurves).
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

  int direction = 0; ///< of eta, across which it is halved

  mutable std::atomic<const std::array<EdgeNode, 2>*> children{ nullptr };

  EdgeNode() = default;
  ~EdgeNode() { delete children.load(std::memory_order_relaxed); }
  EdgeNode(const EdgeNode&) = delete;
  EdgeNode& operator=(const EdgeNode&) = delete;

  /// Finds out all that is known of `box`. `those`: hold the component's values over `wide`.
  void Describe(const EdgeFunctions& functions, const Interval& those);

private:
  /// Whether the map is regular; tells whether it is straight, and else how to halve.
  bool DescribeMap(const EdgeFunctions& functions, const EdgeFunctions::MapRanges& map);
  void DescribeCurves(
    const EdgeFunctions& functions, const EdgeFunctions::Derivatives& derivatives);
  void DescribeSlopes(const EdgePolynomials::Curves& curves);
  void DescribeModel(
    const EdgeFunctions& functions, const std::array<HessianFunction::XiRanges, 3>& ranges);
};
} // namespace pixelexact
