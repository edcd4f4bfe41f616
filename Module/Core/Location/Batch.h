// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/CheckedOut.h"
#include "Core/Location/Locator.h"
#include "Core/Location/PointBudget.h"
#include "Core/Location/PointKernels.h"
#include "Core/Location/TreeFilter.h"

namespace pixelexact
{
/// The work of Locator::Locate on one batch of points: for each element that a group of points may
/// lie in, all points at once, from rejection over the inverse map to the sink, so that the
/// element's data are loaded once.
class Locator::Batch
{
public:
  Batch(const Locator& locator, const LanePoints& points, LocationSink& sink);
  ~Batch();
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  void Run();

private:
  struct Doubt
  {
    int index;
    int element;
    Vec3 root; ///< where Newton converged to, outside of the shape; NaN where it did not
  };

  void Search(std::span<PointChunk> chunks);
  void SearchChildren(std::span<PointChunk> chunks);
  void SearchElement(std::span<PointChunk> chunks, int element);
  int Select(std::span<PointChunk> chunks, int element, const ElementBounds*& bounds);
  [[nodiscard]] bool AnyInBox(std::span<const PointChunk> chunks, const Box3& box) const;
  void Invert(std::span<PointChunk> chunks, const ElementBounds& bounds, int count);
  void DropExcluded(std::span<PointChunk> chunks, std::size_t firstDoubt);
  void Decide(std::span<PointChunk> chunks);
  void DecideGroup(ElementTree& tree, std::span<const Doubt> doubts, std::span<PointChunk> chunks);
  static void Close(int index, std::span<PointChunk> chunks);
  [[nodiscard]] Vec3 PointAt(int index) const;

  /// The arrays of a batch.
  struct Scratch;

  const Locator& Owner;
  const ElementIndex& Index;
  const Mesh& mesh_;
  const LanePoints& Points;
  LocationSink& Sink;
  const PointKernels& Kernels;
  CheckedOut<Scratch> Lease;
  Scratch& Work;
  InverseProblem Problem{};
  int Element = -1; ///< of Problem
  std::int64_t Queries = 0;
  std::int64_t Candidates = 0;
  std::int64_t Careful = 0;
  std::int64_t Unknown = 0;
  int MostBoxes = 0;
};
} // namespace pixelexact
