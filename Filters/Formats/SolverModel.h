// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/OwnedExpansion.h"
#include "Formats/Slab.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// What a solver's own files hold, in the canonical bases, before it is put into VTK's arrays: the
// result of every reader in this folder. Nothing here knows VTK.

namespace pixelexact
{
/// The vertices' places in VTK's linear cells, as LinearCellOf(shape) has them: hexahedron 8, prism
/// 6, pyramid 5, tetrahedron 4. A plane element's vertices are there twice, below and above.
using Corners = std::array<std::int64_t, 8>;

/// A face of an element with an attribute, or in a composite. A face between two elements has it in
/// both; one in several composites is there for each.
struct BoundaryFace
{
  std::int32_t element = 0;
  std::int8_t face = 0; ///< in the numbering of VTK's linear cell with such corners
  std::int32_t attribute = 0;
};

/// Elements or boundary faces that the file gives a name or number of its own.
struct Group
{
  std::int32_t id = 0; ///< attribute or composite number
  std::string name;    ///< empty where the file gives none
  bool boundary = false;
};

struct SolverMesh
{
  OwnedExpansion map; ///< three components, in units of the element
  std::vector<double> centre;
  std::vector<double> size;
  std::vector<double> uncertainty;
  std::vector<std::int64_t> number;    ///< per element: its number in the solver's file
  std::vector<Corners> corners;        ///< per element: vertex numbers of the file, VTK's order
  std::vector<std::int32_t> attribute; ///< per element: material or composite; may be empty
  std::vector<BoundaryFace> boundary;
  std::vector<Group> groups;
  std::optional<Slab> slab; ///< of a plane mesh; none: a solid one
};

struct SolverField
{
  std::string name;
  OwnedExpansion values;
  Mapping mapping = Mapping::Identity;
  std::string basis;       ///< for people: "H1, Gauss-Lobatto nodes", "Modified_A x3"
  bool continuous = false; ///< one value where elements meet, by construction
};

/// A file of a run that left one for each of its processes.
struct ReadPiece
{
  int piece = 0;             ///< counted from 0
  std::int64_t elements = 0; ///< that it holds
};

struct SolverModel
{
  SolverMesh mesh;
  std::vector<SolverField> fields;
  std::optional<double> time;
  /// Numbers of the run by name, such as Nektar++'s parameters: expressions may use them.
  std::map<std::string, double> parameters;
  /// What was noticed in the file that a user should know, one line each.
  std::vector<std::string> notes;
  /// Where some pieces of a run were read and others were not: those that were, in the order of the
  /// elements, and how many there are. Elements are then numbered as if there were no others.
  std::vector<ReadPiece> pieces;
  int piecesOfRun = 0; ///< 0: everything was read
};

// What one process of several takes of a solver's files.

/// One of `count` parts, counted from 0.
struct PieceOf
{
  int piece = 0;
  int count = 1;

  [[nodiscard]] bool IsWhole() const { return count <= 1; }
  /// The first of so many things that are the part's, and the one behind its last: parts follow
  /// each other, so that what they read is in the order of the whole.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> Of(std::int64_t things) const
  {
    return { things * piece / count, things * (piece + 1) / count };
  }
  bool operator==(const PieceOf&) const = default;
};

/// Drops all elements but those of the part, which follow each other in the file; numbers of
/// elements stay those of the file. Of a model without a mesh, fields alone.
void KeepPiece(const PieceOf& part, SolverModel& model);
} // namespace pixelexact
