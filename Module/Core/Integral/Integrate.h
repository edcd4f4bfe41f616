// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/FaceOwner.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Integral/ElementIntegral.h"

#include <span>

namespace pixelexact
{
/// Tolerance and limits of an integral.
struct IntegralEffort
{
  /// The bound of each integral's error is to be this part of the integral of the magnitude, or
  /// less; 0 < tolerance.
  double tolerance = 1e-8;
  /// The limit of time; infinite: none. When it is exceeded, the bounds reached by then are
  /// returned.
  double seconds = std::numeric_limits<double>::infinity();
  std::int64_t boxes = 200000; ///< looked at, per element
};

/// The integrals with their bounds.
struct SurfaceIntegral
{
  /// Hold the area, the integral of each component, and of a vector of three components the flux,
  /// along the gradient of the cut-surface's function, or out of the elements.
  Sums sums;
  std::vector<double> magnitudes; ///< about the integrals of the magnitudes
  bool met = false;               ///< the tolerance

  std::int64_t elements = 0;  ///< that the surface meets, as far as is known
  std::int64_t faces = 0;     ///< of elements that lie in the surface, or were asked for
  std::int64_t boxes = 0;     ///< looked at
  std::int64_t rounded = 0;   ///< boxes of which rounding allows no narrower bounds
  double unresolved = 0.0;    ///< at most so much area is where nothing is known of the surface
  std::int64_t notFinite = 0; ///< elements that are left out: with a NaN or infinite coefficient
  std::int64_t tooHigh = 0;   ///< elements that are left out: of too high order for the surface
  std::int64_t flat = 0;      ///< elements that are left out: the field has the value throughout
  std::int64_t notValid = 0;  ///< elements that meet, whose det J > 0 is not proven
  std::int64_t covered = 0;   ///< faces of a boundary with other elements behind a part of them
  bool timeIsOver = false;
  /// The field is a function without models (FieldFunction::HasModels): bounds of all but the area
  /// are estimates.
  bool isNumeric = false;
};

/// Integrates over the part of a cut-surface in a mesh: see Documentation/integrals.md for the
/// method and for what is proven. The locator is the mesh's. In parallel; unless the time is over,
/// the result does not depend on threads.
SurfaceIntegral IntegrateCut(const IntegralQuestion& question, const Locator& locator,
  const FaceTable& faces, const IntegralEffort& effort);

/// Adds the integrals over another surface.
void AddTo(SurfaceIntegral& sum, const SurfaceIntegral& more);

/// Integrates over faces of elements.
SurfaceIntegral IntegrateFaces(const IntegralQuestion& question, std::span<const ElementFace> faces,
  const IntegralEffort& effort);
} // namespace pixelexact
