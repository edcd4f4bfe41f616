// SPDX-License-Identifier: BSD-3-Clause
#include "HighOrderModel.h"

#include "ArrayViews.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Fingerprint.h"

#include "vtkCellData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <map>
#include <mutex>
#include <numeric>

namespace pixelexact
{
namespace
{
constexpr const char* kRemedy = "; run vtkUnstructuredGridToHighOrderGrid again.";

/// The element of each cell. Throws StaleData where a cell is not the one that its element was made
/// with.
class CellElements
{
public:
  CellElements(vtkUnstructuredGrid* grid, vtkIdType elements, ArrayKeeper& keeper)
    : Element(grid->GetNumberOfCells())
  {
    if (grid->GetCellData()->HasArray(kElementIds))
    {
      std::ranges::copy(ViewElementIds(grid, keeper), Element.begin());
    }
    else if (grid->GetNumberOfCells() == elements)
    {
      std::iota(Element.begin(), Element.end(), 0);
    }
    else
    {
      throw StaleData(std::string("the grid has ") + std::to_string(grid->GetNumberOfCells()) +
        " cells and coefficients of " + std::to_string(elements) +
        " elements, but no cell array '" + kElementIds +
        "' that tells which is which; pass that array on, or" + (kRemedy + 1));
    }
    std::vector<bool> seen(elements, false);
    for (std::size_t cell = 0; cell < Element.size(); ++cell)
    {
      const auto element = Element[cell];
      if (element < 0 || element >= elements)
      {
        Fail(cell, "names element " + std::to_string(element) + " of " + std::to_string(elements));
      }
      if (seen[element])
      {
        Fail(cell,
          "and another one both claim element " + std::to_string(element) +
            "; data sets were appended");
      }
      seen[element] = true;
    }
    Whole = static_cast<vtkIdType>(Element.size()) == elements && std::ranges::is_sorted(Element);
  }

  void Compare(std::span<const std::int64_t> now, std::span<const std::int64_t> then,
    const std::string& problem) const
  {
    for (std::size_t cell = 0; cell < Element.size(); ++cell)
    {
      if (now[cell] != then[Element[cell]])
      {
        Fail(cell, problem);
      }
    }
  }

  /// `values`, `stride` per element, in the order of the cells; a copy only where that is another.
  template <class T>
  std::span<const T> Select(
    std::span<const T> values, std::deque<std::vector<T>>& copies, int stride = 1) const
  {
    if (Whole)
    {
      return values;
    }
    auto& copy = copies.emplace_back();
    copy.reserve(Element.size() * stride);
    for (const auto element : Element)
    {
      const auto from = values.subspan(element * stride, stride);
      copy.insert(copy.end(), from.begin(), from.end());
    }
    return copy;
  }

private:
  [[noreturn]] static void Fail(std::size_t cell, const std::string& problem)
  {
    throw StaleData("cell " + std::to_string(cell) + " " + problem + kRemedy);
  }

  std::vector<std::int64_t> Element;
  bool Whole = false; ///< cell i is element i
};

/// Models that somebody holds, by grid: a filter, a mapper and the grid itself share one locator.
struct Registry
{
  std::mutex mutex;
  std::map<const vtkUnstructuredGrid*, std::weak_ptr<HighOrderModel>> models;

  static Registry& Instance()
  {
    static Registry registry;
    return registry;
  }
};
} // namespace

struct HighOrderModel::Internals
{
  ArrayKeeper keeper;
  std::deque<std::vector<Space>> spaces;
  std::deque<std::vector<std::int32_t>> ints;
  std::deque<std::vector<std::int64_t>> longs;
  std::deque<std::vector<double>> doubles;
  Mesh mesh;
  std::vector<Field> fields;
  std::span<const std::int64_t> sourceCells;
  // VTK's time stamps are unique in the process, so a new grid at an old address is told apart.
  const vtkUnstructuredGrid* grid = nullptr;
  vtkMTimeType time = 0;
  std::once_flag locatorOnce;
  std::unique_ptr<Locator> locator;
  std::atomic<bool> hasLocator{ false };

  Expansion Assemble(ExpansionView view, const CellElements& cells, int components)
  {
    Expansion expansion;
    expansion.spaces = spaces.emplace_back(std::move(view.spaces));
    expansion.spaceOf = cells.Select(view.spaceOf, ints);
    expansion.offset = cells.Select(view.offset, longs);
    expansion.coefficients = view.coefficients;
    expansion.components = components;
    return expansion;
  }

