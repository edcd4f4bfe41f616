// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellNodes_h
#define CellNodes_h

#include "Core/Basis/Space.h"
#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <tuple>
#include <vector>

// The nodes of VTK's Lagrange cells, by the corners of the shape's linear cell (LinearCellOf). The
// numbering is taken from VTK's own classes, so that it follows the VTK that is built against.
namespace pixelexact
{
struct Mesh;

/// Degrees of a cell along VTK's r, s, t, 1 to kMaxCellDegree; those of a wedge's triangle are
/// equal, and so are all of a tetrahedron's. All 1: the linear cell, the only one of pyramids.
using CellDegrees = std::array<unsigned char, 3>;

/// The largest degree that VTK's Lagrange cells evaluate (vtkHigherOrderInterpolation::MaxDegree).
inline constexpr int kMaxCellDegree = 10;

/// A node lies at sum of weight[c] corner[c] over the sum of the weights. On vertices, edges and
/// faces the weights of the other corners are 0, and their ratios name the node whichever way a
/// neighbour is turned. They are divided by their greatest common divisor.
struct CellNode
{
  std::array<int, 8> weight{};

  /// Corners with a weight: 1 at a vertex, 2 on an edge, 3 or 4 on a face.
  [[nodiscard]] int CornerCount() const;
};

struct CellNodes
{
  int type = 0; ///< VTK_...
  int corners = 0;
  std::vector<CellNode> nodes; ///< in VTK's order, corners first

  /// The nodes between corners at these places: one for each node.
  [[nodiscard]] std::vector<Vec3> Between(std::span<const Vec3> cornerPlaces) const;
  /// Whether VTK takes the cell's volume for positive where it takes that of the linear cell
  /// between its corners for negative. VTK cuts Lagrange cells into tetrahedra, which in some
  /// versions wind a wedge the other way.
  [[nodiscard]] bool IsWoundAgainstLinear() const;
  /// Whether a node lies on the boundary of the cell, which neighbours may share.
  [[nodiscard]] bool IsOnBoundary(const CellNode& node) const;
};

[[nodiscard]] CellNodes MakeCellNodes(Shape shape, const CellDegrees& degrees);

/// The degrees of a cell that holds a space's functions, at most kMaxCellDegree.
[[nodiscard]] CellDegrees CellDegreesOf(const Space& space);

/// The nodes of a cell that is not mirrored, by their places among those of the mirrored one.
[[nodiscard]] std::vector<std::size_t> UnmirroredOrder(const CellNodes& cell);

/// A kind of cell, mirrored where VTK would compute a negative volume otherwise.
struct CellOfKind
{
  CellNodes nodes;
  bool isMirrored = false;
  std::vector<Vec3> xi; ///< of the nodes, in the element
};

/// The cells of a mesh's elements with these degrees; those of one kind are made once.
class ElementCells
{
public:
  ElementCells(const Mesh& mesh, std::span<const CellDegrees> degrees);
  [[nodiscard]] const CellOfKind& Of(int element) const
  {
    return *Cells[static_cast<std::size_t>(element)];
  }

private:
  std::map<std::tuple<Shape, CellDegrees, bool>, CellOfKind> Kinds;
  std::vector<const CellOfKind*> Cells;
};
} // namespace pixelexact
#endif
