// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

// The places of the nodes of Lagrange bases on lines, triangles and tetrahedra.
namespace pixelexact
{
enum class NodeFamily : std::uint8_t
{
  Equispaced,
  GaussLobatto ///< Gauss-Lobatto-Legendre points on edges
};

/// The order + 1 nodes of a line, in [-1,1], ascending; order 0 has its node at the centre.
std::vector<long double> LineNodes(int order, NodeFamily family);

/// The nodes of triangles and tetrahedra of order > 0. A node has a number along each barycentric
/// coordinate; their sum is the order. Gauss-Lobatto-Legendre nodes of order above 3, whose places
/// inside triangles are a matter of choice, are Unsupported.
class SimplexNodes
{
public:
  SimplexNodes(int order, NodeFamily family);

  /// The coordinate in [-1,1] along which the node has number `i`; `others`: its other numbers.
  [[nodiscard]] long double At(int i, std::initializer_list<int> others) const;

private:
  std::vector<long double> Places;
  NodeFamily Nodes;
};
} // namespace pixelexact
