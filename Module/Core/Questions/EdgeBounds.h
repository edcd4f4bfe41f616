// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeMeeting.h"
#include "Core/Questions/EdgeTree.h"
#include "Core/Questions/Sheet.h"
#include "Core/Questions/ValueSet.h"

#include <array>
#include <limits>
#include <optional>
#include <span>

namespace pixelexact
{
/// A point that has been located in an element, and the component's value at its xi, as the kernels
/// compute it.
struct LocatedPoint
{
  Vec3 x{ 0.0 };
  Vec3 xi{ 0.0 };
  Vec3 eta{ 0.0 }; ///< ReferenceToTensor of xi
  double value = 0.0;
};

/// The largest numbers of subdivisions of regular nodes, where smaller ones would give narrower
/// bounds.
struct EdgeEffort
{
  static constexpr int kAny = std::numeric_limits<int>::max();
  int whereMapBends = 0;
  int whereFieldCurves = 0;
  EdgeWork* work = nullptr; ///< for all subdivisions; null: without a limit
};

/// Bounds of a component along an edge that lies in one element.
struct EdgeRange
{
  double deviation = 0.0; ///< from the straight line between the ends' values
  double loose = 0.0;     ///< the part of it that smaller nodes may lower, of expressions
  double error = 0.0;     ///< of these values: F at the true points is no farther off
};

/// A component on a part of a plane that lies in one element.
struct PlanarValues
{
  Interval values;    ///< hold all of them
  double loose = 0.0; ///< the part of the bounds that falls with the node
  /// The error of the affine function At of the points of the part. Infinite where it was not
  /// requested.
  double error = std::numeric_limits<double>::infinity();
  Vec3 origin{ 0.0 };
  double first = 0.0; ///< at the origin
  Vec3 slope{ 0.0 };

  [[nodiscard]] double At(const Vec3& x) const
  {
    const Vec3 way = x - origin;
    return first + (slope.x * way.x + slope.y * way.y + slope.z * way.z);
  }
};

/// Bounds of a component of a field along short edges in one element, from kept bounds of its map
/// and its second derivatives. Safe to use from several threads. Bounds are computed on first use,
/// and depend on neither view nor value.
///
/// `work`: the work budget of the subdivisions for several queries; null: without a limit. Results
/// that would exceed it are not proven.
///
/// All results hold for the stored map and field. See Documentation/contours-proof.md for the
/// proofs.
class EdgeBounds
{
public:
  /// `component`: one of the field's, or -1: the Euclidean norm of all, if there are several. The
  /// arrays must outlive the object. `rounding`: the rounding of values beyond that of the kernels
  /// in double precision, relative to their largest possible magnitude.
  EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element, const Field& field,
    int component, double rounding = 0.0);
  /// Bounds the map and faces alone; the component is 0.
  EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element);
  EdgeBounds(const EdgeBounds&) = delete;
  EdgeBounds& operator=(const EdgeBounds&) = delete;

  /// Encloses all values in the element; -inf to inf where they are not known, as for mapped fields
  /// in pyramids (EdgeFunctions::IsKnown).
  [[nodiscard]] const Interval& Values() const { return Functions.Values(); }
  /// False where a coefficient is not finite.
  [[nodiscard]] bool HasValues() const { return Functions.HasValues(); }
  /// An estimate for EdgeWork of the cost of finding xi and value next to a point.
  [[nodiscard]] std::int64_t SampleCost(const LocatedPoint& point, EdgeWork* work) const;

  /// Bounds the field along the straight edge between two points. The edge lies in the element, up
  /// to rounding, and at a + s (b - a) the value is within `deviation` of the linear interpolation.
  /// None where that is not proven. `sagitta`: the largest distance between the straight edge and
  /// the true one, in world units. For expressions, visits smaller nodes as long as the values may
  /// meet `wanted`; null: does not.
  [[nodiscard]] std::optional<EdgeRange> Along(const LocatedPoint& a, const LocatedPoint& b,
    double sagitta = 0.0, EdgeWork* work = nullptr, const ValueSet* wanted = nullptr) const;

  /// Bounds the values on a part of the plane through three points of the element, which should be
  /// close to it. None where the part is not proven to lie in the element. Refines only while the
  /// values meet `wanted`; the affine function is computed if they still do at the end.
  [[nodiscard]] std::optional<PlanarValues> Over(const std::array<LocatedPoint, 3>& triangle,
    const WideOutline& part, const ValueSet& wanted, EdgeWork* work = nullptr) const;

  /// Encloses the values at the points of the element in a region; none where there are no such
  /// points. Refines only while the values meet `wanted`; values outside `wanted` may then be
  /// missing from the result.
  [[nodiscard]] std::optional<Interval> ValuesIn(
    const WideOutline& region, const ValueSet& wanted, const EdgeEffort& effort) const;
  /// Whether the component may take wanted values there. False is a proof that it takes none.
  [[nodiscard]] bool MayTake(
    const ValueSet& wanted, const WideOutline& region, const EdgeEffort& effort) const;
  /// Bounds the difference between a point's value and the values within a distance of it, in the
  /// element and next to the point in xi. Infinite where no bound is known.
  [[nodiscard]] double ChangeWithin(
    const LocatedPoint& point, double distance, EdgeWork* work = nullptr) const;

  /// Bounds the distance of the sheet from the straight line between two of its points, along all
  /// rays between those that meet it there. All of these rays meet the sheet in the element, up to
  /// rounding. Infinite where that is not proven.
  [[nodiscard]] double Sagitta(const Sheet& sheet, const SheetPoint& a, const SheetPoint& b) const;
  /// Whether some point of the sheet may be in a region. False is a proof that none is.
  [[nodiscard]] bool MayMeet(
    const Sheet& sheet, const WideOutline& region, const EdgeEffort& effort) const;
  /// The point where the sheet leaves the element on the way to another ray. The sheet between the
  /// two is not proven; Sagitta proves it. None where no such point is found.
  [[nodiscard]] std::optional<SheetExit> ExitOf(
    const Sheet& sheet, const SheetPoint& from, const SheetPoint& towards) const;

