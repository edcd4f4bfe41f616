// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Continuity.h"
#include "Input.h"
#include "Json.h"
#include "Model.h"
#include "Report.h"
#include "SolverFacts.h"
#include "StoredOrder.h"

#include "Core/Base/Error.h"

#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>

namespace pixelexact
{
namespace
{
struct InfoOptions
{
  InputRequest input;
  bool certify = false;
};

/// Elements by polynomial orders along the three directions.
using Orders = std::array<int, 3>;
using OrderCounts = std::map<Orders, std::int64_t>;

struct FieldFacts
{
  const Field* field = nullptr;
  OrderCounts orders;
  Continuity continuity;
  std::int64_t nonFiniteElements = 0;
  std::string basis; ///< as the solver's file names it
};

struct Facts
{
  std::array<std::int64_t, kShapeCount> shapes{};
  OrderCounts storedOrders; ///< of the file's cells
  OrderCounts orders;       ///< of the geometry, without orders that hold nothing but rounding
  std::vector<FieldFacts> fields;
  std::array<double, 6> bounds{}; ///< of the nodes: x, y, z, lower and upper each
  SolverFacts solver;
};

Orders OrdersOf(const Space& space)
{
  Orders orders{ space.order[0], space.order[1], space.order[2] };
  if (space.form == Form::Tensor)
  {
    // The third one only makes room for the factors of the pyramid's collapse.
    orders[2] = std::max(orders[0], orders[1]);
  }
  return orders;
}

/// "3", or where the directions differ "3 x 5 x 7".
std::string Label(const Orders& orders)
{
  const auto [p, q, r] = orders;
  return p == q && q == r
    ? std::to_string(p)
    : std::to_string(p) + " x " + std::to_string(q) + " x " + std::to_string(r);
}

OrderCounts CountOrders(const Expansion& expansion)
{
  OrderCounts counts;
  for (int e = 0; e < expansion.Elements(); ++e)
  {
    ++counts[OrdersOf(expansion.SpaceOf(e))];
  }
  return counts;
}

std::int64_t CountNonFinite(const Expansion& expansion)
{
  std::int64_t count = 0;
  for (int e = 0; e < expansion.Elements(); ++e)
  {
    const double* begin = expansion.Coefficients(e);
    const std::ptrdiff_t size =
      static_cast<std::ptrdiff_t>(expansion.components) * expansion.SpaceOf(e).Modes();
    count += std::all_of(begin, begin + size, [](double c) { return std::isfinite(c); }) ? 0 : 1;
  }
  return count;
}

Facts Gather(const LoadedModel& input)
{
  const Mesh& mesh = input.model->GetMesh();
  Facts facts;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    ++facts.shapes[static_cast<std::size_t>(mesh.ShapeOf(e))];
    // The cells beside a solver's own coefficients are but their corners.
    const int stored = input.converted ? StoredOrder(*input.grid, e) : 0;
    if (stored > 0)
    {
      ++facts.storedOrders[{ stored, stored, stored }];
    }
  }
  facts.orders = CountOrders(mesh.map);
  const std::span<const Field> fields = input.model->Fields();
  const std::vector<Continuity> continuity = CompareAcrossElements(mesh, fields);
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    facts.fields.push_back({ &fields[f], CountOrders(fields[f].values), continuity[f],
      CountNonFinite(fields[f].values), BasisOf(*input.grid, fields[f].name) });
  }
  input.grid->GetBounds(facts.bounds.data());
  facts.solver = GatherSolverFacts(*input.grid);
  return facts;
}

const char* ContinuityName(const Continuity& continuity)
{
  if (continuity.comparisons == 0)
  {
    return "unknown";
  }
  return continuity.IsContinuous() ? "continuous" : "discontinuous";
}

/// "3" or, for several, "3 (40 elements), 4 (2 elements)".
std::string Text(const OrderCounts& counts)
{
  std::string text;
  for (const auto& [orders, count] : counts)
  {
    text += (text.empty() ? "" : ", ") + Label(orders) +
      (counts.size() > 1 ? " (" + std::to_string(count) + " elements)" : std::string());
  }
  return text.empty() ? "none" : text;
}

