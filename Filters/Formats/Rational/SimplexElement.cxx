// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Rational/SimplexElement.h"

#include "Formats/ElementBasis.h"
#include "Formats/Rational/LineMatrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace pixelexact::rational
{
namespace
{
using LongVector = std::vector<long double>;

/// Bernstein's coefficients of a line, which has `low` + 1 of them, as those of degree `high`.
void Elevate(LongVector& line, int high)
{
  for (int n = static_cast<int>(line.size()); n <= high; ++n)
  {
    line.push_back(line.back());
    for (int i = n - 1; i > 0; --i)
    {
      const long double share = static_cast<long double>(i) / n;
      line[i] = share * line[i - 1] + (1 - share) * line[i];
    }
  }
}

/// The barycentric coordinates of the node with these numbers, whose sum is `order`.
LongVector SimplexNode(const std::vector<int>& numbers, int order)
{
  LongVector place(numbers.size(), 0.0L);
  if (numbers.size() == 1)
  {
    return { 1.0L };
  }
  const LongVector line = NodesOf(order);
  long double total = 0.0L;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    // The node's shadow on the facet opposite of vertex i.
    const int rest = order - numbers[i];
    if (rest == 0)
    {
      continue;
    }
    std::vector<int> facet = numbers;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
    LongVector shadow = SimplexNode(facet, rest);
    shadow.insert(shadow.begin() + static_cast<std::ptrdiff_t>(i), 0.0L);
    const long double weight = (1 + line[static_cast<std::size_t>(rest)]) / 2;
    for (std::size_t k = 0; k < place.size(); ++k)
    {
      place[k] += weight * shadow[k];
    }
    total += weight;
  }
  std::ranges::transform(place, place.begin(), [total](long double x) { return x / total; });
  return place;
}

/// (1 + a part of a whole) in [-1,1]; of no whole any.
long double Part(long double part, long double whole)
{
  return whole > 0 ? std::clamp(2 * part / whole - 1, -1.0L, 1.0L) : -1.0L;
}

/// The nodes in eta, ordered as Collapse takes control points.
std::vector<LongVec3> NodesOfSpace(const Space& space)
{
  std::vector<LongVec3> nodes;
  const int n = space.order[0];
  if (space.shape == Shape::Prism)
  {
    const LongVector line = NodesOf(space.order[1]);
    for (int i = 0; i <= n; ++i)
    {
      for (int k = 0; i + k <= n; ++k)
      {
        const LongVector at =
          n == 0 ? LongVector(3, 1.0L / 3) : SimplexNode({ n - i - k, i, k }, n);
        for (const long double eta2 : line)
        {
          nodes.push_back({ Part(at[1], at[0] + at[1]), eta2, 2 * at[2] - 1 });
        }
      }
    }
    return nodes;
  }
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      for (int k = 0; i + j + k <= n; ++k)
      {
        const LongVector at = SimplexNode({ n - i - j - k, i, j, k }, n);
        const long double below = at[0] + at[1];
        nodes.push_back({ Part(at[1], below), Part(at[2], below + at[2]), 2 * at[3] - 1 });
      }
    }
  }
  return nodes;
}

LongVec3 Uncollapsed(Shape shape, const LongVec3& eta)
{
  const long double xi2 = shape == Shape::Prism ? eta[1] : (1 + eta[1]) * (1 - eta[2]) / 2 - 1;
  const long double whole = shape == Shape::Prism ? 1 - eta[2] : -xi2 - eta[2];
  return { (1 + eta[0]) * whole / 2 - 1, xi2, eta[2] };
}

ChangeOfBasis FromNodes(const Space& space, const std::vector<LongVec3>& nodes)
{
  std::vector<int> source(nodes.size());
  std::iota(source.begin(), source.end(), 0);
  std::vector<LongVec3> places;
  const bool isPrism = space.shape == Shape::Prism;
  const std::size_t along = isPrism ? space.order[1] + 1U : 1U;
  for (std::size_t i = 0; i < nodes.size(); i += along)
  {
    places.push_back(Uncollapsed(space.shape, nodes[i]));
  }
  if (!isPrism)
  {
    return ChangeOfBasis::FromFunctions(
      space, static_cast<int>(places.size()), Cardinal(space, places));
  }
  const Space triangle{ Shape::Prism, Form::Collapsed, { space.order[0], 0, space.order[2] } };
  const SolidFunctions cardinal = Cardinal(triangle, places);
  return ChangeOfBasis::FromTriangleAndLine(
    space, static_cast<int>(places.size()),
    [&](long double xi1, long double xi3, long double* values) {
      cardinal({ xi1, 0, xi3 }, values);
    },
    Lagrange(NodesOf(space.order[1])), source);
}

/// Bernstein's sum at a point of the cube.
long double ValueAt(std::span<const long double> control, const std::array<LineMatrix, 3>& lines)
{
  long double value = 0.0L;
  auto at = control.begin();
  for (const long double b1 : lines[0].entries)
  {
    for (const long double b2 : lines[1].entries)
    {
      const long double factor = b1 * b2;
      for (const long double b3 : lines[2].entries)
      {
        value += factor * b3 * *at++;
      }
    }
  }
  return value;
}
} // namespace

