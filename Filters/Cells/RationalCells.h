// SPDX-License-Identifier: BSD-3-Clause
#ifndef RationalCells_h
#define RationalCells_h

#include "Cells/CellBasis.h"

#include "Formats/Rational/SimplexElement.h"

#include "vtkType.h"

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

class vtkDataArray;

namespace pixelexact
{
/// The Bezier cells of a mesh whose weights differ, and the polynomials in their place
/// (bases-and-kernels.md). Safe to read from several threads once converted.
class RationalCells
{
public:
  /// An element, with its points in the cell's order.
  void Add(
    int element, const CellBasis& basis, std::span<const vtkIdType> points, vtkDataArray* weights);

  [[nodiscard]] int Count() const { return static_cast<int>(Cells.size()); }
  [[nodiscard]] bool Has(int element) const { return Cells.contains(element); }

  /// Chooses the polynomials for maps, three coordinates per point, of which `components` count,
  /// and tells each element's change of basis from what Gather gives. Throws Unsupported, beginning
  /// with `describe(element)`, for weights that differ too much.
  void Convert(std::span<const double> coordinates, int components,
    const std::function<std::string(int)>& describe,
    const std::function<void(int, const ChangeOfBasis&)>& use);

  /// What a map loses, in world units; 0 for elements that are not rational.
  [[nodiscard]] double Loss(int element) const;
  /// The same of a component of values at points.
  [[nodiscard]] double Loss(
    int element, std::span<const double> values, int components, int component) const;
  /// A component of values, at the nodes of the polynomial.
  void Gather(int element, std::span<const double> values, int components, int component,
    std::vector<double>& out) const;

private:
  struct Cell
  {
    Space space;                   ///< of the file's functions
    std::vector<vtkIdType> points; ///< of the control points, in the order of CellBasis::control
    std::vector<double> weights;
    Space polynomial{};
    double loss = 0.0;

    [[nodiscard]] bool IsSimplex() const { return space.shape != Shape::Hexahedron; }
  };
  [[nodiscard]] rational::RationalElement ElementOf(const Cell& cell,
    std::span<const double> values, int components, std::span<const int> which) const;
  [[nodiscard]] double LossOf(const Cell& cell, const rational::RationalElement& element) const;
  const rational::SimplexBasis& BasisOf(const Space& space);
  /// Of the polynomial where its directions that need it have this order.
  [[nodiscard]] Space SpaceOf(
    const Cell& cell, const rational::RationalElement& element, int order) const;

  std::map<int, Cell> Cells; ///< by element
  std::map<Space, std::unique_ptr<rational::SimplexBasis>> Bases;
  mutable rational::LineTables Tables;
};
} // namespace pixelexact
#endif
