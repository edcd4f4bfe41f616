// SPDX-License-Identifier: BSD-3-Clause
#include "StaleArrays.h"

#include "ArrayViews.h"
#include "CellElements.h"
#include "Core/Base/Error.h"
#include "Fingerprint.h"
#include "HighOrderArrays.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <span>

namespace pixelexact
{
namespace
{
/// Fingerprints of the cells by a hash.
using Prints = std::function<std::vector<std::int64_t>(Hash)>;

/// Calls visit(prefix, now) for the mesh, with an empty name, and for each field whose values an
/// array shows. `now` computes the fingerprints of the present state.
template <class Visit>
void ForFingerprints(vtkUnstructuredGrid* grid, Visit&& visit)
{
  visit(std::string(), Prints([grid](Hash hash) { return CellFingerprints(grid, hash); }));
  ArrayKeeper keeper;
  for (const std::string& name : StoredFieldNames(grid))
  {
    const auto origin = static_cast<Origin>(
      ViewArray<std::uint8_t>(grid, kFieldPrefix + name + ".Origin", 1, 1, keeper)[0]);
    if (vtkDataArray* source = FieldSource(grid, name, origin))
    {
      visit(name, Prints([=](Hash hash) { return ValueFingerprints(grid, source, origin, hash); }));
    }
  }
}

std::string NameOfFingerprints(const std::string& field)
{
  return (field.empty() ? kMeshPrefix : kFieldPrefix + field + ".") + "Fingerprint";
}

vtkIdType StoredElements(vtkUnstructuredGrid* grid)
{
  vtkDataArray* spaces =
    grid->GetFieldData()->GetArray((std::string(kMeshPrefix) + "Space").c_str());
  if (spaces == nullptr)
  {
    throw InvalidData("the grid's mesh coefficients are incomplete; read the grid again.");
  }
  return spaces->GetNumberOfTuples();
}
} // namespace

StaleParts FindStaleParts(vtkUnstructuredGrid* grid)
{
  const vtkIdType elements = StoredElements(grid);
  const CellElements cells(grid, elements);
  ArrayKeeper keeper;
  StaleParts stale;
  ForFingerprints(grid,
    [&](const std::string& field, const Prints& now)
    {
      const auto then =
        ViewArray<std::int64_t>(grid, NameOfFingerprints(field), 1, elements, keeper);
      if (cells.Fit(now, then))
      {
        return;
      }
      if (field.empty())
      {
        stale.cells = true;
      }
      else
      {
        stale.fields.push_back(field);
      }
    });
  return stale;
}

vtkSmartPointer<vtkUnstructuredGrid> WithPresentFingerprints(
  vtkUnstructuredGrid* grid, const StaleParts& stale)
{
  const vtkIdType elements = StoredElements(grid);
  const std::vector<std::int32_t> cellOf = CellElements(grid, elements).CellOfElements(elements);
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  copy->ShallowCopy(grid);
  vtkNew<vtkFieldData> data; // its own list of arrays
  data->ShallowCopy(grid->GetFieldData());
  copy->SetFieldData(data);
  ForFingerprints(grid,
    [&](const std::string& field, const Prints& now)
    {
      const bool isStale =
        field.empty() ? stale.cells : std::ranges::find(stale.fields, field) != stale.fields.end();
      if (!isStale)
      {
        return;
      }
      const std::vector<std::int64_t> prints = now(Hash::XXH3);
      vtkNew<vtkTypeInt64Array> array;
      array->SetName(NameOfFingerprints(field).c_str());
      array->SetNumberOfValues(elements);
      for (vtkIdType e = 0; e < elements; ++e)
      {
        const std::int32_t cell = cellOf[static_cast<std::size_t>(e)];
        array->SetValue(e, cell < 0 ? 0 : prints[static_cast<std::size_t>(cell)]);
      }
      data->AddArray(array);
    });
  return copy;
}
} // namespace pixelexact
