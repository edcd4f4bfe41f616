// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/ElementFunctions.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// The end of a graph along a direction: the box's end, or the place where the graph leaves the box
/// through the lower or upper end of its own direction.
enum class GraphLimit : std::uint8_t
{
  BoxEnd,
  ThroughLower,
  ThroughUpper
};

/// A part of a cut-surface in an element that is proven to be a graph: for every a of the box and
/// every b between the limits, which are functions of a, there is exactly one c in the box on the
/// surface, and beyond the limits there is none.
struct CutGraph
{
  PieceBox box;
  std::array<int, 3> axes{}; ///< the directions a, b, c
  GraphLimit low = GraphLimit::BoxEnd;
  GraphLimit high = GraphLimit::BoxEnd;
};

/// The proven geometry of the cut-surface in a box.
struct CutInBox
{
  /// Holds all of the surface in the given box.
  PieceBox box;
  bool empty = false;
  /// All of the surface is in these graphs and `rest`. Otherwise the surface in the box is unknown.
  bool decided = false;
  std::vector<CutGraph> graphs;
  /// Thin strips about places where the limits change their kind. Where the surface is in a strip,
  /// it is also a graph over some of the box's (a, b).
  std::vector<CutGraph> rest;
};

/// Finds the graphs in a box, after R. Saye, High-order quadrature methods for implicitly defined
/// surfaces and volumes in hyperrectangles, SIAM J. Sci. Comput. 37, 2015. Hulls of Bernstein
/// coefficients replace that paper's heuristics by proofs. `tolerance`: of the cut's polynomial; on
/// faces of the element smaller values count as zero, so that a surface through an edge or a vertex
/// ends there.
CutInBox LookAtCut(ElementFunctions& functions, const PieceBox& box, double tolerance);
} // namespace pixelexact