  void AddField(vtkUnstructuredGrid* source, const std::string& name, vtkIdType elements,
    const CellElements& cells)
  {
    const std::string prefix = kFieldPrefix + name + ".";
    const auto view = ViewExpansion(source, prefix, elements, keeper);
    const int components = ViewArray<std::int32_t>(source, prefix + "Components", 1, 1, keeper)[0];
    if (view.origin != Origin::Coefficients)
    {
      const auto prints =
        ViewArray<std::int64_t>(source, prefix + "Fingerprint", 1, elements, keeper);
      // An array that was dropped on the way cannot have been changed.
      if (vtkDataArray* nodal = FieldSource(source, name, view.origin))
      {
        cells.Compare(ValueFingerprints(source, nodal, view.origin), prints,
          "has other values of '" + name + "' than those its coefficients were made from");
      }
    }
    Field& field = fields.emplace_back();
    field.name = name;
    field.values = Assemble(view, cells, components);
    Validate(field, mesh);
  }
};

HighOrderModel::HighOrderModel(vtkUnstructuredGrid* grid)
  : Data(std::make_unique<Internals>())
{
  auto& d = *Data;
  if (!HasHighOrderArrays(grid))
  {
    throw InvalidData("the grid carries no high-order coefficients; pass it through "
                      "vtkUnstructuredGridToHighOrderGrid first.");
  }
  d.grid = grid;
  d.time = grid->GetMTime();
  const std::string prefix = kMeshPrefix;
  auto& keeper = d.keeper;
  auto view = ViewExpansion(grid, prefix, -1, keeper);
  const auto elements = static_cast<vtkIdType>(view.spaceOf.size());
  const auto centre = ViewArray<double>(grid, prefix + "Centre", 3, elements, keeper);
  const auto size = ViewArray<double>(grid, prefix + "Size", 1, elements, keeper);
  const auto uncertainty = ViewArray<double>(grid, prefix + "Uncertainty", 1, elements, keeper);
  const auto source = ViewArray<std::int64_t>(grid, prefix + "SourceCell", 1, elements, keeper);
  const auto prints = ViewArray<std::int64_t>(grid, prefix + "Fingerprint", 1, elements, keeper);

  const CellElements cells(grid, elements, keeper);
  cells.Compare(CellFingerprints(grid), prints,
    "is not the one that its coefficients were made from: it was cut, or its points were moved");
  d.mesh.map = d.Assemble(std::move(view), cells, 3);
  d.mesh.centre = cells.Select(centre, d.doubles, 3);
  d.mesh.size = cells.Select(size, d.doubles);
  d.mesh.uncertainty = cells.Select(uncertainty, d.doubles);
  d.sourceCells = cells.Select(source, d.longs);
  Validate(d.mesh);
  for (const auto& name : StoredFieldNames(grid))
  {
    d.AddField(grid, name, elements, cells);
  }
}

HighOrderModel::~HighOrderModel() = default;

std::shared_ptr<HighOrderModel> HighOrderModel::From(vtkUnstructuredGrid* grid)
{
  auto& registry = Registry::Instance();
  const std::scoped_lock lock(registry.mutex);
  std::erase_if(registry.models, [](const auto& entry) { return entry.second.expired(); });
  if (const auto known = registry.models.find(grid); known != registry.models.end())
  {
    if (auto model = known->second.lock(); model && model->IsCurrent(grid))
    {
      return model;
    }
  }
  std::shared_ptr<HighOrderModel> model(new HighOrderModel(grid));
  registry.models[grid] = model;
  return model;
}

const Mesh& HighOrderModel::GetMesh() const
{
  return Data->mesh;
}

std::span<const Field> HighOrderModel::Fields() const
{
  return Data->fields;
}

const Field* HighOrderModel::FindField(const std::string& name) const
{
  const auto found = std::ranges::find(Data->fields, name, &Field::name);
  return found == Data->fields.end() ? nullptr : &*found;
}

const Locator& HighOrderModel::GetLocator() const
{
  std::call_once(Data->locatorOnce,
    [this]
    {
      Data->locator = std::make_unique<Locator>(Data->mesh);
      Data->hasLocator = true;
    });
  return *Data->locator;
}

bool HighOrderModel::HasLocator() const
{
  return Data->hasLocator;
}

std::span<const std::int64_t> HighOrderModel::SourceCells() const
{
  return Data->sourceCells;
}

bool HighOrderModel::IsCurrent(vtkUnstructuredGrid* grid) const
{
  return grid == Data->grid && grid->GetMTime() == Data->time;
}
} // namespace pixelexact
