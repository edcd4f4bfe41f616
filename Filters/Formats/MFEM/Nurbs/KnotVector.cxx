// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/KnotVector.h"

#include "Core/Basis/Space.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::mfem
{
std::vector<int> KnotVector::Spans() const
{
  std::vector<int> spans;
  for (int i = 0; i + degree < Points(); ++i)
  {
    const int knot = i + degree;
    if (knots.at(knot) != knots.at(knot + 1))
    {
      spans.push_back(i);
    }
  }
  return spans;
}

bool KnotVector::IsContinuous() const
{
  for (std::size_t i = 1; i + static_cast<std::size_t>(degree) + 1 < knots.size(); ++i)
  {
    if (knots[i] == knots[i + static_cast<std::size_t>(degree)] && knots[i] != knots.front() &&
      knots[i] != knots.back())
    {
      return false;
    }
  }
  return true;
}

bool KnotVector::IsSymmetric() const
{
  constexpr double kSame = 1e-12;
  const double slack = kSame * (knots.back() - knots.front());
  const KnotVector flipped = Flipped();
  return std::equal(knots.begin(), knots.end(), flipped.knots.begin(),
    [slack](double a, double b) { return std::fabs(a - b) <= slack; });
}

KnotVector KnotVector::Flipped() const
{
  KnotVector flipped = *this;
  const double ends = knots.front() + knots.back();
  const int pairs = (Points() - degree) / 2;
  for (int i = 1; i <= pairs; ++i)
  {
    const int low = degree + i;
    const int high = Points() - i;
    flipped.knots.at(low) = ends - knots.at(high);
    flipped.knots.at(high) = ends - knots.at(low);
  }
  return flipped;
}

KnotVector KnotVector::Elevated(int to) const
{
  KnotVector elevated;
  elevated.degree = to;
  const auto ends = static_cast<std::size_t>(to) + 1;
  const auto own = static_cast<std::ptrdiff_t>(degree) + 1;
  elevated.knots.assign(ends, knots.front());
  elevated.knots.insert(elevated.knots.end(), knots.begin() + own, knots.end() - own);
  elevated.knots.insert(elevated.knots.end(), ends, knots.back());
  return elevated;
}

rational::LineMatrix KnotVector::Extraction(int first, int part, int parts) const
{
  const int n = degree + 1;
  const auto size = static_cast<std::size_t>(n);
  const auto at = [this](int knot) { return static_cast<long double>(knots.at(knot)); };
  const int span = first + degree;
  const long double length = at(span + 1) - at(span);
  const long double low = at(span) + length * part / parts;
  const long double high = at(span) + length * (part + 1) / parts;
  rational::LineMatrix matrix{ n, n, {} };
  for (int k = 0; k < n; ++k)
  {
    // Coefficient k is the polar form at (low, ..., high), `high` k times: de Boor's algorithm with
    // an argument of its own in each step. Row i of the table: what control points weigh in entry
    // i.
    std::vector<long double> table(size * size, 0.0L);
    for (std::size_t i = 0; i < size; ++i)
    {
      table[i * size + i] = 1.0L;
    }
    for (int step = 1; step < n; ++step)
    {
      const long double u = step <= degree - k ? low : high;
      for (int i = degree; i >= step; --i)
      {
        const long double from = at(first + i);
        const long double to = at(first + i + n - step);
        const long double share = (u - from) / (to - from);
        const long double rest = (to - u) / (to - from);
        for (std::size_t j = 0; j < size; ++j)
        {
          long double& entry = table[static_cast<std::size_t>(i) * size + j];
          entry = rest * table[static_cast<std::size_t>(i - 1) * size + j] + share * entry;
        }
      }
    }
    matrix.entries.insert(matrix.entries.end(), table.end() - n, table.end());
  }
  return matrix;
}

KnotVector ReadKnotVector(TextScanner& scanner)
{
  KnotVector vector;
  vector.degree = scanner.Integer("a knot vector's order", 1, 1 << 20);
  if (vector.degree > kMaxOrder)
  {
    scanner.FailUnsupported("a knot vector has order " + std::to_string(vector.degree) +
      "; orders to " + std::to_string(kMaxOrder) + " are read.");
  }
  const int points = scanner.Count("a knot vector's number of control points", 2);
  if (points < vector.degree + 1)
  {
    scanner.Fail("a knot vector of order " + std::to_string(vector.degree) + " has " +
      std::to_string(points) + " control points; it needs one more than its order at least.");
  }
  for (int i = 0; i < points + vector.degree + 1; ++i)
  {
    const double knot = scanner.Number("a knot");
    if (!std::isfinite(knot) || (!vector.knots.empty() && knot < vector.knots.back()))
    {
      scanner.Fail("a knot vector's knots descend, or are no numbers; they must ascend, or stay.");
    }
    vector.knots.push_back(knot);
  }
  if (vector.Spans().empty())
  {
    scanner.Fail("a knot vector has no span that is not empty; there is nothing to show.");
  }
  return vector;
}
} // namespace pixelexact::mfem
