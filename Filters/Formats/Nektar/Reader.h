// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/SolverModel.h"

namespace pixelexact::nektar
{
/// A Nektar++ mesh from the session files' GEOMETRY, with the fields of the parts of one field
/// file. Several files with a GEOMETRY are the parts of one mesh; the others may hold the rest of
/// the session. Throws InvalidData or Unsupported: "<file>, <tag> <id>: what; remedy".
SolverModel Read(const std::vector<NamedText>& sessions, const std::vector<NamedText>& fieldParts);

// The same in two steps, for several field files on one mesh.

struct SessionMesh
{
  SolverModel model; ///< without fields
  std::string name;  ///< of the file that holds the mesh, for messages
  /// A one-dimensional mesh, as a strip of a plane until its fields make it one of solids.
  bool isLine = false;
  std::optional<double> stripDistance; ///< the parameter DistStrip
};
SessionMesh ReadMesh(const std::vector<NamedText>& sessions);

/// Throws Unsupported for a mesh that is none without fields, a one-dimensional one.
void RequireFields(const SessionMesh& mesh);

/// The data of a mesh that AddFields needs after its coefficients were moved; for a two-dimensional
/// mesh all of it, for homogeneous fields.
SessionMesh OutlineOf(const SessionMesh& mesh);

/// Adds the fields of a field file's parts, and their time. Throws InvalidData where the parts do
/// not give every element its coefficients once.
void AddFields(const std::vector<NamedText>& parts, SessionMesh& session);
} // namespace pixelexact::nektar
