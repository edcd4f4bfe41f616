// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Interval.h"
#include "Trace/Camera.h"
#include "Trace/Frame.h"
#include "Trace/Scene.h"
#include "Trace/Tracer.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pixelexact
{
/// One of two compared solutions. Its objects must outlive its use.
struct Solution
{
  const Locator* locator = nullptr;
  const Field* field = nullptr;
};

/// Two solutions on a cut-surface. A surface that is made of a mesh (Surface::IsOfMesh) belongs to
/// the first solution, whose hits are then shown.
struct DifferenceScene
{
  Solution first;
  Solution second; ///< as many components as the first one's
  std::shared_ptr<const Surface> surface;
  int component = 0; ///< of the difference, or kMagnitude: its Euclidean norm
  std::vector<KeptHalfSpace> kept = {};
};

/// Solutions that have a value at a pixel's point of the surface.
enum class DifferenceSide : std::uint8_t
{
  Nothing = 0, ///< no surface, or proven outside both meshes
  Both = 1,
  Unknown = 2, ///< one value, or the surface's hit, is unknown
  First = 3,   ///< proven outside the second one's mesh
  Second = 4
};

/// The first field minus the second one, pixel by pixel.
struct FieldDifference
{
  /// Centres hold value, bounds (if requested), verdict, position, depth, xi and element, and the
  /// buffers `extra`. Value: the difference; Exact if both solutions have a value. Bounds: proven
  /// to contain the difference at the position, including the errors of both inverse maps; infinite
  /// if nothing is proven. Other buffers belong to the solution whose hit is shown (`seen`). The
  /// verdict is Nothing if only one solution has a value; position, xi and element are written
  /// nevertheless.
  Frame frame;
  std::vector<std::uint8_t> side; ///< DifferenceSide
  std::vector<std::uint8_t> seen; ///< solution whose hit is shown: 1, 2, or 0 for none
  std::vector<double> first;      ///< values of the component or norm; NaN without a value
  std::vector<double> second;
};

/// Evaluates both fields at each pixel's nearest point of the surface that lies in either mesh,
/// each by location in its own mesh; nothing is resampled. `extra`: buffers of centres in addition
/// to those named above. `bounds`: with proven bounds, which take about ten times as long as
/// values. Throws Error as Trace does, and if the fields have different numbers of components or
/// lack the component. Returns an empty frame if `progress` aborted it.
[[nodiscard]] FieldDifference TraceDifference(const DifferenceScene& scene, const Camera& camera,
  Buffer extra = Buffer::None, bool bounds = true, const Progress& progress = {});

/// Statistics of a difference. Counts are pixels; means are over pixels with a finite difference.
struct DifferenceNumbers
{
  std::int64_t both = 0;
  std::int64_t onlyFirst = 0;
  std::int64_t onlySecond = 0;
  std::int64_t unknown = 0;
  std::int64_t nothing = 0;
  std::int64_t notFinite = 0; ///< of both: a NaN or infinite value in either
  double largest = 0.0;       ///< absolute
  std::int64_t largestPixel = -1;
  Vec3 largestAt{ 0.0 };
  double mean = 0.0;           ///< of absolute values
  double rootMeanSquare = 0.0; ///< L2 over the pixels
  /// Root mean square of the first solution's values at these pixels, for relative numbers.
  double firstRootMeanSquare = 0.0;

  // Only with bounds:
  bool bounded = false;
  std::int64_t unbounded = 0; ///< of both: nothing is proven
  /// Largest distance of a computed difference from the true one, over finite bounds.
  double largestBound = 0.0;
  /// Proven to contain the largest true difference at the pixels' points, absolute.
  Interval largestTrue;
  std::int64_t provenApart = 0; ///< pixels whose difference is proven not to be 0
};
[[nodiscard]] DifferenceNumbers NumbersOf(const FieldDifference& difference);
} // namespace pixelexact
