// SPDX-License-Identifier: BSD-3-Clause
#include "HighOrderModel.h"

#include "ArrayViews.h"
#include "Core/Base/Error.h"
#include "Fingerprint.h"
#include "MeshPart.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace pixelexact
{
namespace
{
/// Models that somebody holds, by grid: a filter, a mapper and the grid itself share one.
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
  std::shared_ptr<const MeshPart> part;
  ViewStorage storage;
  std::vector<Field> fields;
  // VTK's time stamps are unique in the process, so a new grid at an old address is told apart.
  const vtkUnstructuredGrid* grid = nullptr;
  vtkMTimeType time = 0;

  void AddField(vtkUnstructuredGrid* source, const std::string& name)
  {
    const std::string prefix = kFieldPrefix + name + ".";
    const vtkIdType elements = part->StoredElements();
    auto& keeper = storage.arrays;
    const auto view = ViewExpansion(source, prefix, elements, keeper);
    const int components = ViewArray<std::int32_t>(source, prefix + "Components", 1, 1, keeper)[0];
    if (view.origin != Origin::Coefficients)
    {
      const auto prints =
        ViewArray<std::int64_t>(source, prefix + "Fingerprint", 1, elements, keeper);
      // An array that was dropped on the way cannot have been changed.
      if (vtkDataArray* nodal = FieldSource(source, name, view.origin))
      {
        part->Cells().Compare([&](Hash hash)
          { return ValueFingerprints(source, nodal, view.origin, hash); },
          prints, "has other values of '" + name + "' than those its coefficients were made from");
      }
    }
    Field& field = fields.emplace_back();
    field.name = name;
    field.values = storage.Assemble(view, part->Cells(), components);
    field.mapping = ReadMapping(source, prefix);
    Validate(field, part->GetMesh());
  }
};

HighOrderModel::HighOrderModel(vtkUnstructuredGrid* grid)
  : Data(std::make_unique<Internals>())
{
  if (!HasHighOrderArrays(grid))
  {
    throw InvalidData("the grid carries no high-order coefficients; pass it through "
                      "vtkUnstructuredGridToHighOrderGrid first.");
  }
  Data->grid = grid;
  Data->time = grid->GetMTime();
  Data->part = MeshPart::Of(grid);
  for (const auto& name : StoredFieldNames(grid))
  {
    Data->AddField(grid, name);
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
  return Data->part->GetMesh();
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
  return Data->part->GetLocator();
}

bool HighOrderModel::HasLocator() const
{
  return Data->part->HasLocator();
}

std::span<const std::int64_t> HighOrderModel::SourceCells() const
{
  return Data->part->SourceCells();
}

bool HighOrderModel::IsCurrent(vtkUnstructuredGrid* grid) const
{
  return grid == Data->grid && grid->GetMTime() == Data->time;
}
} // namespace pixelexact
