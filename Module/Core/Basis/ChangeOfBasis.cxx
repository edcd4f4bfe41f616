// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/ChangeOfBasis.h"

#include "Core/Base/Error.h"
#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/SimplexNodes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace pixelexact
{
namespace
{
long double Power(long double base, int exponent)
{
  long double result = 1.0L;
  for (int k = 0; k < exponent; ++k)
  {
    result *= base;
  }
  return result;
}

long double Binomial(int n, int k)
{
  long double result = 1.0L;
  for (int i = 1; i <= k; ++i)
  {
    result = result * (n - k + i) / i;
  }
  return result;
}

NodeFamily NodesOf(Family family)
{
  return family == Family::GaussLobattoLagrange ? NodeFamily::GaussLobatto : NodeFamily::Equispaced;
}

LineFunctions Line(int order, Family family)
{
  return family == Family::Bernstein ? Bernstein(order)
                                     : Lagrange(LineNodes(order, NodesOf(family)));
}

/// The triangle of a prism: its modes (p, 0, r), functions of (xi1, xi3).
Space TriangleOf(const Space& prism)
{
  return { Shape::Prism, Form::Collapsed, { prism.order[0], 0, prism.order[2] } };
}

/// The prism's mode for each mode of the triangle, slowest, and of the line.
std::vector<int> PrismModes(const Space& space)
{
  std::vector<int> modeOf(space.Modes());
  std::vector<int> triangleMode((space.order[0] + 1) * (space.order[2] + 1));
  const auto at = [&](int p, int r) -> int& { return triangleMode[p * (space.order[2] + 1) + r]; };
  ForEachMode(TriangleOf(space), [&](int p, int /*q*/, int r, int mode) { at(p, r) = mode; });
  ForEachMode(space,
    [&](int p, int q, int r, int mode) { modeOf[at(p, r) * (space.order[1] + 1) + q] = mode; });
  return modeOf;
}

BasisFactor TriangleFactor(int order, Family family)
{
  // The triangle of the prism at line order 0: modes (p, 0, r), functions of (xi1, xi3).
  const auto n = static_cast<std::uint8_t>(order);
  const Space triangle{ Shape::Prism, Form::Collapsed, { n, 0, n } };
  const int count = triangle.Modes();
  std::vector<long double> modes(std::size_t(count) * count);
  std::vector<long double> sources(modes.size(), 0.0L);
  const bool nodal = family != Family::Bernstein;
  const auto points = UnisolventPoints(triangle);
  const SimplexNodes nodes(order, NodesOf(family));
  int node = 0;
  for (int i = 0; i <= order; ++i)
  {
    for (int k = 0; k <= order - i; ++k, ++node)
    {
      const LongVec3 xi = !nodal ? points[node]
        : order == 0
        ? LongVec3{ -1.0L / 3, 0, -1.0L / 3 }
        : LongVec3{ nodes.At(i, { k, order - i - k }), 0, nodes.At(k, { i, order - i - k }) };
      EvaluateModes(triangle, xi, &modes[std::size_t(node) * count]);
      if (nodal)
      {
        sources[std::size_t(node) * count + node] = 1.0L;
        continue;
      }
      const long double l1 = (1 + xi[0]) / 2;
      const long double l3 = (1 + xi[2]) / 2;
      int function = 0;
      for (int a = 0; a <= order; ++a)
      {
        for (int c = 0; c <= order - a; ++c, ++function)
        {
          sources[std::size_t(node) * count + function] = Binomial(order, a) *
            Binomial(order - a, c) * Power(l1, a) * Power(l3, c) *
            Power(1 - l1 - l3, order - a - c);
        }
      }
    }
  }
  return SolveFactor(count, count, modes, sources);
}

} // namespace

ChangeOfBasis::ChangeOfBasis(const Space& space, std::vector<BasisFactor> factors,
  std::span<const int> source, std::vector<int> modeOf)
  : TargetSpace(space)
  , Factors(std::move(factors))
  , Matrices(Factors.begin(), Factors.end())
  , SourceOf(source.begin(), source.end())
  , ModeOf(std::move(modeOf))
{
  std::size_t columns = 1;
  std::vector<double> norm{ 1.0 };
  for (const auto& factor : Factors)
  {
    columns *= factor.columns;
    std::vector<double> next;
    next.reserve(norm.size() * factor.rows);
    for (const double outer : norm)
    {
      for (int row = 0; row < factor.rows; ++row)
      {
        double sum = 0.0;
        for (int column = 0; column < factor.columns; ++column)
        {
          sum += std::fabs(static_cast<double>(factor.matrix[row * factor.columns + column]));
        }
        next.push_back(outer * sum);
      }
    }
    norm = std::move(next);
  }
  std::vector<int> sorted = SourceOf;
  std::ranges::sort(sorted);
  if (sorted.size() != columns || (columns > 0 && sorted.front() < 0) ||
    std::ranges::adjacent_find(sorted) != sorted.end())
  {
    throw InvalidData("a change of basis needs a place of its own for each of its " +
      std::to_string(columns) + " source functions; the numbering given has others.");
  }
  RowNorm.resize(norm.size());
  for (std::size_t i = 0; i < norm.size(); ++i)
  {
    RowNorm[ModeOf[i]] = norm[i];
  }
}

ChangeOfBasis ChangeOfBasis::Hexahedron(
  const Space& space, Family family, std::span<const int> source)
{
  std::array<LineFunctions, 3> lines;
  std::ranges::transform(
    space.order, lines.begin(), [family](int order) { return Line(order, family); });
  return FromLines(space, lines, source);
}

ChangeOfBasis ChangeOfBasis::Prism(const Space& space, Family family, std::span<const int> source)
{
  return { space,
    { TriangleFactor(space.order[0], family),
      LineFactor(space.order[1], Line(space.order[1], family)) },
    source, PrismModes(space) };
}

ChangeOfBasis ChangeOfBasis::Tetrahedron(
  const Space& space, Family family, std::span<const int> source)
{
  const int order = space.order[0];
  const int count = space.Modes();
  std::vector<long double> modes(std::size_t(count) * count);
  std::vector<long double> sources(modes.size(), 0.0L);
  const bool nodal = family != Family::Bernstein;
  const auto points = UnisolventPoints(space);
  const SimplexNodes nodes(order, NodesOf(family));
  int node = 0;
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; j <= order - i; ++j)
    {
      for (int k = 0; k <= order - i - j; ++k, ++node)
      {
        const LongVec3 xi = !nodal ? points[node]
          : order == 0
          ? LongVec3{ -0.5L, -0.5L, -0.5L }
          : LongVec3{ nodes.At(i, { j, k, order - i - j - k }),
              nodes.At(j, { i, k, order - i - j - k }), nodes.At(k, { i, j, order - i - j - k }) };
        EvaluateModes(space, xi, &modes[std::size_t(node) * count]);
        long double* row = &sources[std::size_t(node) * count];
        if (nodal)
        {
          row[node] = 1.0L;
          continue;
        }
        const long double l1 = (1 + xi[0]) / 2;
        const long double l2 = (1 + xi[1]) / 2;
        const long double l3 = (1 + xi[2]) / 2;
        for (int a = 0; a <= order; ++a)
        {
          for (int b = 0; b <= order - a; ++b)
          {
            for (int c = 0; c <= order - a - b; ++c)
            {
              *row++ = Binomial(order, a) * Binomial(order - a, b) * Binomial(order - a - b, c) *
                Power(l1, a) * Power(l2, b) * Power(l3, c) *
                Power(1 - l1 - l2 - l3, order - a - b - c);
            }
          }
        }
      }
    }
  }
  std::vector<int> modeOf(count);
  std::iota(modeOf.begin(), modeOf.end(), 0);
  return { space, { SolveFactor(count, count, modes, sources) }, source, std::move(modeOf) };
}

