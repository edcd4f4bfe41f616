// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Math/Interval.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pixelexact
{
/// A number and an estimate of its error. Both are numeric: nothing is proven.
struct Estimate
{
  double value = 0.0;
  double error = 0.0;
};

/// The integrals over one element. |f| is the magnitude of a scalar, the Euclidean norm of others.
struct ElementNorms
{
  Estimate volume;       ///< of |det J|
  Estimate absolute;     ///< of |f|
  Estimate square;       ///< of |f|^2
  double largest = 0.0;  ///< |f| at the sample with the largest one
  Vec3 xi{ 0.0 };        ///< this sample
  bool isFinite = true;  ///< false: a value or det J is not finite; all numbers are 0
  bool isFolded = false; ///< det J <= 0 at a sample
};

/// Tolerance and limits of norms.
struct NormEffort
{
  /// Boxes are subdivided until the estimated error of each integral is this part of the integral
  /// of the magnitude, or less; 0 < tolerance.
  double tolerance = 1e-6;
  /// The number of evaluations in all elements together, after the first ones over whole elements.
  std::int64_t evaluations = std::int64_t{ 1 } << 22;
  /// The highest order of the fields that an expression reads; other fields have their own.
  int order = 8;
};

/// Norms of a field over a mesh.
struct FieldNorms
{
  std::vector<ElementNorms> elements; ///< by element
  Estimate volume;
  std::vector<Estimate> integrals; ///< of the components
  Estimate l1;                     ///< the integral of |f|
  Estimate l2;                     ///< the root of the integral of |f|^2
  double largest = 0.0;            ///< |f| at the sample with the largest one
  int largestElement = -1;         ///< -1: no value is finite
  int notFinite = 0;               ///< elements with a value that is not finite, which are left out
  int folded = 0;                  ///< elements with det J <= 0 at a sample; |det J| is integrated
  bool met = false;                ///< the tolerance
  std::int64_t boxes = 0;          ///< integrated over, in all
};

/// Integrates over all elements of a valid mesh with Gauss rules in eta, of two numbers of points;
/// the estimate of the error is the sum over boxes of the differences of the two rules, and a bound
/// of the sums' rounding. For polynomial fields both rules are exact for |f|^2 and for components,
/// up to rounding. Boxes with the largest differences are subdivided, where |f| has kinks most.
/// `thickness`: of the slab that stands for a plane mesh (Slab.h); the results are then those over
/// the plane. 0: the mesh is none. Parallel; the result is independent of the number of threads.
/// Throws Unsupported for expressions with normals or jumps.
FieldNorms FindNorms(const Mesh& mesh, const Field& field, double thickness,
  const NormEffort& effort = {}, const std::function<void(double)>& progress = {});

/// Proven: holds the largest |f| over the elements whose coefficients are finite, with a gap of at
/// most 1e-4 of the range of values within 256 boxes an element. None where no range is proven, as
/// for expressions with a pole.
std::optional<Interval> LargestMagnitude(
  const Mesh& mesh, const Field& field, const std::function<void(double)>& progress = {});

/// The part of the integral of |f|^2 of which reports count the elements.
inline constexpr double kCountedPart = 0.9;
/// The elements in descending order of their part of the integral of |f|^2.
std::vector<int> OrderBySquare(const FieldNorms& norms);
/// The smallest number of elements, the first ones in that order, that have `part` of the integral
/// of |f|^2; 0 <= part <= 1.
int CountWithPart(const FieldNorms& norms, double part);
} // namespace pixelexact
