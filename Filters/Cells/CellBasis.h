// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellBasis_h
#define CellBasis_h

#include "Core/Basis/ChangeOfBasis.h"

#include "vtkSmartPointer.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

class vtkCell;

// The basis of each kind of VTK cell, and its way into the canonical one.
//
// VTK's parametric coordinates (r, s, t) in [0,1] become our reference coordinates by
//   hexahedron, tetrahedron   xi = 2 (r, s, t) - 1
//   wedge                     xi = (2 r - 1, 1 - 2 t, 2 s - 1): triangle in xi1 and xi3, line in
//                             xi2, reversed so that the handedness stays
//   triangle, quadrilateral   those of the wedge and the hexahedron, of order 0 across: a slab
//   pyramid                   eta = 2 (r, s, t) - 1, collapsed to xi: VTK's are those of the cube
namespace pixelexact
{
/// Conventions of a file's Lagrange cells that differ from VTK's.
struct NodeConvention
{
  bool gaussLobatto = false;   ///< nodes at Gauss-Lobatto-Legendre points, not equispaced
  bool mirroredWedges = false; ///< see MakeOtherWedge

  auto operator<=>(const NodeConvention&) const = default;
};

/// Cells of one kind share one basis.
struct CellKind
{
  int type = 0;   ///< VTK_...
  int points = 0; ///< number of points
  /// Degrees along r, s, t as the file gives them (HigherOrderDegrees). 0: the degree follows from
  /// the number of points.
  std::array<int, 3> degrees{ 0, 0, 0 };
  NodeConvention nodes;      ///< of Lagrange cells
  std::uint64_t weights = 0; ///< hash of rational weights; 0: they are equal

  auto operator<=>(const CellKind&) const = default;
};

struct CellBasis
{
  CellKind kind;
  ChangeOfBasis change;
  /// For Lagrange cells: positions in the cell of the nodes along the three edges that leave the
  /// vertex r = s = t = 0, from one end to the other. Empty otherwise.
  std::array<std::vector<int>, 3> edges;
  /// For pyramids of order 2: the map of the pyramid between their five vertices, which come first,
  /// in the space of `change` and in its own. Empty otherwise.
  std::vector<ChangeOfBasis> straight{};
  /// For higher-order cells: positions in the cell of the nodes or control points, in the order in
  /// which ChangeOfBasis::Hexahedron, Prism and Tetrahedron take them. Empty otherwise.
  std::vector<int> control{};
  /// NoiseBound of `change`; infinite: not known.
  double noise = std::numeric_limits<double>::infinity();

  [[nodiscard]] const Space& GetSpace() const { return change.Target(); }
};

/// "vtkLagrangeWedge" and the like, or "cell type 99".
std::string CellTypeName(int type);

/// Topological dimension of a cell type; -1 for types that VTK does not know.
int CellDimension(int type);

/// The basis of a kind of cell of two or three dimensions. Throws Unsupported for types that have
/// none here, InvalidData where the number of points fits no order. Messages begin with the type's
/// name.
CellBasis MakeCellBasis(const CellKind& kind);

/// Whether the type is a VTK Lagrange or Bezier cell of any order.
bool IsHigherOrderCell(int type);
bool IsLagrangeCell(int type);
bool IsHigherOrderPlaneCell(int type);
CellBasis MakeHigherOrderCellBasis(const CellKind& kind);
CellBasis MakeHigherOrderPlaneCellBasis(const CellKind& kind);

/// The map of a Lagrange wedge whose nodes inside the quadrilateral r = 0 are mirrored along s in
/// comparison with `kind.nodes`, as in files of MFEM. The kind must have order >= 3 in the triangle
/// and >= 2 along t.
ChangeOfBasis MakeOtherWedge(const CellKind& kind);

/// A VTK cell of a kind, whose point ids are the positions in the cell; all points are the origin.
vtkSmartPointer<vtkCell> MakeCell(const CellKind& kind);

/// The map from samples of a VTK cell's own interpolation functions, which lie in `space`.
ChangeOfBasis SampleCell(const CellKind& kind, const Space& space);
} // namespace pixelexact
#endif
