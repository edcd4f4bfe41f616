// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/RootFinder.h"
#include "Core/Contour/ContourSeeds.h"

#include <optional>

namespace pixelexact
{
/// Margin, in xi, of points that lie in the element.
inline constexpr double kOutside = -1e-9;
/// Distance to a face, in xi, of points that lie on it.
inline constexpr double kOnFace = 1e-9;
/// The distance, in xi, from an undecided place within which a contour is searched.
inline constexpr double kNear = 1e-2;

/// A part of an element, and the polynomials over it.
struct CurvePart
{
  Box3 box; ///< of eta
  CurvePolynomials polynomials;

  /// A place in it along a direction, t from 0 to 1.
  [[nodiscard]] double Between(std::size_t direction, double t) const;
};

/// The middle of a box, or of an enclosure.
Parameters MiddleOf(const ParameterBox& box);
Parameters MiddleOf(const ParameterIntervals& box);

/// The seeds found so far in an element, each listed once.
class SeedList
{
public:
  /// `exact`: roots of the polynomials are the contour's.
  SeedList(Shape shape, bool exact, std::size_t mostOpen = SeedEffort{}.open)
    : shape_(shape)
    , Exact(exact)
    , MostOpen(mostOpen)
  {
  }

  /// The point that stands for an isolated root, on these faces (ContourSeed); none where Newton's
  /// iteration did not find it.
  void AddRoot(const std::optional<CurvePoint>& point, unsigned faces);
  /// A point found where roots are undecided, or none: next to `xi`.
  void AddUndecided(const std::optional<CurvePoint>& point, unsigned faces, const Vec3& xi);
  /// Whether no more places may stay open.
  [[nodiscard]] bool IsFull() const { return result.open.size() >= MostOpen; }

  SeedSearchResult result;

private:
  void Add(const CurvePoint& point, unsigned faces, bool certain);

  Shape shape_;
  bool Exact;
  std::size_t MostOpen;
};
} // namespace pixelexact
