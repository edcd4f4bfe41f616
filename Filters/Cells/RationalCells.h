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
/// The Bezier cells of a mesh whose weights differ, and the polynomials that replace their rational
/// functions (bases-and-kernels.md). Safe to read from several threads after Convert.
class RationalCells
{
public:
  /// Adds an element with its points in the cell's order.
  void Add(
    int element, const CellBasis& basis, std::span<const vtkIdType> points, vtkDataArray* weights);

  [[nodiscard]] int Count() const { return static_cast<int>(Cells.size()); }
  [[nodiscard]] bool Has(int element) const { return Cells.contains(element); }

  /// Chooses the polynomials for maps and passes each element's change of basis, from the values
  /// that Gather returns, to `use`. `coordinates` are three per point, of which `components` count.
  /// Throws Unsupported, beginning with `describe(element)`, for weights that differ too much.
  void Convert(std::span<const double> coordinates, int components,
    const std::function<std::string(int)>& describe,
    const std::function<void(int, const ChangeOfBasis&)>& use);

  /// Bound of the difference between an element's polynomial and rational map, in world units. 0
  /// for elements that are not rational.
  [[nodiscard]] double Loss(int element) const;
  /// The same bound for one component of values at points, in their units.
  [[nodiscard]] double Loss(
    int element, std::span<const double> values, int components, int component) const;
  /// Writes one component of values at the nodes of the element's polynomial to `out`.
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
  /// The space of the polynomial that has this order in the directions that need it.
  [[nodiscard]] Space SpaceOf(
    const Cell& cell, const rational::RationalElement& element, int order) const;

  std::map<int, Cell> Cells; ///< by element
  std::map<Space, std::unique_ptr<rational::SimplexBasis>> Bases;
  mutable rational::LineTables Tables;
};
} // namespace pixelexact
#endif
