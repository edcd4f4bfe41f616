// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Math/Vec.h"

#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace pixelexact
{
/// An enclosure of the value at a point of a box.
struct PointValue
{
  Interval value = Interval::Everything();
  std::array<double, 3> t{}; ///< the point, in the box's own [-1, 1]^3
};

/// A continuous function of polynomials, evaluated over one box at a time.
class RangeFunction
{
public:
  virtual ~RangeFunction() = default;
  /// Encloses all values over the box; may be unbounded.
  [[nodiscard]] virtual Interval Enclose(std::span<const BoxPolynomial> polynomials) const = 0;
  /// Encloses the value at a corner (see BoxPolynomial::AtCorner).
  [[nodiscard]] virtual Interval AtCorner(
    std::span<const BoxPolynomial> polynomials, unsigned corner) const = 0;
  /// Encloses the value at some point of the box where a small value is likely. Unbounded where
  /// there is no guess.
  [[nodiscard]] virtual PointValue AtLikelyMinimum(
    std::span<const BoxPolynomial> polynomials) const;
  /// The order, 1 or 2, of the differences of the polynomials that choose the direction of
  /// subdivision.
  [[nodiscard]] virtual int TellingDifference() const = 0;
};

/// Values attained at points, as CertifiedRange::attained, and the points of its ends.
struct AttainedValues
{
  Interval values{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  Vec3 lowerPoint{ std::numeric_limits<double>::quiet_NaN() };
  Vec3 upperPoint{ std::numeric_limits<double>::quiet_NaN() };

  /// Includes an enclosure of the value at a point.
  void Add(const Interval& value, const Vec3& point);
  /// Includes values attained at other points.
  void Add(const AttainedValues& others);
};

/// A part of a function's domain.
struct RangeBox
{
  std::vector<BoxPolynomial> polynomials;
  Box3 place{ Vec3(-1.0), Vec3(1.0) }; ///< in the domain's coordinates
  std::array<int, 3> subdivisions{};
  Interval bound = Interval::Everything(); ///< of the values
  /// Width of the enclosures at single points. Subdivision does not reduce it.
  double rounding = 0.0;
  /// A lower bound of the values at the corners. A function whose enclosure at a corner reaches
  /// down to zero cannot be proven positive, however often the box is subdivided.
  double lowestCorner = 0.0;
  /// Recomputes the polynomials. A box with this function does not keep them, which saves memory
  /// for large domains in many boxes.
  std::function<std::vector<BoxPolynomial>()> remake;

  /// Encloses the values and returns the values attained at the corners.
  AttainedValues Look(const RangeFunction& function);
  /// Becomes one child and returns the other. Divides along the direction that tightens the bound
  /// most.
  RangeBox Subdivide(const RangeFunction& function);
  /// The number of coefficients held.
  [[nodiscard]] std::size_t Held() const;
};

/// A proven range of a function's values.
struct CertifiedRange
{
  /// Holds all values.
  Interval outer = Interval::Everything();
  /// A value not above `lower` and one not below `upper` are attained, hence all values between
  /// them. lower > upper where the function is constant up to rounding.
  Interval attained{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  /// Points at which the ends of `attained` are attained, up to rounding of the coordinates; NaN
  /// where the search found no value beyond those that were known before.
  Vec3 lowerPoint{ std::numeric_limits<double>::quiet_NaN() };
  Vec3 upperPoint{ std::numeric_limits<double>::quiet_NaN() };
  int boxes = 0;      ///< looked at
  bool met = false;   ///< the tolerance
  bool finite = true; ///< false where the function's coefficients are not: nothing is said then

  /// The largest distances of the outer ends from attained values.
  [[nodiscard]] double GapBelow() const { return attained.lower - outer.lower; }
  [[nodiscard]] double GapAbove() const { return outer.upper - attained.upper; }
};

/// Whether the gaps at both ends are at most `tolerance` times the attained range, 2^-40 of the
/// largest magnitude, or 2^-400.
bool IsWithin(const CertifiedRange& range, double tolerance);
/// The gap that IsWithin allows.
double AllowedGap(const CertifiedRange& range, double tolerance);

/// Branch and bound on the range of a function: subdivides the box whose enclosure exceeds the
/// attained range most.
class RangeSearch
{
public:
  /// `known`: values attained elsewhere, where several functions share one range. Boxes without
  /// values outside it are not subdivided.
  RangeSearch(const RangeFunction& function, const Interval& known);

  /// Adds a box of the domain. Together the boxes must cover it.
  void Add(RangeBox box);

  /// The range proven up to now.
  [[nodiscard]] CertifiedRange Current() const;

  enum class End : unsigned char
  {
    Lower,
    Upper
  };
  /// Subdivides the box whose enclosure reaches farthest at this end. Returns false where no
  /// enclosure exceeds the attained range by more than rounding, or memory allows no further box.
  bool Refine(End end);

private:
  const RangeFunction& Function;
  std::vector<RangeBox> Boxes; ///< that may reach beyond what is attained
  AttainedValues Attained;
  int Count = 0;
  std::size_t Held = 0; ///< coefficients
};

/// Refines until the gaps at both ends are at most AllowedGap(..., tolerance), or `gap` where that
/// is larger, or the budget of boxes is exhausted.
CertifiedRange SearchRange(RangeSearch& search, double tolerance, double gap, int budget);
} // namespace pixelexact
