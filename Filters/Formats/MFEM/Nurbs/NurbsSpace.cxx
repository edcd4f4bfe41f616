// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/NurbsSpace.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Basis/Space.h"
#include "Formats/MFEM/Nurbs/NurbsMesh.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace pixelexact::mfem
{
namespace
{
/// The orders in a collection's name or its sections: one for all, or one for each knot vector;
/// empty: the mesh's own space.
std::vector<int> OrdersOf(const NurbsMesh& mesh, const GridFunctionFile& file)
{
  if (file.nurbs)
  {
    if (file.nurbs->orders.empty())
    {
      throw InvalidData("the space has sections of NURBS, but no NURBS_order; it is damaged.");
    }
    return file.nurbs->orders;
  }
  const std::string digits = file.collection.substr(std::string("NURBS").size());
  if (digits.empty())
  {
    return {};
  }
  int order = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), order);
  if (error != std::errc() || end != digits.data() + digits.size() || order < 1)
  {
    throw Unsupported(file.collection +
      " is not read: of NURBS spaces those with scalar functions are (NURBS, NURBS2); project the "
      "grid function onto one of them, or onto L2.");
  }
  if (order > kMaxOrder)
  {
    throw Unsupported(file.collection + ": orders to " + std::to_string(kMaxOrder) + " are read.");
  }
  const bool isMeshs = std::ranges::all_of(
    mesh.vectors, [order](const KnotVector& vector) { return vector.degree == order; });
  return isMeshs ? std::vector<int>() : std::vector<int>{ order };
}

std::vector<int> CountsOf(const std::vector<KnotVector>& vectors)
{
  std::vector<int> counts;
  std::ranges::transform(
    vectors, std::back_inserter(counts), [](const KnotVector& v) { return v.Points(); });
  return counts;
}
} // namespace

NurbsSpace::NurbsSpace(const NurbsMesh& mesh, const GridFunctionFile& file)
  : Mesh(mesh)
  , Vectors(mesh.vectors)
{
  const std::vector<int> orders = OrdersOf(mesh, file);
  if (orders.size() > 1 && orders.size() != Vectors.size())
  {
    throw InvalidData("the space has " + Counted(orders.size(), "order") + ", but the mesh has " +
      Counted(Vectors.size(), "knot vector") + "; it belongs to another mesh.");
  }
  for (std::size_t v = 0; v < Vectors.size() && !orders.empty(); ++v)
  {
    const int order = orders[orders.size() == 1 ? 0 : v];
    Vectors[v] = order > Vectors[v].degree ? Vectors[v].Elevated(order) : Vectors[v];
  }
  for (const KnotVector& vector : Vectors)
  {
    Flipped.push_back(vector.Flipped());
    Spans.push_back(vector.Spans());
    FlippedSpans.push_back(Flipped.back().Spans());
  }
  const PatchNumbering numbering(mesh.topology, CountsOf(Vectors));
  Points = numbering.Size();
  const auto values = static_cast<std::int64_t>(file.values.size());
  if (Points > std::min(kMaxControlPoints, kMaxIdentified * (values + 1)))
  {
    throw InvalidData("the space has " + std::to_string(Points) +
      " control points, but there are " + std::to_string(values) +
      " values; the file is cut short, or belongs to another mesh.");
  }
  for (std::size_t p = 0; p < mesh.topology.patches.size(); ++p)
  {
    Grids.push_back(numbering.GridOf(p));
  }
  const bool isOwn = file.nurbs && !file.nurbs->masters.empty();
  Weights = orders.empty() ? mesh.weights
    : file.nurbs           ? file.nurbs->weights
                           : std::vector<double>();
  Identify(isOwn ? file.nurbs->masters : mesh.masters, isOwn ? file.nurbs->slaves : mesh.slaves,
    numbering);
  RequireWeights();
}

void NurbsSpace::RequireWeights() const
{
  if (!Weights.empty() && static_cast<std::int64_t>(Weights.size()) < Points)
  {
    throw InvalidData("the space has " + Counted(Weights.size(), "weight") + " for " +
      Counted(Points, "control point") + "; it is damaged, or belongs to another mesh.");
  }
  for (const double weight : Weights)
  {
    if (!(weight > 0.0) || !std::isfinite(weight))
    {
      throw InvalidData(
        "the space has a weight that is not positive; refit it with positive ones.");
    }
  }
}

bool NurbsSpace::IsContinuous() const
{
  return std::ranges::all_of(Vectors, [](const KnotVector& v) { return v.IsContinuous(); });
}

