// SPDX-License-Identifier: BSD-3-Clause
#include "Fingerprint.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <span>

namespace pixelexact
{
namespace
{
/// Tuples of an array as doubles; of doubles without VTK's call for each.
class Tuples
{
public:
  explicit Tuples(vtkDataArray* array)
    : Array(array)
    , Components(static_cast<std::size_t>(array->GetNumberOfComponents()))
  {
    if (auto* doubles = vtkDoubleArray::FastDownCast(array))
    {
      First = doubles->GetPointer(0);
    }
  }

  void Append(std::vector<double>& numbers, std::span<const vtkIdType> tuples) const
  {
    const std::size_t begin = numbers.size();
    numbers.resize(begin + tuples.size() * Components);
    double* to = numbers.data() + begin;
    for (const vtkIdType tuple : tuples)
    {
      if (First != nullptr)
      {
        std::copy_n(First + static_cast<std::size_t>(tuple) * Components, Components, to);
      }
      else
      {
        Array->GetTuple(tuple, to);
      }
      to += Components;
    }
  }

private:
  vtkDataArray* Array;
  std::size_t Components;
  const double* First = nullptr;
};

std::span<const vtkIdType> Ids(vtkIdList* list)
{
  return { list->GetPointer(0), static_cast<std::size_t>(list->GetNumberOfIds()) };
}

std::uint64_t Mixed(std::uint64_t state, std::uint64_t word)
{
  state = (state ^ word) + 0x9e3779b97f4a7c15U;
  state = (state ^ (state >> 33U)) * 0xff51afd7ed558ccdU;
  state = (state ^ (state >> 33U)) * 0xc4ceb9fe1a85ec53U;
  return state ^ (state >> 33U);
}

/// `whole`: how many of the numbers, from the first on, the first hash took as integers.
std::int64_t HashOf(std::vector<double>& numbers, std::size_t whole, Hash hash)
{
  for (double& number : numbers)
  {
    number += 0.0; // makes the two zeros one
  }
  if (hash == Hash::First)
  {
    std::uint64_t state = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      state = Mixed(state,
        i < whole ? static_cast<std::uint64_t>(numbers[i])
                  : std::bit_cast<std::uint64_t>(numbers[i]));
    }
    return std::bit_cast<std::int64_t>(state);
  }
  return std::bit_cast<std::int64_t>(XXH3_64bits(numbers.data(), numbers.size() * sizeof(double)));
}

/// The hash of what append(numbers, cell, points) leaves, for every cell, in parallel.
template <class Append>
std::vector<std::int64_t> ForCells(
  vtkUnstructuredGrid* grid, std::size_t whole, Hash hash, Append&& append)
{
  std::vector<std::int64_t> prints(grid->GetNumberOfCells());
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, grid->GetNumberOfCells(), 1024),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      vtkNew<vtkIdList> points;
      std::vector<double> numbers;
      for (vtkIdType cell = range.begin(); cell < range.end(); ++cell)
      {
        numbers.clear();
        append(numbers, cell, points.Get());
        prints[cell] = HashOf(numbers, whole, hash);
      }
    });
  return prints;
}
} // namespace

std::vector<std::int64_t> CellFingerprints(vtkUnstructuredGrid* grid, Hash hash)
{
  const Tuples places(grid->GetPoints()->GetData());
  return ForCells(grid, 2, hash,
    [grid, &places](std::vector<double>& numbers, vtkIdType cell, vtkIdList* points)
    {
      grid->GetCellPoints(cell, points);
      numbers.push_back(grid->GetCellType(cell));
      numbers.push_back(static_cast<double>(points->GetNumberOfIds()));
      places.Append(numbers, Ids(points));
    });
}

std::vector<std::int64_t> ValueFingerprints(
  vtkUnstructuredGrid* grid, vtkDataArray* source, Origin origin, Hash hash)
{
  const Tuples values(source);
  return ForCells(grid, 0, hash,
    [grid, origin, &values](std::vector<double>& numbers, vtkIdType cell, vtkIdList* points)
    {
      if (!IsAtPoints(origin))
      {
        values.Append(numbers, { &cell, 1 });
        return;
      }
      grid->GetCellPoints(cell, points);
      values.Append(numbers, Ids(points));
    });
}

vtkDataArray* FieldSource(vtkUnstructuredGrid* grid, const std::string& name, Origin origin)
{
  if (origin == Origin::Coefficients)
  {
    return nullptr;
  }
  vtkDataSetAttributes* const data = IsAtPoints(origin)
    ? static_cast<vtkDataSetAttributes*>(grid->GetPointData())
    : grid->GetCellData();
  return data->GetArray(name.c_str());
}
} // namespace pixelexact
