// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/Collection.h"
#include "Formats/MFEM/Text/GridFunctionFile.h"
#include "Formats/SolverModel.h"

#include <array>
#include <memory>
#include <optional>
#include <set>

namespace pixelexact::mfem
{
struct NurbsMesh;

struct Cell
{
  Geometry geometry = Geometry::Point;
  int attribute = 0;
  std::array<int, 8> vertices{};
};

/// What an MFEM mesh file holds, as numbered by MFEM once it has read it.
struct MeshFile
{
  int dimension = 3;          ///< of the elements, 2 or 3
  std::vector<Cell> elements; ///< leaves of the refinement, in MFEM's order
  std::vector<Cell> boundary;
  int vertices = 0;
  std::vector<double> coordinates; ///< three per vertex, z = 0 in a plane; empty: there are nodes
  std::optional<GridFunctionFile> nodes;
  std::vector<Group> groups;
  bool isNumbered = true; ///< as MFEM numbers it: grid functions need that
  std::set<int> sharing;  ///< processes that a piece shares something with, and its own
  int ranks = 1; ///< processes that a piece of a parallel mesh tells of, at least; 1: it is none
  /// Of a NURBS mesh: the elements are its knot spans, the nodes its control points. A piece of a
  /// parallel one has elements only after JoinNurbs.
  std::shared_ptr<const NurbsMesh> nurbs;
};

/// A mesh, or what one process of a parallel run has of it, with its file's name for messages.
struct MeshPiece
{
  MeshFile file;
  std::string name;
};

/// An element or a boundary element, of `dimension` 1 to 3: attribute, geometry, vertices below
/// `vertices`.
Cell ReadCell(TextScanner& scanner, int vertices, int dimension);

/// Whether elements of that dimension are of this kind.
bool IsOfDimension(Geometry geometry, int dimension);
} // namespace pixelexact::mfem
