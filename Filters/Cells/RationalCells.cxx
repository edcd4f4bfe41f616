// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/RationalCells.h"

#include "Core/Base/Error.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace pixelexact
{
namespace
{
/// Target loss of a map, relative to the element's size. NURBS meshes have the same target
/// (bases-and-kernels.md), but here a cell is always one element.
constexpr double kLoss = 1e-14;
/// A loss below this ends the search for an order. Rounding in tetrahedra is larger than in
/// products.
constexpr double kEnough = 1e-13;
constexpr double kEnoughOfTetrahedra = 1e-12;
/// Largest loss that is accepted at the highest order, relative to the element's size.
constexpr double kMaxLoss = 1e-9;
constexpr int kMaxRationalOrder = kMaxOrder - 2;
/// Limit for tetrahedra, whose change of basis is dense.
constexpr int kMaxTetrahedronOrder = 16;

rational::Orders DegreesOf(const Space& space)
{
  return { space.order[0], space.order[1], space.order[2] };
}
} // namespace

void RationalCells::Add(
  int element, const CellBasis& basis, std::span<const vtkIdType> points, vtkDataArray* weights)
{
  Cell cell{ basis.GetSpace(), {}, {} };
  for (const int position : basis.control)
  {
    cell.points.push_back(points[static_cast<std::size_t>(position)]);
    cell.weights.push_back(weights->GetComponent(cell.points.back(), 0));
  }
  Cells.emplace(element, std::move(cell));
}

const rational::SimplexBasis& RationalCells::BasisOf(const Space& space)
{
  auto& basis = Bases[space];
  if (!basis)
  {
    basis = std::make_unique<rational::SimplexBasis>(space);
  }
  return *basis;
}

Space RationalCells::SpaceOf(
  const Cell& cell, const rational::RationalElement& element, int order) const
{
  Space space = cell.space;
  std::array<bool, 3> varies{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    varies[d] = rational::VariesAlong(element, d);
  }
  if (cell.IsSimplex())
  {
    // Triangles have the same order in both directions.
    varies[0] = varies[2] = varies[0] || varies[2] || space.shape == Shape::Tetrahedron;
    varies[1] = varies[1] || space.shape == Shape::Tetrahedron;
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    space.order[d] =
      varies[d] ? static_cast<std::uint8_t>(std::max<int>(order, space.order[d])) : space.order[d];
  }
  return space;
}

/// Directions in which weights vary get one order for all cells, other directions the cell's
/// degree, so that neighbouring cells agree on their common face.
void RationalCells::Convert(std::span<const double> coordinates, int components,
  const std::function<std::string(int)>& describe,
  const std::function<void(int, const ChangeOfBasis&)>& use)
{
  const std::array<int, 3> all{ 0, 1, 2 };
  const std::span<const int> which(all.data(), static_cast<std::size_t>(components));
  const auto isTetrahedron = [](const auto& entry)
  { return entry.second.space.shape == Shape::Tetrahedron; };
  const int most =
    std::ranges::any_of(Cells, isTetrahedron) ? kMaxTetrahedronOrder : kMaxRationalOrder;
  int order = 0;
  for (const auto& [e, cell] : Cells)
  {
    const rational::RationalElement element = ElementOf(cell, coordinates, 3, which);
    const rational::OrderEstimate estimate =
      rational::EstimateOrders(element, kLoss * ExtentOf(element), most, Tables);
    order = std::max(order, estimate.order ? *std::ranges::max_element(*estimate.order) : most);
  }
  for (bool isEnough = false; !isEnough; ++order)
  {
    isEnough = true;
    for (auto& [e, cell] : Cells)
    {
      const rational::RationalElement element = ElementOf(cell, coordinates, 3, which);
      cell.polynomial = SpaceOf(cell, element, order);
      if (cell.IsSimplex())
      {
        BasisOf(cell.polynomial);
      }
      cell.loss = LossOf(cell, element);
      const double extent = ExtentOf(element);
      if (cell.loss > kMaxLoss * extent && order >= most)
      {
        throw Unsupported(describe(e) +
          " has rational weights that differ so much that polynomials of order " +
          std::to_string(most) + " do not come near it; divide the cell.");
      }
      // The order was estimated in eta. A complete space may need a higher one.
      const double enough = cell.space.shape == Shape::Tetrahedron ? kEnoughOfTetrahedra : kEnough;
      isEnough = isEnough && (!cell.IsSimplex() || order >= most || cell.loss <= enough * extent);
    }
  }
  std::map<Space, ChangeOfBasis> products;
  for (const auto& [e, cell] : Cells)
  {
    if (cell.IsSimplex())
    {
      use(e, Bases.at(cell.polynomial)->GetChange());
      continue;
    }
    auto at = products.find(cell.polynomial);
    if (at == products.end())
    {
      std::vector<int> source(static_cast<std::size_t>(cell.polynomial.Modes()));
      std::iota(source.begin(), source.end(), 0);
      at = products
             .emplace(cell.polynomial,
               ChangeOfBasis::Hexahedron(cell.polynomial, Family::GaussLobattoLagrange, source))
             .first;
    }
    use(e, at->second);
  }
}

rational::RationalElement RationalCells::ElementOf(const Cell& cell, std::span<const double> values,
  int components, std::span<const int> which) const
{
  const auto valueAt = [&](std::size_t i, int component)
  {
    return static_cast<long double>(
      values[static_cast<std::size_t>(cell.points[i]) * static_cast<std::size_t>(components) +
        static_cast<std::size_t>(component)]);
  };
  const auto onCube = [&cell](std::vector<long double> control)
  { return cell.IsSimplex() ? rational::Collapse(cell.space, control) : control; };
  const std::vector<long double> weights(cell.weights.begin(), cell.weights.end());
  rational::RationalElement made;
  made.degree = DegreesOf(cell.space);
  made.weights = onCube(weights);
  std::vector<long double> numerators(weights.size());
  for (const int component : which)
  {
    made.shift.push_back(valueAt(0, component));
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      numerators[i] = weights[i] * (valueAt(i, component) - made.shift.back());
    }
    const std::vector<long double> own = onCube(numerators);
    made.numerators.insert(made.numerators.end(), own.begin(), own.end());
  }
  return made;
}

double RationalCells::LossOf(const Cell& cell, const rational::RationalElement& element) const
{
  return cell.IsSimplex() ? Bases.at(cell.polynomial)->LossOf(element, Tables)
                          : rational::LossOf(element, DegreesOf(cell.polynomial), Tables);
}

double RationalCells::Loss(int element) const
{
  const auto found = Cells.find(element);
  return found == Cells.end() ? 0.0 : found->second.loss;
}

double RationalCells::Loss(
  int element, std::span<const double> values, int components, int component) const
{
  const auto found = Cells.find(element);
  return found == Cells.end()
    ? 0.0
    : LossOf(found->second, ElementOf(found->second, values, components, { &component, 1 }));
}

void RationalCells::Gather(int element, std::span<const double> values, int components,
  int component, std::vector<double>& out) const
{
  const Cell& cell = Cells.at(element);
  const rational::RationalElement made = ElementOf(cell, values, components, { &component, 1 });
  out.resize(static_cast<std::size_t>(cell.polynomial.Modes()));
  if (cell.IsSimplex())
  {
    Bases.at(cell.polynomial)->NodeValues(made, out);
    return;
  }
  rational::NodeValues(made, DegreesOf(cell.polynomial), Tables, out);
}
} // namespace pixelexact
