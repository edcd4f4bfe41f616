// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/ElementBasis.h"

#include <numeric>
#include <utility>

namespace pixelexact
{
std::vector<long double> DualMatrix(int count, const std::vector<long double>& functionals)
{
  std::vector<long double> identity(functionals.size(), 0.0L);
  for (int i = 0; i < count; ++i)
  {
    identity[std::size_t(i) * count + i] = 1.0L;
  }
  return SolveFactor(count, count, functionals, identity).matrix;
}

SolidFunctions Combined(
  SolidFunctions functions, int terms, const std::vector<long double>& matrix, int count)
{
  std::vector<long double> columns(matrix.size()); // one after the other, as they are summed
  for (int m = 0; m < terms; ++m)
  {
    for (int j = 0; j < count; ++j)
    {
      columns[std::size_t(j) * terms + m] = matrix[std::size_t(m) * count + j];
    }
  }
  return [inner = std::move(functions), terms, columns = std::move(columns), count](
           const LongVec3& xi, long double* values)
  {
    std::vector<long double> term(terms);
    inner(xi, term.data());
    for (int j = 0; j < count; ++j)
    {
      values[j] =
        std::inner_product(term.begin(), term.end(), &columns[std::size_t(j) * terms], 0.0L);
    }
  };
}

SolidFunctions Cardinal(const Space& space, const std::vector<LongVec3>& nodes)
{
  const int count = space.Modes();
  std::vector<long double> functionals(std::size_t(count) * count);
  for (int k = 0; k < count; ++k)
  {
    EvaluateModes(space, nodes[k], &functionals[std::size_t(k) * count]);
  }
  return Combined([space](const LongVec3& xi, long double* values)
    { EvaluateModes(space, xi, values); },
    count, DualMatrix(count, functionals), count);
}
} // namespace pixelexact
