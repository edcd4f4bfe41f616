// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Nurbs/PatchTopology.h"

#include <cstdint>

namespace pixelexact::mfem
{
/// Numbers of control points or vertices, which form a tensor grid in every patch, in MFEM's order:
/// at the patches' vertices first, then inside edges, faces and patches.
class PatchNumbering
{
public:
  /// `counts`: per knot vector, the number of points along it, ends included, at least two. The
  /// topology must outlive this object.
  PatchNumbering(const PatchTopology& topology, std::vector<int> counts);

  /// The total number. It has 64 bits because the counts of a damaged file multiply.
  [[nodiscard]] std::int64_t Size() const { return Numbers; }

  using Counts = std::array<int, 3>; ///< 1 across plane patches
  [[nodiscard]] Counts CountsOf(std::size_t patch) const;
  /// A patch's numbers, the first direction fastest. Call it only where Size() is no more than
  /// memory holds.
  [[nodiscard]] std::vector<int> GridOf(std::size_t patch) const;
  /// A boundary patch's numbers, along its knot vectors in their own sense, the one from its first
  /// vertex to its second fastest. MFEM turns outer ones so that their normals point outwards.
  struct Boundary
  {
    std::vector<int> grid;
    std::array<int, 2> vectors{ -1, -1 }; ///< -1: there is none
    std::array<int, 2> counts{ 1, 1 };
  };
  [[nodiscard]] Boundary BoundaryOf(std::size_t boundary) const;

private:
  [[nodiscard]] int OnEdge(int a, int b, int n) const;
  [[nodiscard]] int OnFace(const Cell& patch, const std::array<int, 3>& ends,
    const std::array<int, 2>& directions, const std::array<int, 2>& at) const;

  const PatchTopology& Topology;
  std::vector<int> Along; ///< per knot vector
  std::vector<std::int64_t> FirstOnEdge;
  std::vector<std::int64_t> FirstOnFace;
  std::vector<std::int64_t> FirstInPatch;
  std::int64_t Numbers = 0;
};

/// The position of an element: its patch and its place in the patch. Elements follow each other
/// patch by patch, the first direction fastest.
struct GridPlace
{
  std::size_t patch = 0;
  std::array<int, 3> at{};
};
MeshFile MakeGridMesh(
  const PatchTopology& topology, const PatchNumbering& vertices, std::vector<GridPlace>& places);
} // namespace pixelexact::mfem
