// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"
#include "Formats/MFEM/Meshes/Topology.h"
#include "Formats/MFEM/Nurbs/NurbsModel.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact::mfem
{
/// Assembles meshes and grid functions into a model. Pieces keep their files' order: the elements
/// of one follow those of the other, each with its own unknowns.
class ModelBuilder
{
public:
  /// Throws InvalidData and Unsupported, naming the piece.
  explicit ModelBuilder(std::vector<MeshPiece> pieces);
  ModelBuilder(const ModelBuilder&) = delete; // the entities refer to the pieces
  ModelBuilder& operator=(const ModelBuilder&) = delete;

  /// Adds a grid function, given by one file for each piece and that file's name.
  void AddField(const std::vector<GridFunctionFile>& files, const std::vector<std::string>& names,
    const std::string& name);

  /// The number of elements of a piece.
  [[nodiscard]] std::int64_t ElementsOf(std::int32_t piece) const;

  SolverModel Model;

private:
  struct Place
  {
    std::int32_t piece;
    std::int32_t element; ///< in the piece
  };
  struct Source;

  const Topology& EntitiesOf(std::size_t p);
  void RequireNumbers(const std::string& name) const;
  /// The mesh that represents a piece: the elements of its file, or parts of them for NURBS.
  [[nodiscard]] const MeshFile& ShownOf(std::size_t piece) const;
  /// `isJoined`: whether the mesh is joined from the pieces of a parallel run.
  void AddNurbs(bool isJoined);
  void AddMap();
  void AddGroups();
  void AddBoundary(std::size_t p, std::int32_t firstElement);

  std::vector<MeshPiece> Pieces;
  std::deque<std::optional<Topology>> Entities; ///< per piece, created on first use
  std::vector<Place> Places;                    ///< per element
  MeshFile Joined;                              ///< the whole of a NURBS mesh's pieces
  std::unique_ptr<NurbsModel> Nurbs;            ///< of a NURBS mesh
};
} // namespace pixelexact::mfem
