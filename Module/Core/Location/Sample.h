// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Locator.h"

namespace pixelexact
{
/// The precision of values. Places and verdicts are always computed in double precision.
enum class Precision : unsigned char
{
  Double,
  Float
};

/// The largest difference between values in single and in double precision, at some points of each
/// element that were evaluated in both.
struct PrecisionCheck
{
  std::int64_t points = 0;
  double largest = 0.0; ///< difference of a component; of finite values

  void Add(const PrecisionCheck& other)
  {
    points += other.points;
    largest = largest < other.largest ? other.largest : largest;
  }
};

/// The output arrays of samples: one entry per point, or empty where not requested. Points outside
/// keep the arrays' previous entries; Clear() sets all to "nothing".
struct SampleTarget
{
  std::span<std::int32_t> element; ///< element number, -1 none; of unknown points a candidate
  std::span<Vec3> xi;              ///< reference coordinates; NaN where not inside
  std::span<Verdict> verdict;
  std::span<double> residual; ///< last Newton correction in xi, max norm
  std::span<double> value;    ///< components per point, point by point
  std::span<double> gradient; ///< 3 per component: d value_c / d x_d in world units
  /// Components per point: the enclosure of the value, proven to hold the field's value at the
  /// given point, inversion error included (Enclosure.h). It is -inf to inf where nothing is
  /// proven, NaN where not inside. Give both or none.
  std::span<double> valueLower = {};
  std::span<double> valueUpper = {};
  /// The precision of `value`. Gradients and enclosures are those of the values in double
  /// precision.
  Precision precision = Precision::Double;
  PrecisionCheck* check = nullptr; ///< added to, where values are computed in floats
  /// The unit normals of the surface at the points, for fields that need them
  /// (FieldFunction::NeedsNormals).
  std::span<const Vec3> normals = {};

  /// Sets element to -1, the verdict to outside, and everything else to NaN.
  void Clear() const;
};

/// Locates points and, where they are inside, evaluates `field` (which may be null) at their xi at
/// once, while the element's coefficients are in cache. Serial; points should be close together.
/// Clears the target first. Target spans must be empty or sized for the points.
void SampleTile(
  const Locator& locator, const Field* field, const LanePoints& points, const SampleTarget& target);
void SampleTile(const Locator& locator, const Field* field, std::span<const Vec3> points,
  const SampleTarget& target);

/// The same for any number of points in any order, in parallel; the result is independent of the
/// number of threads.
void Sample(const Locator& locator, const Field* field, std::span<const Vec3> points,
  const SampleTarget& target);

/// The world points of xi and the normals there; fields that are functions (Field::function) may
/// depend on them.
struct PlacesOfXi
{
  std::span<const Vec3> x{};       ///< in the world, near Phi(xi); empty: Phi(xi)
  std::span<const Vec3> normals{}; ///< as in SampleTarget
};

/// Evaluates `field`, and its world gradients where the span is not empty, at given xi of one
/// element, without location.
void EvaluateAt(const Mesh& mesh, const Field& field, int element, std::span<const Vec3> xi,
  std::span<double> value, std::span<double> gradient, const PlacesOfXi& places = {});

/// Encloses the values of `field` at world points x, whose preimages in one element are near xi
/// (see EncloseValues, with the mesh's uncertainty).
void EncloseAt(const Mesh& mesh, const Field& field, int element, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<double> lower, std::span<double> upper);

/// Evaluates the world points Phi(xi) of one element.
void MapForward(const Mesh& mesh, int element, std::span<const Vec3> xi, std::span<Vec3> x);
} // namespace pixelexact