std::string NurbsSpace::Description() const
{
  int low = kMaxOrder;
  int high = 0;
  for (const KnotVector& vector : Vectors)
  {
    low = std::min(low, vector.degree);
    high = std::max(high, vector.degree);
  }
  return low == high ? "NURBS of order " + std::to_string(low)
                     : "NURBS of orders " + std::to_string(low) + " to " + std::to_string(high);
}

template <class Visit>
void NurbsSpace::ForSpans(const PatchNumbering::Boundary& boundary, Visit&& visit) const
{
  struct Line
  {
    std::vector<int> spans{ 0 };
    int degree = 0;
  };
  std::array<Line, 2> lines;
  for (std::size_t k = 0; k < 2 && boundary.vectors.at(k) >= 0; ++k)
  {
    const auto vector = static_cast<std::size_t>(boundary.vectors.at(k));
    lines.at(k) = { Spans[vector], Vectors[vector].degree };
  }
  for (const int j : lines[1].spans)
  {
    for (const int i : lines[0].spans)
    {
      for (int jj = 0; jj <= lines[1].degree; ++jj)
      {
        for (int ii = 0; ii <= lines[0].degree; ++ii)
        {
          visit(static_cast<std::size_t>(j + jj) * boundary.counts[0] + (i + ii));
        }
      }
    }
  }
}

/// As in MFEM, pairs of boundaries are the last ones with their attributes, and are traversed along
/// their knot vectors in parallel.
void NurbsSpace::Identify(
  const std::vector<int>& masters, const std::vector<int>& slaves, const PatchNumbering& numbering)
{
  if (masters.size() != slaves.size())
  {
    throw InvalidData("the lists of identified boundaries are not equally long.");
  }
  if (masters.empty())
  {
    return;
  }
  std::vector<int> numbers(static_cast<std::size_t>(Points));
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto gridOf = [&](int attribute)
  {
    const auto& boundary = Mesh.topology.boundary;
    const auto found = std::find_if(boundary.rbegin(), boundary.rend(),
      [attribute](const Cell& cell) { return cell.attribute == attribute; });
    if (found == boundary.rend())
    {
      throw InvalidData("boundary " + std::to_string(attribute) +
        " is to be identified with another one, but there is none with this attribute.");
    }
    return numbering.BoundaryOf(static_cast<std::size_t>(boundary.rend() - found) - 1);
  };
  for (std::size_t i = 0; i < masters.size(); ++i)
  {
    const PatchNumbering::Boundary master = gridOf(masters[i]);
    const PatchNumbering::Boundary slave = gridOf(slaves[i]);
    if (master.counts != slave.counts)
    {
      throw InvalidData("boundaries " + std::to_string(masters[i]) + " and " +
        std::to_string(slaves[i]) + " are identified, but have " +
        Counted(master.grid.size(), "control point") + " and " + std::to_string(slave.grid.size()) +
        ", or as many in other directions.");
    }
    // Span by span: where the two have an edge in common, the order counts.
    ForSpans(master,
      [&](std::size_t k)
      {
        numbers[static_cast<std::size_t>(master.grid[k])] =
          numbers[static_cast<std::size_t>(slave.grid[k])];
      });
  }
  std::vector<int> used = numbers;
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Points = static_cast<std::int64_t>(used.size());
  for (auto& grid : Grids)
  {
    for (int& number : grid)
    {
      const int kept = numbers[static_cast<std::size_t>(number)];
      number = static_cast<int>(std::ranges::lower_bound(used, kept) - used.begin());
    }
  }
}

const KnotVector& NurbsSpace::Along(std::size_t patch, int direction) const
{
  const PatchTopology::Line& line = Mesh.topology.lines[patch].at(direction);
  return (line.isReversed ? Flipped : Vectors)[static_cast<std::size_t>(line.vector)];
}

