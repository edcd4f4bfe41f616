// SPDX-License-Identifier: BSD-3-Clause
#ifndef LinearCell_h
#define LinearCell_h

#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <algorithm>
#include <span>
#include <vector>

// VTK's linear cells between elements' vertices. VTK computes a positive volume for a cell whose
// faces' corners run counter-clockwise as seen from outside. For tetrahedra, hexahedra and pyramids
// this is a right-handed cell; wedges are left-handed up to VTK 9.6 and right-handed from 9.7 on.
// Cells are therefore oriented by VTK's own lists of faces, whatever the handedness of the
// elements' maps.
namespace pixelexact
{
struct Mesh;

/// VTK's linear cell of a shape, with corners numbered as in SolverModel.h.
struct LinearCell
{
  int type = 0;
  std::vector<Vec3> corners; ///< in xi
  std::vector<int> faceOf;   ///< per face of VTK's, its number in FacesOf(shape)
};

const LinearCell& LinearCellOf(Shape shape);

/// The volume, signed as VTK does, of a linear cell of `type` with corners at `places`, its faces
/// fanned out from their first corners. Exact up to rounding for plane faces.
double VolumeOf(int type, std::span<const Vec3> places);

/// Renumbers the corners of a linear cell so that its volume changes its sign.
template <class T>
void Mirror(std::span<T> corners)
{
  const auto half = static_cast<std::ptrdiff_t>(corners.size() / 2);
  if (corners.size() >= 6) // hexahedron, wedge: the other end first
  {
    std::swap_ranges(corners.begin(), corners.begin() + half, corners.begin() + half);
  }
  else // tetrahedron, pyramid: the base turns the other way
  {
    std::swap(corners[1], corners[corners.size() - 2]);
  }
}

/// The number that a face of VTK's cell has once the cell is mirrored.
int MirroredFace(int type, int face);

/// Whether VTK's cell between the element's vertices must be mirrored for its volume to be
/// positive.
bool IsMirrored(const Mesh& mesh, int element);
} // namespace pixelexact
#endif