private:
  /// None where the edge is not proven to lie in the node's margin.
  [[nodiscard]] std::optional<EdgeRange> AlongIn(
    const EdgeNode& node, const LocatedPoint& a, const LocatedPoint& b, double sagitta) const;
  /// Bounds the deviation from a straight line by second derivatives, without the errors of points.
  /// `s`: the edge in xi, `shift`: ShiftOf the ends.
  [[nodiscard]] double CurvedAlong(const EdgeNode& node, const LocatedPoint& a,
    const double (&s)[3], const std::array<double, 3>& shift) const;
  /// The same as AlongIn in smaller nodes than `node`, which gives the range `found`.
  [[nodiscard]] EdgeRange AlongSmaller(const EdgeNode& node, const EdgeRange& found,
    const LocatedPoint& a, const LocatedPoint& b, double sagitta, EdgeWork* work,
    const ValueSet& wanted) const;
  /// The same as Over, in one node.
  [[nodiscard]] std::optional<PlanarValues> OverIn(const EdgeNode& node,
    const std::array<LocatedPoint, 3>& triangle, const WideOutline& part,
    const ValueSet& wanted) const;
  /// Bounds the error of the points' xi: |xi - xi'| with Phi(xi') = x, by direction.
  [[nodiscard]] std::array<double, 3> ShiftOf(
    const EdgeNode& node, std::span<const LocatedPoint> points) const;
  [[nodiscard]] EdgeMeeting MeetNode(const EdgeNode& node, const WideOutline& region,
    const ValueSet& wanted, EdgeWork* work, KeptExpansion& kept) const;
  [[nodiscard]] std::optional<Interval> ValuesIn(const EdgeNode& node, const WideOutline& region,
    const ValueSet& wanted, const EdgeEffort& effort, KeptExpansion& kept) const;

  EdgeFunctions Functions;
  EdgeTree Tree;
  EdgeFrame Frame;
  std::array<EdgeNodeEnd, 6> Ends; ///< of the element
};
} // namespace pixelexact
