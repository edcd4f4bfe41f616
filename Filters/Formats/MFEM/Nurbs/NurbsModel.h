// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/Topology.h"
#include "Formats/MFEM/Nurbs/NurbsPieces.h"

#include <functional>
#include <map>
#include <optional>

namespace pixelexact::mfem
{
/// Converts rational maps and fields of a NURBS mesh to polynomials, on parts of its knot spans
/// where whole spans need too high an order (bases-and-kernels.md).
class NurbsModel
{
public:
  /// Largest loss of polynomials, relative to an element's size or a field's range, unless orders
  /// or the number of parts would be too high. Notes then state the actual loss.
  static constexpr double kLoss = 1e-14;
  /// Largest number of parts of one knot span.
  static constexpr int kMaxParts = 64;

  /// Divides knot spans as the NURBS nodes require. `nodes` come from the file or, one by one, from
  /// its pieces; they are empty where the nodes are not NURBS. `names`: of the file or its pieces.
  /// The file must outlive this object. Throws InvalidData and Unsupported, naming the file.
  NurbsModel(const MeshFile& file, std::span<const GridFunctionFile> nodes,
    std::span<const std::string> names);

  /// The parts as a mesh: elements, boundary elements and vertices.
  [[nodiscard]] const MeshFile& Shown() const { return Drawn; }
  [[nodiscard]] const Topology& Entities() const { return *DrawnEntities; }
  /// The part of a knot span for each element of Shown().
  [[nodiscard]] const std::vector<rational::ElementPart>& Parts() const { return PartList; }
  /// Whether the nodes are NURBS.
  [[nodiscard]] bool HasMap() const { return Map.has_value(); }
  /// Adds the map through the NURBS nodes; its loss is added to the uncertainty.
  void AddMap(SolverModel& model);
  /// Adds a NURBS grid function, given by its file or those of all pieces.
  void AddField(std::span<const GridFunctionFile> files, std::span<const std::string> names,
    const std::string& name, SolverModel& model);

private:
  /// A function on all parts.
  struct Function
  {
    PiecedFunction data; ///< one piece with all control points where the file holds all
    int components = 0;
  };
  [[nodiscard]] Function FunctionOf(
    std::span<const GridFunctionFile> files, std::span<const std::string> names) const;
  [[nodiscard]] rational::RationalElement ElementOf(
    const Function& function, std::size_t part) const;

  struct Bases
  {
    std::vector<rational::Orders> order;    ///< per part
    std::vector<const ElementBasis*> basis; ///< per part
    std::vector<double> loss;               ///< per part
    bool isPolynomial = true;               ///< the function has no loss
  };
  /// Chooses orders for each knot vector, so that parts that meet agree. `target`: the accepted
  /// loss on each part.
  Bases BasesOf(
    const Function& function, int most, const std::function<double(std::size_t)>& target);

  /// Divides spans until no part needs an order above `most`. False where there are too many parts.
  bool Divide(const Function& function, int most);
  /// Limit of parts of one span.
  [[nodiscard]] int MostPartsOfSpan() const;
  void MakeParts();

  const MeshFile& File;
  const NurbsMesh& Mesh;
  std::string Name;
  std::vector<int> PieceOf;                  ///< per element; empty: there are no pieces
  std::vector<std::vector<int>> PartsOfSpan; ///< per knot vector and span
  std::vector<rational::ElementPart> PartList;
  MeshFile Drawn;
  std::optional<Topology> DrawnEntities;
  std::optional<Function> Map; ///< where the nodes are NURBS
  std::vector<double> Extent;  ///< per knot span, of its control points
  int MapOrder = 0;            ///< at most
  rational::LineTables Tables;
  std::map<Space, ElementBasis> KnownBases;
};
} // namespace pixelexact::mfem