std::vector<double> NurbsSpace::ValuesOf(const GridFunctionFile& file) const
{
  const auto components = static_cast<std::size_t>(file.components);
  const auto size = static_cast<std::size_t>(Points);
  std::size_t expected = size * components;
  if (file.byPatches)
  {
    expected = 0;
    for (const auto& grid : Grids)
    {
      expected += grid.size() * components;
    }
  }
  if (file.values.size() != expected)
  {
    throw InvalidData("there are " + Counted(file.values.size(), "value") + ", but " +
      file.collection + " with VDim " + std::to_string(file.components) + " on this mesh of " +
      Counted(Mesh.topology.patches.size(), "NURBS patch") + "es has " + std::to_string(expected) +
      "; the file is cut short, or belongs to another mesh.");
  }
  std::vector<double> values(size * components);
  if (file.byPatches)
  {
    auto from = file.values.begin();
    for (const auto& grid : Grids)
    {
      for (const int number : grid)
      {
        std::copy_n(from, components, &values[static_cast<std::size_t>(number) * components]);
        from += static_cast<std::ptrdiff_t>(components);
      }
    }
    return values;
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      values[i * components + c] = file.values[file.byNodes ? c * size + i : i * components + c];
    }
  }
  return values;
}

std::vector<std::size_t> NurbsSpace::PointsAt(
  const GridPlace& place, std::array<int, 3>& first) const
{
  std::array<int, 3> degree{};
  std::array<int, 3> points{ 1, 1, 1 };
  for (int d = 0; d < Mesh.topology.dimension; ++d)
  {
    const KnotVector& vector = Along(place.patch, d);
    const PatchTopology::Line& line = Mesh.topology.lines[place.patch].at(d);
    const auto& spans =
      (line.isReversed ? FlippedSpans : Spans)[static_cast<std::size_t>(line.vector)];
    degree.at(d) = vector.degree;
    first.at(d) = spans.at(static_cast<std::size_t>(place.at.at(d)));
    points.at(d) = vector.Points();
  }
  std::vector<std::size_t> numbers;
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int k = 0; k <= degree[2]; ++k)
      {
        const std::size_t at =
          (static_cast<std::size_t>(first[2] + k) * points[1] + (first[1] + j)) * points[0] +
          (first[0] + i);
        numbers.push_back(static_cast<std::size_t>(Grids[place.patch][at]));
      }
    }
  }
  return numbers;
}

std::vector<int> NurbsSpace::PointsOf(std::span<const int> elements) const
{
  std::vector<int> points;
  std::array<int, 3> first{};
  for (const int element : elements)
  {
    for (const std::size_t point : PointsAt(Mesh.places[static_cast<std::size_t>(element)], first))
    {
      points.push_back(static_cast<int>(point));
    }
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void NurbsSpace::SetWeights(std::vector<double> weights)
{
  Weights = std::move(weights);
  RequireWeights();
}

rational::RationalElement NurbsSpace::ElementOf(const GridPlace& place,
  const rational::ElementPart& part, std::span<const double> values, int components,
  std::span<const int> rows) const
{
  const auto width = static_cast<std::size_t>(components);
  rational::RationalElement element;
  std::array<int, 3> first{};
  std::vector<std::size_t> numbers = PointsAt(place, first);
  for (int d = 0; d < Mesh.topology.dimension; ++d)
  {
    element.degree.at(d) = Along(place.patch, d).degree;
  }
  for (const std::size_t number : numbers)
  {
    element.weights.push_back(Weights.empty() ? 1.0 : Weights[number]);
  }
  element.isPolynomial = std::ranges::all_of(
    element.weights, [&](long double weight) { return weight == element.weights.front(); });
  if (!rows.empty())
  {
    std::ranges::transform(numbers, numbers.begin(),
      [rows](std::size_t number)
      {
        return static_cast<std::size_t>(
          std::ranges::lower_bound(rows, static_cast<int>(number)) - rows.begin());
      });
  }
  std::vector<std::vector<long double>> grids{ element.weights };
  for (std::size_t c = 0; c < width; ++c)
  {
    element.shift.push_back(values[numbers.front() * width + c]);
    auto& grid = grids.emplace_back();
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      grid.push_back(element.weights[i] * (values[numbers[i] * width + c] - element.shift[c]));
    }
  }
  for (int d = 0; d < Mesh.topology.dimension; ++d)
  {
    const rational::LineMatrix extraction =
      Along(place.patch, d).Extraction(first.at(d), part.part.at(d), part.of.at(d));
    for (auto& grid : grids)
    {
      rational::GridSize size{ element.degree[0] + 1, element.degree[1] + 1,
        element.degree[2] + 1 };
      rational::Sweep(grid, size, d, extraction);
    }
  }
  element.weights = std::move(grids.front());
  for (std::size_t c = 0; c < width; ++c)
  {
    element.numerators.insert(element.numerators.end(), grids[c + 1].begin(), grids[c + 1].end());
  }
  return element;
}
} // namespace pixelexact::mfem
