// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"

#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace pixelexact
{
/// A continuous function made of polynomials, seen over one box at a time.
class RangeFunction
{
public:
  virtual ~RangeFunction() = default;
  /// Holds all values over the box; may be unbounded.
  [[nodiscard]] virtual Interval Enclose(std::span<const BoxPolynomial> polynomials) const = 0;
  /// Holds the value at a corner (see BoxPolynomial::AtCorner).
  [[nodiscard]] virtual Interval AtCorner(
    std::span<const BoxPolynomial> polynomials, unsigned corner) const = 0;
  /// Holds the value at some point of the box where a small one is likely; everything, where there
  /// is no guess.
  [[nodiscard]] virtual Interval AtLikelyMinimum(std::span<const BoxPolynomial> polynomials) const;
  /// Which differences of the polynomials tell where a box should be split: 1 or 2.
  [[nodiscard]] virtual int TellingDifference() const = 0;
};

/// A part of a function's domain.
struct RangeBox
{
  std::vector<BoxPolynomial> polynomials;
  std::array<int, 3> subdivisions{};
  Interval bound = Interval::Everything(); ///< of the values
  /// Width of the enclosures at single points: what no halving takes away.
  double rounding = 0.0;
  /// Not above the value at any corner; a function whose enclosure at a corner reaches down to zero
  /// cannot be proven positive, however often the box is subdivided.
  double lowestCorner = 0.0;
  /// Makes the polynomials once more. Where given they are not held, which of large domains in
  /// many boxes saves the memory.
  std::function<std::vector<BoxPolynomial>()> remake;

  /// Encloses the values and returns what is attained at the corners, as CertifiedRange::attained.
  Interval Look(const RangeFunction& function);
  /// Becomes one half and returns the other, along the direction that promises most.
  RangeBox Subdivide(const RangeFunction& function);
  /// The number of coefficients held.
  [[nodiscard]] std::size_t Held() const;
};

/// What is proven of the values of a function.
struct CertifiedRange
{
  /// Holds all values.
  Interval outer = Interval::Everything();
  /// A value not above `lower` and one not below `upper` are attained, hence all values between
  /// them. lower > upper where the function is constant up to rounding.
  Interval attained{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  int boxes = 0;      ///< looked at
  bool met = false;   ///< the tolerance
  bool finite = true; ///< false where the function's coefficients are not: nothing is said then

  /// How far, at most, the outer ends lie beyond values that are attained.
  [[nodiscard]] double GapBelow() const { return attained.lower - outer.lower; }
  [[nodiscard]] double GapAbove() const { return outer.upper - attained.upper; }
};

/// Whether the gaps at both ends are at most `tolerance` times the attained range, 2^-40 of the
/// largest magnitude, or 2^-400.
bool IsWithin(const CertifiedRange& range, double tolerance);
/// The gap that IsWithin allows.
double AllowedGap(const CertifiedRange& range, double tolerance);

/// Branch and bound on the range of a function: of all boxes, the one whose enclosure reaches
/// farthest is halved.
class RangeSearch
{
public:
  /// `known`: values attained elsewhere, where the range sought is that of several functions
  /// together; boxes with no value beyond them are not looked into any further.
  RangeSearch(const RangeFunction& function, const Interval& known);

  /// A box of the domain. Together they must cover it.
  void Add(RangeBox box);

  /// What is known by now.
  [[nodiscard]] CertifiedRange Current() const;

  enum class End : unsigned char
  {
    Lower,
    Upper
  };
  /// Children the box whose enclosure reaches farthest at this end. False where none reaches beyond
  /// what is attained by more than rounding, or memory allows no further box.
  bool Refine(End end);

private:
  const RangeFunction& Function;
  std::vector<RangeBox> Boxes; ///< that may reach beyond what is attained
  Interval Attained;
  int Count = 0;
  std::size_t Held = 0; ///< coefficients
};

/// Refines until the gaps at both ends are at most AllowedGap(..., tolerance), or `gap` where that
/// is larger, or the budget of boxes is spent.
CertifiedRange SearchRange(RangeSearch& search, double tolerance, double gap, int budget);
} // namespace pixelexact
