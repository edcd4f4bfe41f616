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

// The contents of a solver's files, in the canonical bases, before conversion to VTK's arrays: the
// result of every reader in this folder. This code does not depend on VTK.

namespace pixelexact
{
/// The vertices of VTK's linear cells, as in LinearCellOf(shape): hexahedron 8, prism 6, pyramid 5,
/// tetrahedron 4. Those of a plane element occur twice, below and above.
using Corners = std::array<std::int64_t, 8>;

/// A face of an element with an attribute, or in a composite. A face between two elements is listed
/// for both, and one in several composites for each.
struct BoundaryFace
{
  std::int32_t element = 0;
  std::int8_t face = 0; ///< in the numbering of VTK's linear cell with such corners
  std::int32_t attribute = 0;
};

/// Elements or boundary faces with a name or number in the file.
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
  bool continuous = false; ///< values agree where elements meet, by construction
};

/// A file of a run that wrote one file for each of its processes.
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
  /// Notes on the file for the user, one line each.
  std::vector<std::string> notes;
  /// Where only some pieces of a run were read: those pieces, in the order of the elements.
  /// Elements are numbered as if there were no other pieces.
  std::vector<ReadPiece> pieces;
  int piecesOfRun = 0; ///< number of pieces of the run; 0: everything was read
};

// The share of one process in a solver's files.

/// One of `count` parts, counted from 0.
struct PieceOf
{
  int piece = 0;
  int count = 1;

  [[nodiscard]] bool IsWhole() const { return count <= 1; }
  /// The first of `things` items in the part and the end of its range. Ranges are consecutive, so
  /// that parts keep the order of the whole.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> Of(std::int64_t things) const
  {
    return { things * piece / count, things * (piece + 1) / count };
  }
  bool operator==(const PieceOf&) const = default;
};

/// Drops all elements except those of the part, which are consecutive in the file. Numbers of
/// elements stay those of the file. For a model without a mesh only fields are cut.
void KeepPiece(const PieceOf& part, SolverModel& model);
} // namespace pixelexact
