// SPDX-License-Identifier: BSD-3-Clause
#include "Input/SolverFacts.h"

#include "Base/Report.h"

#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include <nlohmann/json.hpp>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <utility>

namespace pixelexact
{
namespace
{
using Counts = std::map<int, std::int64_t>;

constexpr std::size_t kMaxListed = 12;

Counts Count(vtkDataArray* array)
{
  Counts counts;
  for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfTuples(); ++i)
  {
    ++counts[static_cast<int>(array->GetComponent(i, 0))];
  }
  return counts;
}

std::string NameOf(const SolverFacts& facts, int id, bool boundary)
{
  std::string names;
  for (const auto& group : facts.groups)
  {
    if (group.id == id && group.boundary == boundary)
    {
      names += (names.empty() ? " '" : ", '") + group.name + "'";
    }
  }
  return names;
}

void AddRow(Table& table, const char* label, const char* what, const SolverFacts& facts,
  const Counts& counts, bool boundary)
{
  std::vector<std::string> entries;
  for (const auto& [id, count] : counts)
  {
    if (entries.size() == kMaxListed)
    {
      entries.push_back(fmt::format("and {} more", counts.size() - kMaxListed));
      break;
    }
    entries.push_back(fmt::format(
      "{}{} ({} {}{})", id, NameOf(facts, id, boundary), count, what, count == 1 ? "" : "s"));
  }
  if (!entries.empty())
  {
    table.Row(label, Listed(entries));
  }
}

nlohmann::ordered_json ToJson(const Counts& counts)
{
  auto object = nlohmann::ordered_json::object();
  for (const auto& [id, count] : counts)
  {
    object[std::to_string(id)] = count;
  }
  return object;
}
} // namespace

SolverFacts GatherSolverFacts(vtkUnstructuredGrid& grid, const HighOrderModel& model)
{
  SolverFacts facts;
  vtkFieldData* data = grid.GetFieldData();
  vtkDataArray* ids = data->GetArray("PixelExact.Groups.Id");
  vtkDataArray* boundary = data->GetArray("PixelExact.Groups.Boundary");
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("PixelExact.Groups.Name"));
  // Checks the arrays, because any grid may have arrays with these names.
  const bool sound = ids != nullptr && boundary != nullptr && names != nullptr &&
    ids->GetNumberOfValues() == names->GetNumberOfValues() &&
    boundary->GetNumberOfValues() == names->GetNumberOfValues();
  const auto isOfFaces = [&](vtkIdType i) { return boundary->GetComponent(i, 0) != 0.0; };
  // The faces of a surface in space are its elements, whose groups name them.
  bool elementsNameFaces = false;
  for (vtkIdType i = 0; sound && model.IsShell() && i < names->GetNumberOfValues(); ++i)
  {
    elementsNameFaces = elementsNameFaces || !isOfFaces(i);
  }
  for (vtkIdType i = 0; sound && i < names->GetNumberOfValues(); ++i)
  {
    if (!names->GetValue(i).empty() && !(elementsNameFaces && isOfFaces(i)))
    {
      facts.groups.push_back({ static_cast<int>(ids->GetComponent(i, 0)),
        elementsNameFaces || isOfFaces(i), names->GetValue(i) });
    }
  }
  if (HasHighOrderArrays(&grid))
  {
    facts.attributes = Count(grid.GetCellData()->GetArray("Attribute"));
  }
  facts.boundaryAttributes = CountByAttribute(model.BoundaryFaces());
  return facts;
}

std::string BasisOf(vtkUnstructuredGrid& grid, const std::string& field)
{
  auto* basis = vtkStringArray::SafeDownCast(
    grid.GetFieldData()->GetAbstractArray((kFieldPrefix + field + ".Basis").c_str()));
  return basis != nullptr && basis->GetNumberOfValues() > 0 ? basis->GetValue(0) : std::string();
}

void AddTo(Table& table, const SolverFacts& facts)
{
  AddRow(table, "attributes", "element", facts, facts.attributes, false);
  AddRow(table, "boundary", "face", facts, facts.boundaryAttributes, true);
}

void AddTo(nlohmann::ordered_json& summary, const SolverFacts& facts)
{
  auto groups = nlohmann::ordered_json::array();
  for (const auto& group : facts.groups)
  {
    groups.push_back(
      { { "id", group.id }, { "name", group.name }, { "boundary", group.boundary } });
  }
  summary["attributes"] = ToJson(facts.attributes);
  summary["boundary_attributes"] = ToJson(facts.boundaryAttributes);
  summary["groups"] = std::move(groups);
}
} // namespace pixelexact