ChangeOfBasis ChangeOfBasis::FromLines(
  const Space& space, const std::array<LineFunctions, 3>& lines, std::span<const int> source)
{
  std::vector<BasisFactor> factors{ LineFactor(space.order[0], lines[0]),
    LineFactor(space.order[1], lines[1]), LineFactor(space.order[2], lines[2]) };
  std::vector<int> modeOf(space.Modes());
  std::iota(modeOf.begin(), modeOf.end(), 0);
  return { space, std::move(factors), source, std::move(modeOf) };
}

ChangeOfBasis ChangeOfBasis::FromTriangleAndLine(const Space& space, int triangleFunctions,
  const std::function<void(long double xi1, long double xi3, long double*)>& triangle,
  const LineFunctions& line, std::span<const int> source)
{
  return { space,
    { SolidFactor(TriangleOf(space), triangleFunctions,
        [&triangle](const LongVec3& xi, long double* values) { triangle(xi[0], xi[2], values); }),
      LineFactor(space.order[1], line) },
    source, PrismModes(space) };
}

ChangeOfBasis ChangeOfBasis::FromFunctions(const Space& space, int sources,
  const std::function<void(const LongVec3&, long double*)>& functions)
{
  std::vector<int> source(sources);
  std::iota(source.begin(), source.end(), 0);
  std::vector<int> modeOf(space.Modes());
  std::iota(modeOf.begin(), modeOf.end(), 0);
  return { space, { SolidFactor(space, sources, functions) }, source, std::move(modeOf) };
}

