// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/Gmsh/Views.h"
#include "Formats/SolverModel.h"

namespace pixelexact::gmsh
{
/// Bases, each made once, where they stay.
class BasisTable
{
public:
  const ElementBasis& Nodal(const ElementType& type);
  /// Of a view's scheme; null where it has none for the type's shape.
  const ElementBasis* Of(const Scheme& scheme, const ElementType& type);
  const ElementBasis& Constant(Shape shape);

private:
  std::map<int, ElementBasis> ByType;
  std::map<std::pair<const Scheme*, std::pair<int, Shape>>, ElementBasis> ByScheme;
  std::map<Shape, ElementBasis> Constants;
};

/// Adds the field that a view is at a step. A view of a single step has it at all; one that has
/// others, but not this, is left out with a note.
void AddView(std::vector<Scanner>& scanners, const View& view, std::int64_t step,
  const MeshFile& mesh, BasisTable& bases, SolverModel& model);
} // namespace pixelexact::gmsh
