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
/// A point of an element that has been located there, and the component's value at its xi as the
/// kernels make it.
struct LocatedPoint
{
  Vec3 x{ 0.0 };
  Vec3 xi{ 0.0 };
  Vec3 eta{ 0.0 }; ///< ReferenceToTensor of xi
  double value = 0.0;
};

/// How often regular nodes are halved, at most, where smaller ones would tell more.
struct EdgeEffort
{
  static constexpr int kAny = std::numeric_limits<int>::max();
  int whereMapBends = 0;
  int whereFieldCurves = 0;
  EdgeWork* work = nullptr; ///< for all halvings; null: without a limit
};

/// What is known of a component along an edge that lies in one element.
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
  /// By an affine function of the points x of the part: At(x) is off by at most this. Infinite
  /// where it has not been asked for.
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

/// Bounds of a component of a field along short edges in one element, from what is kept of its map
/// and its second derivatives. Safe to use from several threads; what is known is made where
/// somebody first asks, and depends on neither view nor value.
///
/// `work`: what halving nodes may cost, of several questions; null: without a limit. What is not
/// found out for want of it is not proven.
///
/// Everything holds for the stored map and field. See Documentation/contours-proof.md for the
/// proofs.
class EdgeBounds
{
public:
  /// `component`: one of the field's, or -1: the Euclidean norm of
  /// all, if there are several. The arrays must outlive the object. `rounding`: of values, as a
  /// part of their largest possible magnitude, beyond that of the kernels in double precision.
  EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element, const Field& field,
    int component, double rounding = 0.0);
  /// Of the map alone, and of faces: the component is 0.
  EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element);
  EdgeBounds(const EdgeBounds&) = delete;
  EdgeBounds& operator=(const EdgeBounds&) = delete;

  /// Holds all values in the element; everything where nothing is known of them, as of mapped
  /// fields in pyramids (EdgeFunctions::IsKnown).
  [[nodiscard]] const Interval& Values() const { return Functions.Values(); }
  /// False where a coefficient is not finite.
  [[nodiscard]] bool HasValues() const { return Functions.HasValues(); }
  /// About what finding xi and value costs next to a point, for EdgeWork.
  [[nodiscard]] std::int64_t SampleCost(const LocatedPoint& point, EdgeWork* work) const;

  /// The field along the straight edge between two points: it lies in the element, as far as
  /// rounding goes, and at a + s (b - a) the value is within `deviation` of the one between the
  /// two. Nothing where that is not proven. `sagitta`: how far off the straight edge the true one
  /// is, in world units. More is found out of expressions as long as the values may meet `wanted`;
  /// null: nothing more.
  [[nodiscard]] std::optional<EdgeRange> Along(const LocatedPoint& a, const LocatedPoint& b,
    double sagitta = 0.0, EdgeWork* work = nullptr, const ValueSet* wanted = nullptr) const;

  /// The values on a part of the plane through three points of the element, best next to them.
  /// Nothing where it is not proven that the part lies in the element. More is found out only as
  /// long as they meet those that are wanted, and the affine function where they do to the end.
  [[nodiscard]] std::optional<PlanarValues> Over(const std::array<LocatedPoint, 3>& triangle,
    const WideOutline& part, const ValueSet& wanted, EdgeWork* work = nullptr) const;

  /// Holds the values at the points of the element in a region; nothing: there are none. More is
  /// found out only as long as they meet those that are wanted: what is told then may lack others.
  [[nodiscard]] std::optional<Interval> ValuesIn(
    const WideOutline& region, const ValueSet& wanted, const EdgeEffort& effort) const;
  /// Whether these meet the wanted ones; false: proven that the component takes none there.
  [[nodiscard]] bool MayTake(
    const ValueSet& wanted, const WideOutline& region, const EdgeEffort& effort) const;
  /// A bound of how far the values within a distance of a point, in the element and next to the
  /// point in xi as well, are from its own; infinite where none is known.
  [[nodiscard]] double ChangeWithin(
    const LocatedPoint& point, double distance, EdgeWork* work = nullptr) const;

  /// How far the sheet is off the straight line between two of its points at most, along all rays
  /// between those that meet it there: all of them meet it in the element, as far as rounding goes.
  /// Infinite where that is not proven.
  [[nodiscard]] double Sagitta(const Sheet& sheet, const SheetPoint& a, const SheetPoint& b) const;
  /// Whether some point of the sheet may be in a region; false: proven that none is.
  [[nodiscard]] bool MayMeet(
    const Sheet& sheet, const WideOutline& region, const EdgeEffort& effort) const;
  /// Where the sheet leaves the element on the way to another ray. Nothing is proven of what is
  /// between: Sagitta tells. Nothing where it is not found.
  [[nodiscard]] std::optional<SheetExit> ExitOf(
    const Sheet& sheet, const SheetPoint& from, const SheetPoint& towards) const;

private:
  /// Nothing where the edge is not proven to lie in the node's margin.
  [[nodiscard]] std::optional<EdgeRange> AlongIn(
    const EdgeNode& node, const LocatedPoint& a, const LocatedPoint& b, double sagitta) const;
  /// The same in smaller nodes than `node`, in which the range is `found`.
  [[nodiscard]] EdgeRange AlongSmaller(const EdgeNode& node, const EdgeRange& found,
    const LocatedPoint& a, const LocatedPoint& b, double sagitta, EdgeWork* work,
    const ValueSet& wanted) const;
  /// As Over, in one node.
  [[nodiscard]] std::optional<PlanarValues> OverIn(const EdgeNode& node,
    const std::array<LocatedPoint, 3>& triangle, const WideOutline& part,
    const ValueSet& wanted) const;
  /// By how much the points' xi may be off: |xi - xi'| of Phi(xi') = x, by direction.
  [[nodiscard]] std::array<double, 3> ShiftOf(
    const EdgeNode& node, std::span<const LocatedPoint> points) const;
  [[nodiscard]] EdgeMeeting MeetNode(
    const EdgeNode& node, const WideOutline& region, const ValueSet& wanted, EdgeWork* work) const;
  [[nodiscard]] std::optional<Interval> ValuesIn(const EdgeNode& node, const WideOutline& region,
    const ValueSet& wanted, const EdgeEffort& effort) const;

  EdgeFunctions Functions;
  EdgeTree Tree;
  EdgeFrame Frame;
  std::array<EdgeNodeEnd, 6> Ends; ///< of the element
};
} // namespace pixelexact
