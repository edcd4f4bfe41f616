// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Index/ElementIndex.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// Classifies the elements behind a face.
enum class FaceKind : std::uint8_t
{
  Boundary, ///< nothing: the mesh ends there
  Interior, ///< one whole face of another element
  Hanging,  ///< faces of other elements of which at least one is larger or smaller; all of it is
            ///< covered
  Partly    ///< other elements behind a part of it
};

/// A face of an element, numbered as in FacesOf(shape); element -1: none.
struct ElementFace
{
  std::int32_t element = -1;
  std::int32_t face = -1;

  auto operator<=>(const ElementFace&) const = default;
};

/// The faces of all elements of a mesh, numbered through.
class FaceNumbers
{
public:
  explicit FaceNumbers(const Mesh& mesh);

  [[nodiscard]] std::size_t Faces() const { return First.back(); }
  [[nodiscard]] std::size_t NumberOf(int element, int face) const
  {
    return First[static_cast<std::size_t>(element)] + static_cast<std::size_t>(face);
  }
  [[nodiscard]] int FacesOfElement(int element) const
  {
    const auto e = static_cast<std::size_t>(element);
    return static_cast<int>(First[e + 1] - First[e]);
  }
  [[nodiscard]] std::size_t MemoryUsage() const { return First.capacity() * sizeof(std::size_t); }

private:
  std::vector<std::size_t> First; ///< per element, and the number of all
};

/// Classifies what lies behind each face of each element, from the mesh's geometry alone: files
/// need not state which elements are neighbours, and neighbours need not share nodes. See
/// Documentation/curved-surfaces.md for the method, for what is compared and for what is not
/// proven.
///
/// Safe to use from several threads. The result does not depend on threads and order of work.
class FaceTable
{
public:
  /// Builds the table in parallel. The index is not used afterwards.
  explicit FaceTable(const ElementIndex& index);

  /// The number of faces of all elements: a face between two elements counts twice.
  [[nodiscard]] std::int64_t Faces() const { return static_cast<std::int64_t>(Kinds.size()); }
  /// The number of these faces that are of a kind.
  [[nodiscard]] std::int64_t CountOf(FaceKind kind) const;

  /// `face` as in FacesOf(shape). The arguments are not checked.
  [[nodiscard]] FaceKind KindOf(int element, int face) const
  {
    return Kinds[Numbers.NumberOf(element, face)];
  }
  /// The face on the other side of an Interior one, the first where elements overlap. None for
  /// other kinds, and for an Interior face without area, which a collapsed element may have.
  [[nodiscard]] ElementFace NeighbourOf(int element, int face) const
  {
    return Neighbours[Numbers.NumberOf(element, face)];
  }

  /// Bytes held.
  [[nodiscard]] std::size_t MemoryUsage() const;

private:
  FaceNumbers Numbers;
  std::vector<ElementFace> Neighbours;
  std::vector<FaceKind> Kinds;
};
} // namespace pixelexact
