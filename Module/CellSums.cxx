// SPDX-License-Identifier: BSD-3-Clause
#include "CellSums.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kTypes = 256.0;

/// A weight between 1 and 2 that differs for each point.
double Weight(vtkIdType point, int which)
{
  const double product =
    static_cast<double>(point + 1) * (which == 0 ? 0.6180339887 : 0.4142135623);
  return 1.0 + product - std::floor(product);
}
} // namespace

void SumOver(
  vtkUnstructuredGrid* grid, vtkIdType cell, vtkDataArray* values, std::span<double> sums)
{
  vtkNew<vtkIdList> points;
  grid->GetCellPoints(cell, points);
  std::ranges::fill(sums, 0.0);
  sums[0] = grid->GetCellType(cell) + kTypes * static_cast<double>(points->GetNumberOfIds());
  const int components = values->GetNumberOfComponents();
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      const double value = values->GetComponent(points->GetId(i), c);
      sums[1 + 2 * static_cast<std::size_t>(c)] += Weight(i, 0) * value;
      sums[2 + 2 * static_cast<std::size_t>(c)] += Weight(i, 1) * value;
    }
  }
}

bool AreSameSums(
  std::span<const double> a, std::span<const double> b, double tolerance, double largest)
{
  const double points = std::floor(a[0] / kTypes);
  // Each sum of n terms of at most twice the size is off by n roundings of 2 n times it.
  const double summed = 2.0 * points * points * std::numeric_limits<double>::epsilon() * largest;
  const double most = 2.0 * points * tolerance + 2.0 * summed;
  return a[0] == b[0] &&
    std::equal(a.begin() + 1, a.end(), b.begin() + 1, b.end(),
      [most](double x, double y) { return std::fabs(x - y) <= most; });
}
} // namespace pixelexact
