// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/Topology.h"
#include "Formats/MFEM/Nurbs/NurbsPieces.h"

#include <functional>
#include <map>
#include <optional>

namespace pixelexact::mfem
{
/// Rational maps and fields of a NURBS mesh as polynomials, on parts of its knot spans where these
/// are too long for that (bases-and-kernels.md).
class NurbsModel
{
public:
  /// What polynomials lose at most, relative to an element's size or a field's range, unless their
  /// orders or the parts would be too many; notes tell what they do lose.
  static constexpr double kLoss = 1e-14;
  /// Of a knot span, in all.
  static constexpr int kMaxParts = 64;

  /// Divides knot spans as NURBS nodes need it, which are of the file or, one by one, of its
  /// pieces; none where the nodes are others. `names`: of the file or its pieces. The file outlives
  /// it. Throws InvalidData and Unsupported, naming the file.
  NurbsModel(const MeshFile& file, std::span<const GridFunctionFile> nodes,
    std::span<const std::string> names);

  /// The parts, as a mesh: elements, boundary elements and vertices.
  [[nodiscard]] const MeshFile& Shown() const { return Drawn; }
  [[nodiscard]] const Topology& Entities() const { return *DrawnEntities; }
  /// Of each of its elements.
  [[nodiscard]] const std::vector<rational::ElementPart>& Parts() const { return PartList; }
  /// Whether the nodes are NURBS.
  [[nodiscard]] bool HasMap() const { return Map.has_value(); }
  /// The map through the nodes, which are NURBS; what is lost is added to the uncertainty.
  void AddMap(SolverModel& model);
  /// A NURBS grid function, by its file or those of all pieces.
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
    bool isPolynomial = true;               ///< nothing is lost
  };
  /// Orders for each knot vector, so that parts that meet agree. `target`: of each part.
  Bases BasesOf(
    const Function& function, int most, const std::function<double(std::size_t)>& target);

  /// Children spans until each part needs no order above `most`. False: there are too many parts.
  bool Divide(const Function& function, int most);
  /// Into how many parts a span is divided at most.
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
