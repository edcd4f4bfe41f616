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
/// One of two solutions that are compared. What it points to must outlive its use.
struct Solution
{
  const Locator* locator = nullptr;
  const Field* field = nullptr;
};

/// Two solutions on a cut-surface. Where the surface is made of a mesh (Surface::IsOfMesh), it is
/// the first one's, and what is seen is what that shows.
struct DifferenceScene
{
  Solution first;
  Solution second; ///< as many components as the first one's
  std::shared_ptr<const Surface> surface;
  int component = 0; ///< of the difference, or kMagnitude: its Euclidean norm
  std::vector<KeptHalfSpace> kept = {};
};

/// Which of the solutions have a value where a pixel sees the surface.
enum class DifferenceSide : std::uint8_t
{
  Nothing = 0, ///< no surface, or both meshes proven not to be there
  Both = 1,
  Unknown = 2, ///< that of one of them, or whether the surface is there
  First = 3,   ///< and the second one's mesh proven not to be there
  Second = 4
};

/// The first field less the second one's, pixel by pixel.
struct FieldDifference
{
  /// Centres hold value, bounds (where asked for), verdict, position, depth, xi and element, and
  /// what else was asked for. Value: the difference, Exact where both have one. Bounds: proven to
  /// hold the difference at the position, the errors of both inverse maps included; infinite where
  /// nothing is proven. The rest is that of the solution whose hit is seen (`seen`). Verdict is
  /// Nothing where only one has a value; position, xi and element are there all the same.
  Frame frame;
  std::vector<std::uint8_t> side; ///< DifferenceSide
  std::vector<std::uint8_t> seen; ///< whose hit it is: 1, 2, or 0 for nothing
  std::vector<double> first;      ///< values (components, norms); NaN where there is none
  std::vector<double> second;
};

/// Of each pixel the nearest point of the surface that lies in either mesh. Both fields are
/// evaluated there, each by location in its own mesh; nothing is resampled. `extra`: buffers of
/// centres beside those told above. `bounds`: with proven bounds, which take some ten times as long
/// as values. Throws Error as Trace does, and where the fields have different numbers of components
/// or there is no such component. An empty frame where `progress` aborted it.
[[nodiscard]] FieldDifference TraceDifference(const DifferenceScene& scene, const Camera& camera,
  Buffer extra = Buffer::None, bool bounds = true, const Progress& progress = {});

/// What a difference amounts to. Counts are pixels; means are over those with a finite difference.
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
  /// The same of the first one's values at these pixels, for relative numbers.
  double firstRootMeanSquare = 0.0;

  // With bounds:
  bool bounded = false;
  std::int64_t unbounded = 0; ///< of both: nothing is proven
  /// Of the finite ones: how far any computed difference may be from the true one.
  double largestBound = 0.0;
  /// Proven to hold the largest true difference at the pixels' points, absolute.
  Interval largestTrue;
  std::int64_t provenApart = 0; ///< pixels whose difference is proven not to be 0
};
[[nodiscard]] DifferenceNumbers NumbersOf(const FieldDifference& difference);
} // namespace pixelexact
