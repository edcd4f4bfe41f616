// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/ChangeOfBasis.h"

#include "Core/Base/Error.h"
#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/SimplexFactors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace pixelexact
{
namespace
{
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
  std::vector<int> modeOf(space.Modes());
  std::iota(modeOf.begin(), modeOf.end(), 0);
  return { space, { TetrahedronFactor(space, family) }, source, std::move(modeOf) };
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
  // The next factor has its columns slowest; finished modes and the component are fastest.
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
      // Sums near the largest double use long double, which has larger exponents.
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
