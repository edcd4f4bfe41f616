// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CurveEquations.h"
#include "Core/Contour/CurvePoint.h"

#include <vector>

namespace pixelexact
{
/// A point that a contour in an element is known to pass.
struct ContourSeed
{
  CurvePoint point;
  unsigned faces = 0;      ///< on which it was found: bit k, face k of FacesOf(shape)
  bool onBoundary = false; ///< of the element
  bool certain = false;    ///< proven to be there; else only found
  bool used = false;       ///< by a piece that was traced
};

/// A place next to which a contour may be that was neither found nor excluded.
struct OpenPlace
{
  Vec3 xi{ 0.0 };
  unsigned faces = 0; ///< as ContourSeed's
};

/// The places where the contours of an element begin, end and turn.
struct SeedSearchResult
{
  std::vector<ContourSeed> seeds;
  std::vector<OpenPlace> open; ///< some of them, SeedEffort::open at most
  /// Faces on which the surface or the value holds everywhere: the polynomial is zero there to
  /// within the bound of its own rounding.
  std::vector<int> heldFaces;
  /// Whether every piece of the contour passes one of the seeds: it ends on the boundary, or is
  /// closed and turns along the direction that was searched.
  bool complete = true;
  bool spent = false; ///< the search ended because its effort was exhausted
  /// The field has the value on all of the surface in the element (F - rho is a multiple of S), or
  /// the surface lies in all of it, to within the bounds of their polynomials' rounding.
  bool constant = false;
};

/// Work budget of one element: boxes that the search for turns visits, as many on each face (1,000
/// at most), and the number of undecided places. Where it is exhausted, the result is not complete.
struct SeedEffort
{
  int boxes = 4000;
  std::size_t open = 256;
};

/// Every contour {f = 0, s = 0} in an element ends on its faces, or is closed. Its crossings with
/// the faces are roots of two polynomials of two variables. A closed one is farthest along any
/// direction c somewhere, where its tangent is normal to c: a root of
///   f = 0, s = 0, c . (grad f x grad s) = 0
/// by eta. All are isolated by the certified root finder; parts of the element where the hulls of f
/// or s leave no zero, or that of the third has one sign, hold none. c is the direction of a
/// contour at the boundary; where that leaves something undecided, two others are tried.
SeedSearchResult FindContourSeeds(const CurveEquations& equations, CurveEvaluator& evaluator,
  Shape shape, double value, const SeedEffort& effort = {});
} // namespace pixelexact
