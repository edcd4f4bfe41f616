// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourQuestion.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
struct ContourVertex
{
  Vec3 x{ 0.0 };        ///< world
  Vec3 xi{ 0.0 };       ///< in its element
  Vec3 gradient{ 0.0 }; ///< of the value, world units
  double value = 0.0;   ///< of the field
  int element = -1;     ///< of several that share it, the one that is lowest
};

struct ContourLine
{
  std::vector<std::int64_t> vertices; ///< of a closed one, the first again at the end
  std::size_t value = 0;              ///< which of the values
  bool closed = false;
  bool certified = false;
};

/// Counts of the pieces found, and of the cases that could not be decided.
struct ContourReport
{
  std::int64_t elements = 0;    ///< looked into: the hulls leave room for a contour
  std::int64_t undecided = 0;   ///< (element, value) whose contours may not all have been found
  std::int64_t pieces = 0;      ///< of lines, in elements
  std::int64_t unproven = 0;    ///< pieces whose course is not proven
  std::int64_t lost = 0;        ///< pieces that could not be followed to an end
  std::int64_t spent = 0;       ///< of those, where the work budget was exhausted
  std::int64_t touched = 0;     ///< pieces that the field touches without crossing the value
  std::int64_t constant = 0;    ///< elements where the field is the value: nothing is drawn
  std::int64_t notFinite = 0;   ///< elements with coefficients that are NaN or infinite
  std::int64_t tooHigh = 0;     ///< elements of orders that the root finder does not take
  std::int64_t endsInside = 0;  ///< of lines, not on the mesh's boundary: where the field jumps
  std::int64_t ambiguous = 0;   ///< ends that meet more than one other
  std::int64_t normsOfZero = 0; ///< values 0 of a norm, which is no line
  std::int64_t uncertified = 0; ///< lines

  ContourReport& operator+=(const ContourReport& more);
};

struct ContourSet
{
  std::vector<ContourVertex> vertices;
  std::vector<ContourLine> lines; ///< by value
  ContourReport report;
};

struct ContourRequest
{
  std::vector<double> values;
  /// World units, at least 1e-10 of the mesh's diagonal: chords lie within it of the contours, as
  /// measured at their middles.
  double tolerance = 0.0;
};

/// Traces the contours of a field on a cut-surface as polylines: see
/// Documentation/contours-proof.md for the method and for what is proven. The locator is the
/// mesh's. In parallel; the result does not depend on threads. Throws InvalidData for values that
/// are not finite or a tolerance that is too small, and Unsupported for a mapped field (H(curl),
/// H(div), density).
ContourSet TraceContours(const ContourQuestion& question, const Locator& locator,
  const FaceTable& faces, const ContourRequest& request);
/// The same on each of several patches of a surface, in place of the question's cut and clips.
/// Lines end at the patches' ends.
ContourSet TraceContours(const ContourQuestion& question, std::span<const SurfacePatch> patches,
  const Locator& locator, const FaceTable& faces, const ContourRequest& request);

/// Appends contours `more` to `all`. Their values are numbered from `valuesBefore` on.
void Append(ContourSet&& more, std::size_t valuesBefore, ContourSet& all);
} // namespace pixelexact
