// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeBeam.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/TraceTile.h"

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// The sample of a ray through the end of an edge.
struct EdgeEnd
{
  ImagePosition position{};
  int layer = -1;          ///< that the ray shows, decided and in the mesh; -1: none
  int element = -1;        ///< where the ray shows the classified layer
  LocatedPoint point;      ///< there; planes have `x` also outside the mesh and where hidden
  bool meets = false;      ///< whether `x` is known
  bool isAhead = false;    ///< and not behind the eye
  bool isUnknown = false;  ///< it is undecided what the ray shows
  std::int32_t piece = -1; ///< of the surface, and `parameters` on it: the hit's
  int face = -1;           ///< of the element, if the surface is this face; -1: none
  double parameters[2] = { 0.0, 0.0 };

  [[nodiscard]] SurfacePoint OnSurface() const
  {
    return { point.x, element, point.xi, piece, { parameters[0], parameters[1] } };
  }
};

/// The part of a layer's surface that a pixel's edge, or a part of the edge, shows.
struct SurfaceEdge
{
  Vec3 from{ 0.0 };
  Vec3 to{ 0.0 };
  double sagitta = 0.0; ///< largest distance from the straight edge; infinite: unknown
};

enum class EdgeFinding : std::uint8_t
{
  Out,      ///< proven: no iso-value occurs on the edge
  In,       ///< proven: one occurs
  Open,     ///< undecided by the bounds; parts may decide
  Blurred,  ///< undecided also on parts: all values agree up to rounding
  Uncovered ///< undecided, and not proven to lie in the element
};

/// Largest error, in each coordinate, of points where rays meet a surface: a multiple of the
/// largest coordinate.
[[nodiscard]] double SlackOf(std::span<const Vec3> corners);

/// Classifies edges on one layer's surface in one tile. An object serves one thread.
class EdgeClassifier
{
public:
  /// `values`: of the component, in ascending order. Other functions take values of the scalar
  /// that the bounds are of (LayerBounds::ToBounded). `elements`: all elements whose boxes meet the
  /// tile's part of the surface. `work`: budget of all calls; null: unlimited.
  EdgeClassifier(const LayerBounds& bounds, std::span<const double> values, EdgeWork* work,
    std::span<const int> elements);
  /// Searches the elements near each edge.
  EdgeClassifier(const LayerBounds& bounds, std::span<const double> values, EdgeWork* work);

  EdgeClassifier(const EdgeClassifier&) = delete;
  EdgeClassifier& operator=(const EdgeClassifier&) = delete;

  /// The interval between iso-values that contains a value: the number of iso-values below it.
  [[nodiscard]] int SideOf(double value) const;
  /// The side of an edge on which no value is known.
  static constexpr int kNoSide = -1;

  /// Cost of a sample between two ends, in EdgeWork's units.
  [[nodiscard]] std::int64_t SampleCost(const EdgeEnd& a, const EdgeEnd& b) const;
  /// Pays for a sample that stays Unknown: the most that the location of a point may cost.
  void SpendOnUnknown() const;
  /// Reserves a part of the work budget; see EdgeWork.
  void Reserve(double part) const
  {
    if (Work)
    {
      Work->Reserve(part);
    }
  }
  /// Takes `cost` from the work budget. Returns false if the budget is exhausted.
  [[nodiscard]] bool Affords(std::int64_t cost) const { return !Work || Work->Affords(cost); }

  /// An element may take an iso-value, or elements lie on several sides.
  [[nodiscard]] bool IsNeeded() const { return Needed; }

