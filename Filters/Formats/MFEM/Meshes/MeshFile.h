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

/// The contents of an MFEM mesh file, numbered as MFEM numbers them after reading.
struct MeshFile
{
  int dimension = 3;          ///< of the elements, 2 or 3
  std::vector<Cell> elements; ///< leaves of the refinement, in MFEM's order
  std::vector<Cell> boundary;
  int vertices = 0;
  std::vector<double> coordinates; ///< three per vertex, z = 0 in a plane; empty: see nodes
  std::optional<GridFunctionFile> nodes;
  std::vector<Group> groups;
  bool isNumbered = true; ///< numbered as in MFEM, which grid functions need
  std::set<int> sharing;  ///< processes that share entities with a piece, and its own
  int ranks = 1;          ///< least number of processes of a parallel mesh; 1: not a piece of one
  /// Set for a NURBS mesh: its elements are knot spans, its nodes control points. A piece of a
  /// parallel NURBS mesh has elements only after JoinNurbs.
  std::shared_ptr<const NurbsMesh> nurbs;
};

/// A mesh or one process' piece of it, with its file's name for messages.
struct MeshPiece
{
  MeshFile file;
  std::string name;
};

/// More vertices are refused: their numbers are ints.
inline constexpr int kMaxVertices = 1 << 30;

/// Reads an element or a boundary element of `dimension` 1 to 3: attribute, geometry, and vertices,
/// which must be below `vertices`.
Cell ReadCell(TextScanner& scanner, int vertices, int dimension);

/// Whether elements of that dimension may have this geometry.
bool IsOfDimension(Geometry geometry, int dimension);

/// MFEM's numbering of the vertices of an edge or a face in its element.
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
  /// For plane elements: the faces of VTK's linear cell of the slab that correspond to their edges.
  std::span<const std::int8_t> sides{};
};

/// The table of a solid or plane element, or of a segment, which has vertices only.
const GeometryTable& TableOf(Geometry geometry);

// Kinds of mesh files by their first lines, and checks of whole files.

enum class MeshFormat : std::uint8_t
{
  Conforming,
  Legacy, ///< v1.1: numbered in the order of the file
  Inline, ///< a box, given by its numbers of cells
  Nonconforming,
  NonconformingScaled, ///< NC v1.1: vertices anywhere between their parents
  Nurbs,
  NurbsSpaced ///< NURBS v1.1: also contains spacings for refinement
};

/// Reads the first line. Throws Unsupported for kinds and versions that are not supported,
/// InvalidData where the file is not an MFEM mesh.
MeshFormat ReadMeshFormat(TextScanner& scanner);

/// Reads the dimension of the elements, 2 or 3; throws Unsupported for others.
int ReadDimension(TextScanner& scanner);

/// Reads the dimension of the vertices' space, not below the elements'; throws as ReadDimension.
int ReadSpaceDimension(TextScanner& scanner, int dimension);

/// Throws InvalidData: the file is a piece of a mesh of `processes` processes, of which only
/// `pieces` are read.
[[noreturn]] void RefusePiece(const TextScanner& scanner, int processes, int pieces);

/// Reads the sections of a mesh of version 1.0 to 1.3, whose elements are its leaves. Removes
/// vertices that no element has, except in `legacy` files. Throws InvalidData.
MeshFile ReadConforming(TextScanner& scanner, bool legacy);

/// Reads what follows "MFEM INLINE" ("type = quad", "nx = 4", "sx = 1.0" and so on) and creates the
/// same box of squares, triangles, cubes, prisms, pyramids or tetrahedra as MFEM, with its
/// attributes. MFEM numbers squares and cubes along a space-filling curve; here they are in rows,
/// so the mesh is not `isNumbered`. Throws InvalidData, and Unsupported for segments.
MeshFile ReadInline(TextScanner& scanner);

/// Reads the body of an "MFEM NC mesh": the forest of refined elements, whose leaves are the
/// elements. Elements are in MFEM's order (along space-filling curves in fully refined cubes), and
/// so are the vertices: those of the coarsest level first. `scaled`: version 1.1, whose vertices
/// need not be at the middles of their parents' edges.
MeshFile ReadNonconforming(TextScanner& scanner, bool scaled);
} // namespace pixelexact::mfem