void ChangeOfBasis::Apply(
  std::span<const double> values, double shift, std::span<double> canonical) const
{
  Scratch scratch;
  Apply(values, { &shift, 1 }, canonical, scratch);
}

void ChangeOfBasis::Apply(std::span<const double> values, std::span<const double> shifts,
  std::span<double> canonical, Scratch& scratch) const
{
  const std::size_t components = shifts.size();
  const std::size_t sources = values.size() / components;
  auto& [from, to] = scratch;
  // The factor that comes next has its columns slowest, what is done and the component fastest.
  std::size_t size = SourceOf.size() * components;
  from.Resize(size);
  for (std::size_t i = 0; i < SourceOf.size(); ++i)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      const double value = values[c * sources + static_cast<std::size_t>(SourceOf[i])];
      const double difference = value - shifts[c];
      const double added = difference - value;
      from.high[i * components + c] = difference;
      from.low[i * components + c] = (value - (difference - added)) - (shifts[c] + added);
    }
  }
  for (const PairMatrix& matrix : Matrices)
  {
    const std::size_t rest = size / static_cast<std::size_t>(matrix.columns);
    Multiply(matrix, rest, from, to);
    size = rest * static_cast<std::size_t>(matrix.rows);
    std::swap(from, to);
  }
  const std::size_t modes = ModeOf.size();
  for (std::size_t c = 0; c < components; ++c)
  {
    const std::span<double> out = canonical.subspan(c * modes, modes);
    bool finite = true;
    for (std::size_t i = 0; i < modes; ++i)
    {
      const double value = from.high[c * modes + i];
      out[static_cast<std::size_t>(ModeOf[i])] = value;
      finite = finite && std::isfinite(value);
    }
    if (!finite)
    {
      // Sums near the largest double, of which long double has the exponents.
      ApplyInLongDouble(values.subspan(c * sources, sources), shifts[c], out);
    }
  }
}

void ChangeOfBasis::ApplyInLongDouble(
  std::span<const double> values, double shift, std::span<double> canonical) const
{
  std::vector<long double> current(SourceOf.size());
  for (std::size_t i = 0; i < current.size(); ++i)
  {
    current[i] = static_cast<long double>(values[SourceOf[i]]) - shift;
  }
  std::vector<long double> next;
  std::size_t outer = 1; // combinations of rows of the factors already applied
  std::size_t inner = current.size();
  for (const auto& factor : Factors)
  {
    const auto columns = static_cast<std::size_t>(factor.columns);
    inner /= columns;
    next.resize(outer * factor.rows * inner);
    long double* to = next.data();
    for (std::size_t o = 0; o < outer; ++o)
    {
      for (int row = 0; row < factor.rows; ++row)
      {
        const long double* m = &factor.matrix[static_cast<std::size_t>(row) * columns];
        const long double* from = &current[o * columns * inner];
        // A sum at a time: it stays in a register, and long doubles are slow to store.
        for (std::size_t i = 0; i < inner; ++i)
        {
          long double sum = 0.0L;
          for (std::size_t column = 0; column < columns; ++column)
          {
            sum += m[column] * from[column * inner + i];
          }
          *to++ = sum;
        }
      }
    }
    current.swap(next);
    outer *= factor.rows;
  }
  for (std::size_t i = 0; i < current.size(); ++i)
  {
    canonical[ModeOf[i]] = static_cast<double>(current[i]);
  }
}
} // namespace pixelexact