LongVector Collapse(const Space& space, std::span<const long double> control)
{
  const int n = space.order[0];
  const auto size = static_cast<std::size_t>(n) + 1;
  LongVector line;
  if (space.shape == Shape::Prism)
  {
    const auto along = static_cast<std::size_t>(space.order[1]) + 1;
    LongVector cube(size * along * size);
    for (int k = 0; k <= n; ++k)
    {
      for (std::size_t j = 0; j < along; ++j)
      {
        line.clear();
        for (int i = 0; i + k <= n; ++i)
        {
          const int before = i * (n + 1) - i * (i - 1) / 2; // functions with a smaller i
          line.push_back(control[static_cast<std::size_t>(before + k) * along + j]);
        }
        Elevate(line, n);
        for (std::size_t i = 0; i < size; ++i)
        {
          cube[(i * along + j) * size + static_cast<std::size_t>(k)] = line[i];
        }
      }
    }
    return cube;
  }
  LongVector cube(size * size * size);
  // The number of the mode (i, j, k) by degree along eta1, then along eta2.
  std::vector<std::size_t> first(size * size);
  std::size_t count = 0;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      first[static_cast<std::size_t>(i) * size + static_cast<std::size_t>(j)] = count;
      count += static_cast<std::size_t>(n - i - j) + 1;
    }
  }
  for (int k = 0; k <= n; ++k)
  {
    std::vector<LongVector> lines; // by i, along eta2
    lines.resize(size);
    for (int j = 0; j + k <= n; ++j)
    {
      line.clear();
      for (int i = 0; i + j + k <= n; ++i)
      {
        line.push_back(
          control[first[static_cast<std::size_t>(i) * size + static_cast<std::size_t>(j)] +
            static_cast<std::size_t>(k)]);
      }
      Elevate(line, n);
      for (std::size_t i = 0; i < size; ++i)
      {
        lines[i].push_back(line[i]);
      }
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      Elevate(lines[i], n);
      for (std::size_t j = 0; j < size; ++j)
      {
        cube[(i * size + j) * size + static_cast<std::size_t>(k)] = lines[i][j];
      }
    }
  }
  return cube;
}

SimplexBasis::SimplexBasis(const Space& space)
  : Nodes(NodesOfSpace(space))
  , Change(FromNodes(space, Nodes))
{
}

void SimplexBasis::NodeValues(const RationalElement& element, std::span<double> values) const
{
  const std::size_t points = element.weights.size();
  const auto components = static_cast<std::size_t>(element.Components());
  for (std::size_t i = 0; i < Nodes.size(); ++i)
  {
    const std::array<LineMatrix, 3> lines{ BernsteinAt(element.degree[0], { Nodes[i][0] }),
      BernsteinAt(element.degree[1], { Nodes[i][1] }),
      BernsteinAt(element.degree[2], { Nodes[i][2] }) };
    const long double weight = ValueAt(element.weights, lines);
    for (std::size_t c = 0; c < components; ++c)
    {
      const auto numerator = std::span(element.numerators).subspan(c * points, points);
      values[c * Nodes.size() + i] =
        static_cast<double>(element.shift[c] + ValueAt(numerator, lines) / weight);
    }
  }
}

double SimplexBasis::LossOf(const RationalElement& element, LineTables& tables) const
{
  // w (N / w - P) = N - w P is a polynomial in eta, of these degrees.
  std::array<const LineMatrix*, 3> toSamples{};
  std::array<LongVector, 3> samples;
  long double factor = 1.0L; // of Ehlich and Zeller
  int terms = 0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int degree = element.degree[d] + GetSpace().order[d];
    const int count = degree == 0 ? 1 : std::max(degree + 1, (3 * degree + 1) / 2);
    factor /= std::cos(std::numbers::pi_v<long double> * degree / (2 * count));
    toSamples[d] = &tables.BernsteinToSamples(element.degree[d], count);
    samples[d] = ChebyshevZeros(count);
    terms += 10 * (element.degree[d] + 2);
  }
  const CollapsedModes modes(GetSpace(), samples);
  const auto evaluate = [&](std::span<const long double> control)
  {
    LongVector grid(control.begin(), control.end());
    GridSize size{ element.degree[0] + 1, element.degree[1] + 1, element.degree[2] + 1 };
    for (int d = 0; d < 3; ++d)
    {
      Sweep(grid, size, d, *toSamples[static_cast<std::size_t>(d)]);
    }
    return grid;
  };
  const auto [least, most] = std::ranges::minmax(element.weights);
  const LongVector weights = evaluate(element.weights);
  const std::size_t points = element.weights.size();
  const auto components = static_cast<std::size_t>(element.Components());
  std::vector<double> values(Nodes.size() * components);
  NodeValues(element, values);
  std::vector<double> coefficients(Nodes.size());
  long double loss = 0.0L;
  for (std::size_t c = 0; c < components; ++c)
  {
    const auto numerator = std::span(element.numerators).subspan(c * points, points);
    Change.Apply(std::span(values).subspan(c * Nodes.size(), Nodes.size()),
      static_cast<double>(element.shift[c]), coefficients);
    const CollapsedModes::Values polynomial = modes.Evaluate(coefficients);
    const LongVector exact = evaluate(numerator);
    long double largest = 0.0L; // of |N / w|: a mean of the points with positive weights
    for (std::size_t i = 0; i < points; ++i)
    {
      largest = std::max(largest, std::fabs(numerator[i]) / element.weights[i]);
    }
    const long double rounding = terms * kLongRoundoff * largest * (most / least);
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      const long double off = std::fabs(exact[i] / weights[i] - polynomial.value[i]) + rounding +
        modes.Roundings() * kLongRoundoff * polynomial.magnitude[i];
      loss = std::max(loss, weights[i] * off);
    }
  }
  return static_cast<double>(factor * loss / least) * (1 + 1e-12);
}
} // namespace pixelexact::rational
