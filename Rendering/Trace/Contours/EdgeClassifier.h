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
/// What a ray through the end of an edge sees.
struct EdgeEnd
{
  ImagePosition position{};
  int layer = -1;          ///< that is seen, in the mesh and decided; -1: none is
  int element = -1;        ///< where the layer that is judged is seen
  LocatedPoint point;      ///< there; of planes `x` is known beside the mesh and behind others, too
  bool meets = false;      ///< whether `x` is known
  bool isAhead = false;    ///< and not behind the eye
  bool isUnknown = false;  ///< it is not decided what is seen there
  std::int32_t piece = -1; ///< of the surface, and where on it: what the hit tells
  int face = -1;           ///< of the element, that the surface is there; -1: none
  double parameters[2] = { 0.0, 0.0 };

  [[nodiscard]] SurfacePoint OnSurface() const
  {
    return { point.x, element, point.xi, piece, { parameters[0], parameters[1] } };
  }
};

/// An edge of a pixel or a part of it, as far as it is on one layer's surface.
struct SurfaceEdge
{
  Vec3 from{ 0.0 };
  Vec3 to{ 0.0 };
  double sagitta = 0.0; ///< how far off the straight edge the surface's is; infinite: not known
};

enum class EdgeFinding : std::uint8_t
{
  Out,      ///< proven: no value occurs on it
  In,       ///< proven: one does
  Open,     ///< not settled by the bounds
  Blurred,  ///< nor by any of its parts: all values on it are one up to their rounding
  Uncovered ///< nor proven that the edge lies in the element
};

/// How far points where rays meet a surface may be off, by rounding: in every coordinate, a part of
/// the largest.
[[nodiscard]] double SlackOf(std::span<const Vec3> corners);

/// Classifies edges on a layer's surface: of one tile, by one thread.
class EdgeClassifier
{
public:
  /// `values`: in ascending order; `elements`: all whose boxes meet the tile's part of the surface.
  /// `work`: for all that is asked; null: without a limit.
  EdgeClassifier(const LayerBounds& bounds, std::span<const double> values, EdgeWork* work,
    std::span<const int> elements);
  /// The same where nobody knows the elements: each edge's are looked for.
  EdgeClassifier(const LayerBounds& bounds, std::span<const double> values, EdgeWork* work);

  /// Between which values a value is: the number of those below it.
  [[nodiscard]] int SideOf(double value) const;
  /// Of an edge that is on no known side.
  static constexpr int kNoSide = -1;

  /// What a sample costs between two ends, for EdgeWork.
  [[nodiscard]] std::int64_t SampleCost(const EdgeEnd& a, const EdgeEnd& b) const;
  /// After a sample of which it is not decided what it shows: that cost all that a point may.
  void SpendOnUnknown() const;
  /// See EdgeWork.
  void Reserve(double part) const
  {
    if (Work)
    {
      Work->Reserve(part);
    }
  }
  /// Whether so much may be spent yet; it is, then.
  [[nodiscard]] bool Affords(std::int64_t cost) const { return !Work || Work->Affords(cost); }

  /// Whether some element may take a value, or elements lie on several sides.
  [[nodiscard]] bool IsNeeded() const { return Needed; }

  /// An edge between points of the same element, by the bounds of that element alone.
  [[nodiscard]] EdgeFinding Within(
    const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const;
  /// Whether all elements that the edge may meet stay on a side there; of kNoSide, on any one.
  /// `thorough`: more is found out about the elements where that helps.
  [[nodiscard]] bool StaysOn(int side, const SurfaceEdge& edge, bool thorough) const;
  /// The same of a flat polygon and how far off it the surface is.
  [[nodiscard]] bool StaysOn(int side, const Outline& part, double sagitta) const;
  /// The values on a flat part of the surface next to three ends in one element, by the bounds of
  /// that element alone; nothing where it is not proven that the part lies in it.
  [[nodiscard]] std::optional<PlanarValues> Over(
    const std::array<EdgeEnd, 3>& ends, const Outline& part) const;
  /// Whether an interval holds a value.
  [[nodiscard]] bool Meets(double lower, double upper) const { return Wanted.Meets(lower, upper); }
  /// Whether all elements that a flat part of the surface may meet stay on a side there; of
  /// kNoSide, on any one. `thorough`: as above.
  [[nodiscard]] bool BlockStaysOn(int side, const Outline& part, bool thorough) const;
  /// Whether an end lies on a plateau: all of the surface in its element has one of the values, as
  /// far as the component's coefficients tell (Plateau.h), or all of the surface has
  /// (HoldEverywhere).
  [[nodiscard]] bool IsOnPlateau(const EdgeEnd& end) const;
  /// Whether an end's value may be one: it is known, and no farther off than it may be itself.
  [[nodiscard]] bool MayTouch(const EdgeEnd& end) const;
  /// What is judged has one of the values everywhere (Surface::HeldValue).
  void HoldEverywhere() { IsHeld = true; }
  /// What is judged lies in a plane.
  void LieOn(const Plane& plane) { plane_ = &plane; }
  /// Of ends in any elements between which the surface goes on: by their values, In or Open.
  [[nodiscard]] EdgeFinding Across(const EdgeEnd& a, const EdgeEnd& b) const;
  /// Whether, of all of the surface that rays between two may meet, none takes a value, nor lies on
  /// either side of one where it hangs together: by parts of the beam that it does not meet, and
  /// others in which all elements stay on one side.
  [[nodiscard]] bool StaysBetween(const Surface& surface, const EdgeBeam& beam) const;
  /// Whether a value lies between those of the ends, or is one, as far as they are known.
  [[nodiscard]] bool AreOpposite(const EdgeEnd& a, const EdgeEnd& b) const;
  /// Whether the two values are farther apart than the field varies along the edge.
  [[nodiscard]] bool IsJump(const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const;

private:
  struct Element
  {
    int number;
    Box3 box;
    const EdgeBounds* bounds;
    int side; ///< of all of its values; kNoSide: they may be on several
  };
  /// With the work of the tile.
  [[nodiscard]] EdgeEffort With(EdgeEffort effort) const;
  [[nodiscard]] ValueSet NotOn(int side) const;
  /// Whether one of the values lies between two that are good to `error`.
  [[nodiscard]] bool IsBetween(double lower, double upper, double error) const
  {
    return lower + error < upper - error && Wanted.Meets(lower + error, upper - error);
  }
  /// The values that the component holds in an element, on the plane.
  [[nodiscard]] const Interval& HeldOnPlane(int element) const;
  /// Whether the values of all elements there are on one side; of kNoSide, any.
  [[nodiscard]] bool StaysOn(int side, std::span<const Element> elements, const WideOutline& region,
    const EdgeEffort& effort) const;
  /// Finite ones whose boxes it meets; until it is called again.
  [[nodiscard]] std::span<const Element> ElementsAt(const WideOutline& region) const;
  [[nodiscard]] Element MakeElement(int element) const;

  const LayerBounds& Bounds;
  ValueSet Wanted;
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
