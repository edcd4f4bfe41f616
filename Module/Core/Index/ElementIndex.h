// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bounds/ElementBounds.h"
#include "Core/Index/EmbreeBvh.h"
#include "Core/Index/Segment.h"
#include "Core/Tree/ElementTree.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// An index of a mesh's elements: their boxes with a hierarchy over them, built in the constructor;
/// bounds and trees of elements, each built on first use. It contains no points, rays or fields;
/// location, surfaces and contours use it.
///
/// Safe to use from several threads. Results do not depend on what has been built before.
class ElementIndex
{
public:
  /// The mesh must be valid (Validate); its arrays must outlive the index. An empty mesh is
  /// allowed.
  explicit ElementIndex(const Mesh& mesh);
  ~ElementIndex();
  ElementIndex(const ElementIndex&) = delete;
  ElementIndex& operator=(const ElementIndex&) = delete;

  [[nodiscard]] const Mesh& GetMesh() const { return mesh_; }
  /// The box of the whole mesh, certified; lower > upper for an empty mesh.
  [[nodiscard]] const Box3& Bounds() const { return MeshBounds; }
  /// The box that holds the element's image, widened by its uncertainty.
  [[nodiscard]] const Box3& ElementBox(int element) const
  {
    return Boxes[static_cast<std::size_t>(element)];
  }

  /// Finds all elements whose boxes meet a box, by ascending number.
  void FindNear(const Box3& region, std::vector<int>& elements) const;
  /// Finds the elements whose boxes a segment of a ray (ClipRay) meets, and some others near it, by
  /// ascending number.
  void FindAlong(const Segment& segment, std::vector<int>& elements) const;

  [[nodiscard]] const ElementBounds& BoundsOf(int element) const
  {
    const auto* made = Made[static_cast<std::size_t>(element)].load(std::memory_order_acquire);
    return made ? *made : MakeBounds(element);
  }
  [[nodiscard]] bool HasBounds(int element) const
  {
    return Made[static_cast<std::size_t>(element)].load(std::memory_order_relaxed) != nullptr;
  }
  /// The number of elements whose bounds have been computed.
  [[nodiscard]] int BoundedElements() const { return MadeCount; }

  /// The tree of an element. The index keeps trees as long as all of them together are within the
  /// limit; then it drops all, and rebuilds each on its next use. A dropped tree exists until its
  /// last holder releases it.
  [[nodiscard]] std::shared_ptr<ElementTree> TreeOf(int element) const;
  /// Sets the number of bytes above which trees are dropped; 256 MiB by default. Results do not
  /// depend on it.
  void SetTreeLimit(std::size_t bytes) { TreeLimit = static_cast<std::int64_t>(bytes); }
  [[nodiscard]] std::size_t TreeBytes() const;

  /// Bytes held in addition to the mesh's own arrays.
  [[nodiscard]] std::size_t MemoryUsage() const;

private:
  const ElementBounds& MakeBounds(int element) const;

  Mesh mesh_;
  Box3 MeshBounds;
  std::vector<Box3> Boxes;
  std::unique_ptr<Bvh> Hierarchy;
  std::unique_ptr<std::atomic<const ElementBounds*>[]> Made;
  mutable std::atomic<int> MadeCount{ 0 };
  /// Declared before the trees, which subtract from it when they are destroyed.
  mutable std::atomic<std::int64_t> Grown{ 0 };
  std::atomic<std::int64_t> TreeLimit{ std::int64_t{ 256 } << 20U };
  mutable std::mutex TreesMutex;
  mutable std::vector<std::shared_ptr<ElementTree>> Trees;
};
} // namespace pixelexact
