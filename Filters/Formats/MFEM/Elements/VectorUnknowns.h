// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Formats/MFEM/Elements/CollectionName.h"

#include <utility>
#include <vector>

// The unknowns of Nedelec's and Raviart and Thomas's elements.

namespace pixelexact::mfem
{
/// Its value is that of the field, in MFEM's unit element, at a point and along a direction:
/// tangential of H(curl), normal of H(div).
struct VectorUnknown
{
  LongVec3 node;
  LongVec3 direction;
};

/// The unknowns in MFEM's local order. `name` gives kind and order; the points on lines are those
/// of its bases on cubes, and Gauss-Lobatto and Gauss points on the other solids.
std::vector<VectorUnknown> VectorUnknowns(const CollectionName& name, Geometry solid);

/// The points in [0,1] of the unknowns' coordinates on a cube, by axis: those of a component along
/// `axis`.
std::vector<long double> CubeLine(const CollectionName& name, int component, int axis);

// The unknowns of H(curl) and H(div) entity by entity, in any order of the entities.

using LongLine = std::vector<long double>;

inline constexpr LongVec3 kX{ 1, 0, 0 };
inline constexpr LongVec3 kY{ 0, 1, 0 };
inline constexpr LongVec3 kZ{ 0, 0, 1 };

/// n points of a line basis in [0,1]; none for n <= 0.
std::vector<long double> UnitPoints(LineBasis basis, int n);

class VectorUnknownBuilder
{
public:
  VectorUnknownBuilder(Continuity kind, LineBasis closed, LineBasis open, int order);

  void Edge(const LongVec3& a, const LongVec3& b);
  void Triangle(const LongVec3& a, const LongVec3& b, const LongVec3& c);
  /// `b` and `d` are the neighbours of `a`.
  void Square(const LongVec3& a, const LongVec3& b, const LongVec3& d);
  void InsideTetrahedron();
  void InsidePrism();
  void InsideCube();
  void InsidePyramid();

  [[nodiscard]] std::vector<VectorUnknown> Take() { return std::move(Unknowns); }

private:
  void Orient(int component);
  void OnTriangle(const LongLine& line, const LongVec3& a, const LongVec3& along,
    const LongVec3& across, const std::vector<LongVec3>& directions);
  void InsideClosedTriangle(long double z);
  void Grid(const LongVec3& a, const LongVec3& along, const LongLine& us, const LongVec3& across,
    const LongLine& vs, const LongVec3& direction);

  bool Tangential;
  int Order;
  LongLine Open;
  LongLine Closed;
  LongLine Between; ///< closed without its ends
  LongLine OnFace;  ///< of triangles
  LongLine InSolid; ///< of tetrahedra and, for normals, prisms' triangles
  std::vector<VectorUnknown> Unknowns;
};
} // namespace pixelexact::mfem
