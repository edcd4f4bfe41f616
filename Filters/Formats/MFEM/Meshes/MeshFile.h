// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/Collection.h"
#include "Formats/MFEM/Text/GridFunctionFile.h"
#include "Formats/MFEM/Text/TextScanner.h"
#include "Formats/SolverModel.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

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

/// How MFEM numbers the vertices of an edge or a face in its element.
struct LocalFace
{
  Geometry geometry;           ///< Triangle or Square
  std::array<int, 4> vertices; ///< the fourth is -1 for triangles
  std::int8_t vtkFace;         ///< the same face in VTK's linear cell
};

struct GeometryTable
{
  int vertices = 0;
  std::span<const std::array<int, 2>> edges;
  std::span<const LocalFace> faces;
  /// Of plane elements: the faces behind their edges in VTK's linear cell of the slab.
  std::span<const std::int8_t> sides{};
};

/// The table of a solid or plane element, or of a segment, which has vertices only.
const GeometryTable& TableOf(Geometry geometry);

// What a mesh file's first lines tell of it, and what is refused of whole files.

enum class MeshFormat : std::uint8_t
{
  Conforming,
  Legacy, ///< v1.1: numbered as it stands
  Inline, ///< a box, by its numbers
  Nonconforming,
  NonconformingScaled, ///< NC v1.1: vertices anywhere between their parents
  Nurbs,
  NurbsSpaced ///< NURBS v1.1: says how to refine, too
};

/// Reads the first line. Throws Unsupported for kinds and versions that are not read, InvalidData
/// for what is no MFEM mesh.
MeshFormat ReadMeshFormat(TextScanner& scanner);

/// Reads the dimension of the elements, 2 or 3; throws Unsupported for others.
int ReadDimension(TextScanner& scanner);

/// Reads the dimension of the vertices' space, not below the elements'; throws as ReadDimension.
int ReadSpaceDimension(TextScanner& scanner, int dimension);

/// Throws InvalidData: the file holds a piece of the mesh of so many processes, of which so many
/// are read.
[[noreturn]] void RefusePiece(const TextScanner& scanner, int processes, int pieces);

/// Reads the sections of a mesh of version 1.0 to 1.3, whose elements are its leaves. Vertices that
/// no element has are dropped, but in `legacy` files. Throws InvalidData.
MeshFile ReadConforming(TextScanner& scanner, bool legacy);

/// Reads what follows "MFEM INLINE": "type = quad", "nx = 4", "sx = 1.0" and so on, and makes the
/// box of squares, triangles, cubes, prisms, pyramids or tetrahedra that MFEM makes, with its
/// attributes. MFEM numbers squares and cubes along a space-filling curve, here they are in rows:
/// the mesh is not `isNumbered`. Throws InvalidData, and Unsupported for segments.
MeshFile ReadInline(TextScanner& scanner);

/// Reads the body of an "MFEM NC mesh": the forest of refined elements, whose leaves are the
/// elements. They are put in MFEM's order (along space-filling curves in fully refined cubes), and
/// so are the vertices: those of the coarsest level first. `scaled`: version 1.1, whose vertices
/// need not halve their parents' edge.
MeshFile ReadNonconforming(TextScanner& scanner, bool scaled);
} // namespace pixelexact::mfem
