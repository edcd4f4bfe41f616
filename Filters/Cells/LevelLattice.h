// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelLattice_h
#define LevelLattice_h

#include "Cells/ShapeLattice.h"

#include "Core/Element/Mesh.h"

#include <array>
#include <mutex>
#include <span>
#include <vector>

namespace pixelexact
{
inline constexpr int kMostSubdivisions = 5;

/// Something of each shape and level, made when it is first asked for.
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
  std::array<std::array<Entry, kMostSubdivisions + 1>, kShapeCount> Entries;
};

/// Edges in 2^level parts, 0 to kMostSubdivisions.
[[nodiscard]] const ShapeLattice& LatticeOf(Shape shape, int level);

/// The place, or with a field its values, at points of an element: `components` numbers each.
[[nodiscard]] std::vector<double> ValuesAt(
  const Mesh& mesh, const Field* field, int element, std::span<const Vec3> xi, int components);
} // namespace pixelexact
#endif
