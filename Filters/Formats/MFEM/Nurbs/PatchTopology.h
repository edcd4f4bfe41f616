// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"

#include <array>
#include <map>
#include <set>
#include <vector>

// The patches of a NURBS mesh: squares or cubes whose edges run along knot vectors.
namespace pixelexact::mfem
{
/// The vertex of a square or cube at the lower (0) or upper (1) end of each direction, in MFEM's
/// order.
int CornerAt(const std::array<int, 3>& ends);
/// The reverse.
std::array<int, 3> EndsOf(int corner);

struct PatchTopology
{
  /// A knot vector along an edge, or along a direction of a patch.
  struct Line
  {
    int vector = 0;
    bool isReversed = false; ///< runs from the higher vertex to the lower, or against the direction
  };
  /// The side of a patch at one end of a direction.
  struct Side
  {
    std::size_t patch = 0;
    int direction = 0;
    int end = 0;
  };

  int dimension = 3;
  int vertices = 0;
  std::vector<Cell> patches;
  std::vector<Cell> boundary;                   ///< each is a side of a patch
  std::vector<std::array<int, 2>> edges;        ///< lower vertex first; in MFEM's order
  std::vector<Line> knots;                      ///< per edge
  std::vector<std::array<int, 4>> faces;        ///< of cubes, in MFEM's order
  std::vector<std::array<Line, 3>> lines;       ///< per patch and direction
  std::vector<std::vector<Side>> boundarySides; ///< of each boundary patch: one or two
  /// Edges that the file lists from their higher vertex.
  std::set<int> listedDownwards;
  int vectors = 0; ///< distinct knot vectors

  [[nodiscard]] int FindEdge(int a, int b) const;
  [[nodiscard]] int FindFace(std::array<int, 4> corners) const;

  std::map<std::array<int, 2>, int> edgeOf;
  std::map<std::array<int, 4>, int> faceOf;
};

/// Reads from "dimension" to "vertices". Where the file lists no edges, knot vectors are numbered
/// as MFEM does, and where edges of a patch run along them in different senses, they are turned.
/// Throws InvalidData and Unsupported.
PatchTopology ReadPatchTopology(TextScanner& scanner);
} // namespace pixelexact::mfem
