// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShapeLattice_h
#define ShapeLattice_h

#include "Core/Element/Mesh.h"
#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <array>
#include <mutex>
#include <span>
#include <vector>

namespace pixelexact
{
/// A shape's reference space, divided into VTK's linear cells. Each edge of the shape has n parts,
/// and faces are divided into squares and triangles of that size, so that cells of neighbours
/// match. A hexahedron becomes n^3 hexahedra, a prism n^3 wedges, a tetrahedron n^3 tetrahedra, a
/// pyramid n (2 n^2 + 1) / 3 pyramids and 2 n (n^2 - 1) / 3 tetrahedra.
struct ShapeLattice
{
  std::vector<Vec3> points;         ///< in xi, each once
  std::vector<unsigned char> types; ///< VTK's, per cell
  std::vector<int> offsets{ 0 };    ///< into `corners`, one more than cells
  std::vector<int>
    corners; ///< numbers of points, in VTK's order; volumes (VolumeOf) in xi are positive

  [[nodiscard]] std::size_t Cells() const { return types.size(); }
  [[nodiscard]] std::span<const int> Corners(std::size_t cell) const
  {
    return std::span(corners).subspan(static_cast<std::size_t>(offsets[cell]),
      static_cast<std::size_t>(offsets[cell + 1] - offsets[cell]));
  }
};

inline constexpr int kMaxSubdivisions = 5;

/// An object for each shape and level, created on first use.
template <class Thing>
class PerLevel
{
public:
  template <class Make>
  const Thing& Get(Shape shape, int level, const Make& make)
  {
    Entry& entry = Entries[static_cast<std::size_t>(shape)][static_cast<std::size_t>(level)];
    std::call_once(entry.once, [&] { entry.thing = make(); });
    return entry.thing;
  }

private:
  struct Entry
  {
    std::once_flag once;
    Thing thing;
  };
  std::array<std::array<Entry, kMaxSubdivisions + 1>, kShapeCount> Entries;
};

/// Edges in 2^level parts, 0 to kMaxSubdivisions.
[[nodiscard]] const ShapeLattice& LatticeOf(Shape shape, int level);

/// The place, or with a field its values, at points of an element: `components` numbers each.
[[nodiscard]] std::vector<double> ValuesAt(
  const Mesh& mesh, const Field* field, int element, std::span<const Vec3> xi, int components);
} // namespace pixelexact
#endif