void PrintTable(const LoadedModel& input, const Facts& facts)
{
  Table table;
  std::string shapes;
  for (int s = 0; s < kShapeCount; ++s)
  {
    if (const std::int64_t count = facts.shapes[static_cast<std::size_t>(s)]; count > 0)
    {
      shapes +=
        (shapes.empty() ? ": " : ", ") + std::to_string(count) + " " + Name(static_cast<Shape>(s));
    }
  }
  table.Row("elements", std::to_string(input.model->GetMesh().Elements()) + shapes);
  if (input.skippedCells > 0)
  {
    table.Row("skipped", std::to_string(input.skippedCells) + " cells of lower dimension");
  }
  table.Row("geometry",
    "order " + Text(facts.orders) +
      (facts.storedOrders.empty() || facts.storedOrders == facts.orders
          ? std::string()
          : ", stored as order " + Text(facts.storedOrders)));
  const auto& b = facts.bounds;
  table.Row("nodes",
    "x " + Short(b[0]) + " to " + Short(b[1]) + ", y " + Short(b[2]) + " to " + Short(b[3]) +
      ", z " + Short(b[4]) + " to " + Short(b[5]));
  AddTime(table, input);
  std::string name = "fields";
  for (const FieldFacts& field : facts.fields)
  {
    const int components = field.field->values.components;
    std::string text = field.field->name + ": " +
      (components == 1 ? "scalar" : std::to_string(components) + " components") + ", order " +
      Text(field.orders);
    if (field.continuity.comparisons > 0)
    {
      text += std::string(", ") + ContinuityName(field.continuity);
    }
    if (!field.basis.empty())
    {
      text += ", " + field.basis;
    }
    if (field.nonFiniteElements > 0)
    {
      text += ", not finite in " + std::to_string(field.nonFiniteElements) + " elements";
    }
    table.Row(name, text);
    name.clear();
  }
  if (facts.fields.empty())
  {
    table.Row(name, "none");
  }
  AddTo(table, facts.solver);
  table.Row(
    "coefficients", input.converted ? "made from the file's nodal values" : "as in the file");
  table.Print();
}

/// Elements by the highest of their orders.
json::Object ToJson(const OrderCounts& counts)
{
  std::map<int, std::int64_t> highest;
  for (const auto& [orders, count] : counts)
  {
    highest[std::ranges::max(orders)] += count;
  }
  json::Object object;
  for (const auto& [order, count] : highest)
  {
    object.Add(std::to_string(order), count);
  }
  return object;
}

/// Elements by "3 x 5 x 7".
json::Object DirectionsToJson(const OrderCounts& counts)
{
  json::Object object;
  for (const auto& [orders, count] : counts)
  {
    object.Add(Label(orders), count);
  }
  return object;
}

void PrintJson(const LoadedModel& input, const Facts& facts)
{
  json::Object shapes;
  for (int s = 0; s < kShapeCount; ++s)
  {
    if (const std::int64_t count = facts.shapes[static_cast<std::size_t>(s)]; count > 0)
    {
      shapes.Add(Name(static_cast<Shape>(s)), count);
    }
  }
  std::vector<json::Object> fields;
  for (const FieldFacts& one : facts.fields)
  {
    json::Object field;
    field.Add("name", one.field->name).Add("components", one.field->values.components);
    field.Add("orders", ToJson(one.orders));
    field.Add("orders_per_direction", DirectionsToJson(one.orders));
    field.Add("basis", one.basis);
    field.Add("continuity", ContinuityName(one.continuity));
    field.Add("largest_jump", one.continuity.largestJump);
    field.Add("non_finite_elements", one.nonFiniteElements);
    fields.push_back(field);
  }
  std::vector<std::string> diagnostics;
  for (const std::string& line : input.diagnostics)
  {
    diagnostics.push_back(json::Text(line));
  }
  json::Object summary;
  summary.Add("elements", input.model->GetMesh().Elements()).Add("shapes", shapes);
  summary.Add("skipped_cells", input.skippedCells);
  summary.Add("geometry_orders", ToJson(facts.orders));
  summary.Add("stored_geometry_orders", ToJson(facts.storedOrders));
  summary.Add("node_bounds", facts.bounds).Add("fields", fields);
  AddTo(summary, facts.solver);
  AddTime(summary, input);
  summary.Add("times", input.times);
  summary.Add("converted", input.converted).Raw("diagnostics", json::Array(diagnostics));
  std::cout << summary.String() << '\n';
}

void Info(const InfoOptions& options, const CommonOptions& common)
{
  if (options.certify)
  {
    throw Unsupported("--certify is not available yet; leave it out");
  }
  Stopwatch stopwatch;
  const LoadedModel input = LoadModel(options.input, {}, stopwatch);
  const Facts facts = Gather(input);
  if (common.json)
  {
    PrintJson(input, facts);
    return;
  }
  PrintTable(input, facts);
  WarnOfDiagnostics(input);
}
} // namespace

void AddInfoCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  CLI::App* command = program.add_subcommand("info", "Tell what a mesh file holds");
  const auto options = std::make_shared<InfoOptions>();
  options->input.AddTo(*command);
  command->add_flag("--certify", options->certify,
    "Also prove field ranges and the sign of det J (not available yet)");
  command->callback(
    [options, &common, &action] { action = [options, &common] { Info(*options, common); }; });
}
} // namespace pixelexact
