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
/// Puts meshes and grid functions together. Pieces stay as their files have them: the elements of
/// one after those of the other, each with unknowns of its own.
class ModelBuilder
{
public:
  /// Throws InvalidData and Unsupported, naming the piece.
  explicit ModelBuilder(std::vector<MeshPiece> pieces);
  ModelBuilder(const ModelBuilder&) = delete; // the entities refer to the pieces
  ModelBuilder& operator=(const ModelBuilder&) = delete;

  /// A grid function by its file for each piece, with that one's name.
  void AddField(const std::vector<GridFunctionFile>& files, const std::vector<std::string>& names,
    const std::string& name);

  /// Of a piece.
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
  /// What is shown of a piece: the elements of its file, or parts of them.
  [[nodiscard]] const MeshFile& ShownOf(std::size_t piece) const;
  /// `isJoined`: from the pieces of a parallel run.
  void AddNurbs(bool isJoined);
  void AddMap();
  void AddGroups();
  void AddBoundary(std::size_t p, std::int32_t firstElement);

  std::vector<MeshPiece> Pieces;
  std::deque<std::optional<Topology>> Entities; ///< per piece, made when they are asked for
  std::vector<Place> Places;                    ///< per element
  MeshFile Joined;                              ///< the whole of a NURBS mesh's pieces
  std::unique_ptr<NurbsModel> Nurbs;            ///< of a NURBS mesh
};
} // namespace pixelexact::mfem
