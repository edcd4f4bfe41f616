// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/HessianFunction.h"
#include "Core/Index/ElementIndex.h"
#include "Core/Questions/EdgeNode.h"

#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
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

/// Values that are looked for: some numbers, in ascending order, and all that are not between two.
struct ValueSet
{
  std::span<const double> values;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  /// Whether one of them is in an interval.
  [[nodiscard]] bool Meets(double from, double to) const;
};

/// What is known of a component along an edge that lies in one element.
struct EdgeRange
{
  double deviation = 0.0; ///< from the straight line between the ends' values
  double error = 0.0;     ///< of these values: F at the true points is no farther off
};

/// Bounds of a component of a field along short edges in one element, from what is kept of its map
/// and its second derivatives. Safe to use from several threads; what is known is made where
/// somebody first asks, and depends on neither view nor value.
///
/// Everything holds for the stored map and field. See Documentation/contours.md for the proofs.
class EdgeBounds
{
public:
  /// `field` must have Mapping::Identity, and component be one of its, or -1: the Euclidean norm of
  /// all, if there are several. The arrays must outlive the object. `rounding`: of values, as a
  /// part of their largest possible magnitude, beyond that of the kernels in double precision.
  EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element, const Field& field,
    int component, double rounding = 0.0);
  ~EdgeBounds();
  EdgeBounds(const EdgeBounds&) = delete;
  EdgeBounds& operator=(const EdgeBounds&) = delete;

  /// Holds all values in the element; everything where a coefficient is not finite.
  [[nodiscard]] const Interval& Values() const { return Range; }

  /// The field along the straight edge between two points: it lies in the element, as far as
  /// rounding goes, and at a + s (b - a) the value is within `deviation` of the one between the
  /// two. Nothing where that is not proven. `sagitta`: how far off the straight edge the true one
  /// is, in world units.
  [[nodiscard]] std::optional<EdgeRange> Along(
    const LocatedPoint& a, const LocatedPoint& b, double sagitta = 0.0) const;

  /// Whether the component may take one of these values at a point of the element on a segment,
  /// widened by `slack` in each coordinate; false: proven that it does not. `grow`: smaller nodes
  /// are made where they would tell more.
  [[nodiscard]] bool MayTake(
    const ValueSet& wanted, const Vec3& from, const Vec3& to, double slack, bool grow) const;
  /// A bound of how far the values within a distance of a point, in the element and next to the
  /// point in xi as well, are from its own; infinite where none is known.
  [[nodiscard]] double ChangeWithin(const LocatedPoint& point, double distance) const;

  /// Nodes that have been made.
  [[nodiscard]] std::int64_t Nodes() const { return Count.load(std::memory_order_relaxed); }

private:
  const EdgeNode& Whole() const;
  const EdgeNode& LeafAt(const Vec3& eta) const;
  const std::array<EdgeNode, 2>& Split(const EdgeNode& node) const;
  template <class Visit>
  void ForEachPiece(const EtaBox& box, const Visit& visit) const;
  [[nodiscard]] Interval HullOver(
    const EtaBox& box, const ScaledModes& modes, int component, Part part) const;
  /// `values`: hold those of the node.
  void Fill(EdgeNode& node, const Interval& values) const;
  /// `rounding`: as of the constructor.
  void DescribeErrors(double rounding);
  /// Of `components` functions together, 4 times what the conversion to a part makes at most: the
  /// kernels make the same sums, but for the order of the factors (accuracy.md).
  [[nodiscard]] double ErrorOf(const ScaledModes& modes, int components, Part part) const;
  /// Whether the map is regular.
  bool DescribeMap(EdgeNode& node, const std::array<std::array<Interval, 3>, 3>& slopes) const;
  /// By component.
  void DescribeCurves(
    EdgeNode& node, std::span<const std::array<HessianFunction::XiRanges, 4>> components) const;
  [[nodiscard]] Interval ValuesOver(const EtaBox& box) const;
  [[nodiscard]] std::array<HessianFunction::XiRanges, 4> RangesOf(
    const EtaBox& box, int component) const;
  /// Of the expansion of first order about a xi, from one step to another.
  [[nodiscard]] Interval LinearValues(const Vec3& xi, const Vec3& from, const Vec3& to) const;
  [[nodiscard]] bool Misses(
    const EdgeNode& node, const Vec3& from, const Vec3& to, double slack) const;
  /// By the affine map of a node.
  [[nodiscard]] Vec3 ToXi(const EdgeNode& node, const Vec3& x) const;
  /// In the element's units.
  [[nodiscard]] Vec3 ImageOf(const Vec3& xi) const;
  struct View;
  [[nodiscard]] View ViewAt(const Vec3& xi) const;
  enum class Meeting : std::uint8_t
  {
    None,   ///< of the segment and a point with one of the values: proven
    Near,   ///< there may be one
    Coarse, ///< and smaller nodes would tell more
  };
  [[nodiscard]] Meeting MeetNode(const EdgeNode& node, const ValueSet& wanted, const Vec3& from,
    const Vec3& to, double slack) const;
  [[nodiscard]] bool MayTakeIn(const EdgeNode& node, const ValueSet& wanted, const Vec3& from,
    const Vec3& to, double slack, bool grow) const;

  ScaledModes Map;
  ScaledModes Component;
  int Components; ///< of which the norm is taken, if there are several
  int Level = 0;
  int Deepest[2] = {}; ///< halvings of nodes that are not regular, and that are
  Vec3 Centre;
  double Size;
  std::array<double, 3> Uncertainty;
  // Of what the kernels compute: a value, a derivative by xi; of the map in the element's units.
  double ValueError = 0.0;
  double ValueSlopeError = 0.0;
  double ImageError = 0.0;
  double ImageSlopeError = 0.0;
  Interval Range;
  mutable std::unique_ptr<EdgeNode> Root;
  mutable std::atomic<const EdgeNode*> Ready{ nullptr };
  mutable std::mutex Growing;
  mutable std::atomic<std::int64_t> Count{ 0 };
};
} // namespace pixelexact
