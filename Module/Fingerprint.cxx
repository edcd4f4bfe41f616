// SPDX-License-Identifier: BSD-3-Clause
#include "Fingerprint.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <bit>

namespace pixelexact
{
namespace
{
/// Mixes word by word with the finaliser of MurmurHash3 (A. Appleby, public domain), so that the
/// order of words counts.
class Hash
{
public:
  void Add(std::uint64_t word)
  {
    state = (state ^ word) + 0x9e3779b97f4a7c15U;
    state = (state ^ (state >> 33U)) * 0xff51afd7ed558ccdU;
    state = (state ^ (state >> 33U)) * 0xc4ceb9fe1a85ec53U;
    state ^= state >> 33U;
  }
  void Add(double value) { Add(std::bit_cast<std::uint64_t>(value + 0.0)); }
  [[nodiscard]] std::int64_t Value() const { return std::bit_cast<std::int64_t>(state); }

private:
  std::uint64_t state = 0;
};

void AddTuple(Hash& hash, vtkDataArray* array, vtkIdType tuple, std::vector<double>& scratch)
{
  scratch.resize(array->GetNumberOfComponents());
  array->GetTuple(tuple, scratch.data());
  for (const double value : scratch)
  {
    hash.Add(value);
  }
}
/// hash(cell, points, scratch) for every cell, in parallel.
template <class HashCell>
std::vector<std::int64_t> ForCells(vtkUnstructuredGrid* grid, HashCell&& hashCell)
{
  std::vector<std::int64_t> prints(grid->GetNumberOfCells());
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, grid->GetNumberOfCells(), 1024),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      vtkNew<vtkIdList> points;
      std::vector<double> scratch;
      for (vtkIdType cell = range.begin(); cell < range.end(); ++cell)
      {
        Hash hash;
        hashCell(hash, cell, points.Get(), scratch);
        prints[cell] = hash.Value();
      }
    });
  return prints;
}
} // namespace

std::vector<std::int64_t> CellFingerprints(vtkUnstructuredGrid* grid)
{
  return ForCells(grid,
    [grid](Hash& hash, vtkIdType cell, vtkIdList* points, std::vector<double>& scratch)
    {
      grid->GetCellPoints(cell, points);
      hash.Add(static_cast<std::uint64_t>(grid->GetCellType(cell)));
      hash.Add(static_cast<std::uint64_t>(points->GetNumberOfIds()));
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        AddTuple(hash, grid->GetPoints()->GetData(), points->GetId(i), scratch);
      }
    });
}

std::vector<std::int64_t> ValueFingerprints(
  vtkUnstructuredGrid* grid, vtkDataArray* source, Origin origin)
{
  return ForCells(grid,
    [=](Hash& hash, vtkIdType cell, vtkIdList* points, std::vector<double>& scratch)
    {
      if (origin == Origin::CellData)
      {
        AddTuple(hash, source, cell, scratch);
        return;
      }
      grid->GetCellPoints(cell, points);
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        AddTuple(hash, source, points->GetId(i), scratch);
      }
    });
}

vtkDataArray* FieldSource(vtkUnstructuredGrid* grid, const std::string& name, Origin origin)
{
  switch (origin)
  {
    case Origin::PointData:
      return grid->GetPointData()->GetArray(name.c_str());
    case Origin::CellData:
      return grid->GetCellData()->GetArray(name.c_str());
    default:
      return nullptr;
  }
}
} // namespace pixelexact
