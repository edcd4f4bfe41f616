// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/MeshFile.h"
#include "Formats/Gmsh/Scanner.h"

namespace pixelexact::gmsh
{
/// Where an element belongs.
struct Membership
{
  const std::vector<std::int32_t>& physical;
  std::int32_t entity;
};

/// Sorts a file's elements into those of volumes and of surfaces.
class ElementList
{
public:
  ElementList(MeshFile& mesh, std::size_t count);

  /// Reads an element's nodes. `number` is the file's.
  void Add(Scanner& scanner, int type, std::uint64_t number, const Membership& where);

private:
  void AddSolid(const ElementType& type, std::uint64_t number, const Membership& where);
  void AddSurface(const ElementType& type, const Membership& where);
  [[nodiscard]] bool RepeatsTheLast(const ElementType& type, const Membership& where) const;

  MeshFile& Mesh;
  std::vector<std::int32_t> Nodes; ///< of the element at hand
  std::int32_t Repeated = -1;      ///< the last element known to be in several groups
};
} // namespace pixelexact::gmsh
