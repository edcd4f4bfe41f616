// SPDX-License-Identifier: BSD-3-Clause
#ifndef CutClip_h
#define CutClip_h

#include "Core/Base/Verdict.h"
#include "Core/Location/Locator.h"
#include "Cuts/CutTriangles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// A triangulated cut-surface that ends where the mesh does.
struct ClippedCut
{
  /// Points of the whole surface that are left, by their numbers there. They come first.
  std::vector<std::int64_t> kept;
  std::vector<Vec3> rim; ///< points on the mesh's boundary; they come behind
  std::vector<std::array<std::int64_t, 3>> triangles; ///< of both
  std::int64_t atTheRim = 0;                          ///< triangles of the whole that were cut
};

/// Cuts off what of each triangle lies beyond the mesh, where some of its corners, not all, are
/// inside (`verdicts`): along each edge from an inner corner to another one the mesh's end is
/// searched for by halving, to 2^-16 of the edge, on the surface, and the last point that is proven
/// inside is taken. Ends of the mesh between corners of one kind are not seen. Parallel; the result
/// is independent of the number of threads.
[[nodiscard]] ClippedCut ClipToMesh(const CutFunction& cut, const CutTriangles& whole,
  std::span<const Verdict> verdicts, const Locator& locator);
} // namespace pixelexact
#endif