  /// Classifies an edge between two points of one element by that element's bounds.
  [[nodiscard]] EdgeFinding Within(
    const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const;
  /// All elements that the edge may meet stay on `side` there; kNoSide: on any one side.
  /// `thorough`: elements are subdivided where that helps.
  [[nodiscard]] bool StaysOn(int side, const SurfaceEdge& edge, bool thorough) const;
  /// The same for a flat polygon; the surface is within `sagitta` of it.
  [[nodiscard]] bool StaysOn(int side, const Outline& part, double sagitta) const;
  /// The values on a flat part of the surface near three ends in one element, by that element's
  /// bounds; none if the part is not proven to lie in the element.
  [[nodiscard]] std::optional<PlanarValues> Over(
    const std::array<EdgeEnd, 3>& ends, const Outline& part) const;
  /// An iso-value lies in [lower, upper].
  [[nodiscard]] bool Meets(double lower, double upper) const { return Wanted.Meets(lower, upper); }
  /// All elements that a flat part of the surface may meet stay on `side` there; kNoSide: on any
  /// one side. `thorough`: as above.
  [[nodiscard]] bool BlockStaysOn(int side, const Outline& part, bool thorough) const;
  /// The end lies on a plateau: all of the surface in its element, or all of the surface
  /// (HoldEverywhere), has one of the iso-values, up to the error of the component's coefficients
  /// (Plateau.h).
  [[nodiscard]] bool IsOnPlateau(const EdgeEnd& end) const;
  /// An iso-value lies within the error of the end's value, and this error is finite.
  [[nodiscard]] bool MayTouch(const EdgeEnd& end) const;
  /// Declares that the field equals one iso-value on all of the surface (Surface::HeldValue).
  void HoldEverywhere() { IsHeld = true; }
  /// Declares that the surface is a plane.
  void LieOn(const Plane& plane) { plane_ = &plane; }
  /// Compares the values of two ends between which the surface is continuous: In or Open. The ends
  /// may lie in different elements.
  [[nodiscard]] EdgeFinding Across(const EdgeEnd& a, const EdgeEnd& b) const;
  /// No part of the surface that rays between two others may meet takes an iso-value, and each
  /// connected part stays on one side. The beam is subdivided into parts that the surface does not
  /// meet, and parts where all elements stay on one side.
  [[nodiscard]] bool StaysBetween(const Surface& surface, const EdgeBeam& beam) const;
  /// An iso-value lies between the ends' values, or equals one of them. Ignores their errors.
  [[nodiscard]] bool AreOpposite(const EdgeEnd& a, const EdgeEnd& b) const;
  /// The ends' values differ by more than the field can vary along the edge.
  [[nodiscard]] bool IsJump(const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const;

private:
  struct Element
  {
    int number;
    Box3 box;
    const EdgeBounds* bounds;
    int side; ///< of all its values; kNoSide: possibly several
  };
  /// `effort` with the tile's work budget.
  [[nodiscard]] EdgeEffort With(EdgeEffort effort) const;
  [[nodiscard]] ValueSet NotOn(int side) const;
  /// An iso-value lies between two values whose errors are at most `error`.
  [[nodiscard]] bool IsBetween(double lower, double upper, double error) const
  {
    return lower + error < upper - error && Wanted.Meets(lower + error, upper - error);
  }
  /// The values that the component has everywhere on the plane in an element; empty if it varies.
  [[nodiscard]] const Interval& HeldOnPlane(int element) const;
  /// The values of all these elements in the region stay on one side; kNoSide: on any one side.
  [[nodiscard]] bool StaysOn(int side, std::span<const Element> elements, const WideOutline& region,
    const EdgeEffort& effort) const;
  /// Elements with finite values whose boxes meet the region. Valid until the next call.
  [[nodiscard]] std::span<const Element> ElementsAt(const WideOutline& region) const;
  [[nodiscard]] Element MakeElement(int element) const;

  const LayerBounds& Bounds;
  std::vector<double> IsoValues; ///< of the bounded scalar, in ascending order
  ValueSet Wanted{ IsoValues };
  EdgeWork* Work;
  std::vector<Element> Near; ///< by number
  mutable std::vector<Element> Found;
  bool Needed = false;
  bool LooksForElements = false;
  bool IsHeld = false;
  const Plane* plane_ = nullptr;
  mutable std::map<int, Interval> OnPlane; ///< by element
};
} // namespace pixelexact
