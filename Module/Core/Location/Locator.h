// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"
#include "Core/Index/ElementIndex.h"

#include <atomic>
#include <span>

namespace pixelexact
{
/// Receives which points of a batch lie in which element, element by element.
class LocationSink
{
public:
  virtual ~LocationSink() = default;
  /// Points of the batch lie in `element`: `index[i]` in the batch, ascending, `xi[d][i]` their
  /// reference coordinates (padded for the kernels), `residual[i]` the size in xi of the last
  /// Newton correction. The arrays live until the call returns.
  virtual void Inside(
    int element, std::span<const int> index, const double* const xi[3], const double* residual) = 0;
  /// Reports that the position of point `index` is unknown; `element` is the first that might hold
  /// it.
  virtual void Unknown(int index, int element) = 0;
};

/// A xi that an element maps to a point.
struct Preimage
{
  int element = -1;
  Vec3 xi{ 0.0 };
  /// Within the faces' tolerance of a face: a neighbour may hold the point as well.
  bool onFace = false;
};

/// Every preimage of the points of a batch.
class PreimageSink
{
public:
  virtual ~PreimageSink() = default;
  /// A preimage of point `index`, proven to be the only one near its xi. Elements come in any
  /// order.
  virtual void Found(int index, const Preimage& preimage) = 0;
  /// Whether `element` holds point `index`, or how often, could not be decided.
  virtual void Undecided(int index, int element) = 0;
};

/// Counts how often each path was taken, over all calls, for reports and tests.
struct LocationCounters
{
  std::atomic<std::int64_t> queries{ 0 };    ///< BVH queries
  std::atomic<std::int64_t> candidates{ 0 }; ///< (point, element) pairs past box and frame
  std::atomic<std::int64_t> careful{ 0 };    ///< pairs that Newton left to the careful path
  std::atomic<std::int64_t> unknown{ 0 };    ///< points
  std::atomic<int> mostBoxes{ 0 };           ///< that the careful path looked at for one pair
};

/// Finds the elements that hold points (paper, section 5.1.2). A point query takes the place of the
/// paper's secondary ray, because it also finds that a point is outside of the mesh.
///
/// A point on a shared face belongs to the lowest element number whose inverse map is decided by
/// the fast path. The answer for a point depends on the point and the mesh alone, not on the batch
/// it came in, on threads or on the order of work.
///
/// Verdicts: a point is `Inside` with a converged inverse (residual of rounding size) in the shape
/// or beyond its faces by no more than rounding and conditioning explain. It is outside of an
/// element when the element's box, its affine frame with its deviation, the uniqueness of a root
/// outside, or subdivision exclude it; otherwise it is unknown.
class Locator
{
public:
  /// Builds boxes and BVH, in parallel; other data of an element are computed when a point first
  /// needs them. The mesh must be valid (Validate); its arrays must outlive the locator. An empty
  /// mesh is allowed and holds no point.
  explicit Locator(const Mesh& mesh)
    : index_(mesh)
  {
  }

  /// Serial: for use inside of a parallel loop. Points outside of every element are not
  /// reported. Points with NaN or infinite coordinates are outside.
  /// Best called with points that lie close together, a few hundred to a few thousand.
  void Locate(const LanePoints& points, LocationSink& sink) const;
  void Locate(std::span<const Vec3> points, LocationSink& sink) const;

  /// All preimages of the points in all elements: none proves a gap, several that are not all on
  /// faces an overlap or a fold. Serial; slower than Locate, for meshes that are being debugged.
  void LocateAll(std::span<const Vec3> points, PreimageSink& sink) const;

  [[nodiscard]] const ElementIndex& Index() const { return index_; }
  /// Access for setting the trees' limit.
  [[nodiscard]] ElementIndex& Index() { return index_; }
  [[nodiscard]] const Mesh& GetMesh() const { return index_.GetMesh(); }
  /// The box of the whole mesh, certified; lower > upper for an empty mesh.
  [[nodiscard]] const Box3& Bounds() const { return index_.Bounds(); }
  [[nodiscard]] const LocationCounters& Counters() const { return counters_; }

private:
  class Batch;
  ElementIndex index_;
  mutable LocationCounters counters_;
};
} // namespace pixelexact
