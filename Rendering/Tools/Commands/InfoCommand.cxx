// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Report.h"
#include "Commands/RequestedFacts.h"
#include "Input/OrderCounts.h"
#include "Input/SolverFacts.h"
#include "Input/StoredOrder.h"
#include "Scene/FoundRanges.h"
#include "Scene/Model.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Counted.h"
#include "Formats/Slab.h"
#include "Grids/Continuity.h"

#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
struct InfoOptions
{
  InputRequest input;
  FactRequests requests;
};

struct FieldFacts
{
  const Field* field = nullptr;
  OrderCounts orders;
  Continuity continuity;
  std::int64_t nonFiniteElements = 0;
  std::string basis; ///< as the solver's file names it
  FoundRanges ranges;
};

struct Facts
{
  std::array<std::int64_t, kShapeCount> shapes{};
  OrderCounts storedOrders; ///< of the file's cells
  OrderCounts orders;       ///< of the geometry, without orders that hold nothing but rounding
  std::vector<FieldFacts> fields;
  std::array<double, 6> bounds{};     ///< of the curved elements: x, y, z, lower and upper each
  std::array<double, 6> nodeBounds{}; ///< of the nodes, or of a solver's corners
  std::optional<Slab> slab;           ///< of a plane mesh
  std::size_t coefficientBytes = 0;   ///< of the geometry and all fields
  SolverFacts solver;
  RequestedFacts requested;
};

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
  facts.slab = SlabOf(input.grid);
  const bool isPlane = facts.slab.has_value();
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    ++facts.shapes[static_cast<std::size_t>(mesh.ShapeOf(e))];
    // The cells stored with a solver's coefficients only have their corners.
    const int stored = input.converted ? StoredOrder(*input.grid, e) : 0;
    if (stored > 0)
    {
      ++facts.storedOrders[{ stored, stored, isPlane ? kPlane : stored }];
    }
  }
  facts.orders = CountOrders(mesh.map, isPlane);
  facts.coefficientBytes = mesh.map.coefficients.size_bytes();
  const std::span<const Field> fields = input.model->Fields();
  const std::vector<Continuity> continuity = CompareAcrossElements(mesh, fields);
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    facts.fields.push_back({ &fields[f], CountOrders(fields[f].values, isPlane), continuity[f],
      CountNonFinite(fields[f].values), BasisOf(*input.grid, fields[f].name),
      FindRanges(mesh, fields[f]) });
    facts.coefficientBytes += fields[f].values.coefficients.size_bytes();
  }
  input.grid->GetBounds(facts.nodeBounds.data());
  facts.bounds = mesh.Elements() > 0 ? FindBounds(mesh) : facts.nodeBounds;
  if (isPlane && !facts.slab->inSpace)
  {
    for (auto* bounds : { &facts.bounds, &facts.nodeBounds })
    {
      (*bounds)[4] = (*bounds)[5] = facts.slab->middle;
    }
  }
  facts.solver = GatherSolverFacts(*input.grid, *input.model);
  return facts;
}

/// The name of an element's shape; in a plane mesh that of its plane shape.
std::string NameOf(Shape shape, bool isPlane)
{
  return isPlane ? PlaneName(shape) : Name(shape);
}

/// "hexahedron", or "hexahedra" of any other number than one.
std::string CountedName(std::string name, std::int64_t count)
{
  if (count == 1)
  {
    return name;
  }
  if (name.ends_with("on"))
  {
    name.resize(name.size() - 2);
    return name + "a";
  }
  return name + "s";
}

const char* ContinuityName(const Continuity& continuity)
{
  if (continuity.comparisons == 0)
  {
    return "unknown";
  }
  return continuity.IsContinuous() ? "continuous" : "discontinuous";
}

/// Bounds computed from coefficients contain roundings in place of 0.
std::array<double, 6> WithoutRoundings(std::array<double, 6> bounds)
{
  double largest = 0.0;
  for (const double bound : bounds)
  {
    largest = std::max(largest, std::fabs(bound));
  }
  std::ranges::transform(bounds, bounds.begin(),
    [largest](double bound) { return pixelexact::WithoutRoundings(bound, largest); });
  return bounds;
}

void PrintTable(const LoadedModel& input, const Facts& facts)
{
  Table table;
  std::vector<std::string> shapes;
  for (int s = 0; s < kShapeCount; ++s)
  {
    if (const std::int64_t count = facts.shapes[static_cast<std::size_t>(s)]; count > 0)
    {
      shapes.push_back(fmt::format(
        "{} {}", count, CountedName(NameOf(static_cast<Shape>(s), facts.slab.has_value()), count)));
    }
  }
  table.Row("elements", "{}{}{}", input.model->GetMesh().Elements(), shapes.empty() ? "" : ": ",
    Listed(shapes));
  if (input.skippedCells > 0)
  {
    table.Row("skipped", "{} of another dimension", Counted(input.skippedCells, "cell"));
  }
  table.Row("geometry", "order {}{}", Text(facts.orders),
    facts.storedOrders.empty() || facts.storedOrders == facts.orders
      ? std::string()
      : ", stored as order " + Text(facts.storedOrders));
  const std::array<double, 6> b = WithoutRoundings(facts.bounds);
  const std::string sides =
    fmt::format("x {} to {}, y {} to {}", Short(b[0]), Short(b[1]), Short(b[2]), Short(b[3]));
  if (facts.slab && facts.slab->inSpace)
  {
    table.Row("surface", "2-D, in space; shown as the boundary");
  }
  if (facts.slab && !facts.slab->inSpace)
  {
    table.Row("plane", "2-D, at z = {}; shown as a slab {} thick", Short(facts.slab->middle),
      Short(facts.slab->thickness));
    table.Row("bounds", sides);
  }
  else
  {
    table.Row("bounds", "{}, z {} to {}", sides, Short(b[4]), Short(b[5]));
  }
  AddTime(table, input);
  std::string name = "fields";
  for (const FieldFacts& field : facts.fields)
  {
    const int components = field.field->values.components;
    std::string text = fmt::format("{}: {}, order {}", field.field->name,
      components == 1 ? "scalar" : fmt::format("{} components", components), Text(field.orders));
    if (field.continuity.comparisons > 0)
    {
      text += fmt::format(", {}", ContinuityName(field.continuity));
    }
    if (!field.basis.empty())
    {
      text += ", " + field.basis;
    }
    if (field.nonFiniteElements > 0)
    {
      text += ", not finite in " + Counted(field.nonFiniteElements, "element");
    }
    table.Row(name, text);
    name.clear();
    AddTo(table, field.ranges);
  }
  if (facts.fields.empty())
  {
    table.Row(name, "none");
  }
  name = "defined";
  for (const auto& [defined, text] : input.model->Definitions())
  {
    table.Row(name, "{}: {}", defined, text);
    name.clear();
  }
  name = "parameters";
  for (const auto& [parameter, value] : input.model->Parameters())
  {
    table.Row(name, "{} = {}", parameter, Short(value));
    name.clear();
  }
  AddTo(table, facts.solver);
  AddTo(table, input, facts.requested);
  table.Row(
    "coefficients", input.converted ? "made from the file's nodal values" : "as in the file");
  table.Print();
}

void PrintJson(const LoadedModel& input, const Facts& facts)
{
  auto shapes = nlohmann::ordered_json::object();
  for (int s = 0; s < kShapeCount; ++s)
  {
    if (const std::int64_t count = facts.shapes[static_cast<std::size_t>(s)]; count > 0)
    {
      shapes[NameOf(static_cast<Shape>(s), facts.slab.has_value())] = count;
    }
  }
  auto fields = nlohmann::ordered_json::array();
  for (const FieldFacts& one : facts.fields)
  {
    nlohmann::ordered_json field{ { "name", one.field->name },
      { "components", one.field->values.components }, { "orders", ToJson(one.orders) },
      { "orders_per_direction", DirectionsToJson(one.orders) }, { "basis", one.basis },
      { "continuity", ContinuityName(one.continuity) },
      { "largest_jump", one.continuity.largestJump },
      { "non_finite_elements", one.nonFiniteElements } };
    AddTo(field, one.ranges);
    if (facts.requested.certified)
    {
      const auto found = std::ranges::find(
        facts.requested.certified->fields, one.field->name, &CertifiedField::name);
      if (found != facts.requested.certified->fields.end())
      {
        field["certified"] = ToJson(*found);
      }
    }
    fields.push_back(std::move(field));
  }
  nlohmann::ordered_json summary{ { "elements", input.model->GetMesh().Elements() },
    { "shapes", shapes }, { "skipped_cells", input.skippedCells },
    { "geometry_orders", ToJson(facts.orders) },
    { "stored_geometry_orders", ToJson(facts.storedOrders) }, { "bounds", facts.bounds },
    { "node_bounds", facts.nodeBounds },
    // The cells stored with a solver's coefficients only have their corners.
    { "node_bounds_of", input.converted ? "nodes" : "corners" }, { "fields", fields },
    { "defined", input.model->Definitions() }, { "parameters", input.model->Parameters() } };
  summary["dimension"] = facts.slab ? 2 : 3;
  if (facts.slab && !facts.slab->inSpace)
  {
    summary["slab"] = { { "z", facts.slab->middle }, { "thickness", facts.slab->thickness } };
  }
  AddTo(summary, facts.solver);
  AddTo(summary, input, facts.requested);
  AddTime(summary, input);
  summary.update({ { "times", input.times }, { "converted", input.converted },
    { "coefficient_bytes", facts.coefficientBytes }, { "diagnostics", input.diagnostics } });
  Print(summary);
}

void Info(const InfoOptions& options, const CommonOptions& common)
{
  options.requests.Check(options.input, common.json);
  Stopwatch stopwatch;
  const LoadedModel input = LoadModel(options.input, {}, stopwatch);
  Facts facts = Gather(input);
  facts.requested = options.requests.Find(input, options.input);
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
  const auto options = std::make_shared<InfoOptions>();
  CLI::App& command = AddCommand(program, "info",
    "Tell what a mesh file holds, and between which values its fields are, to a thousandth",
    [options, &common, &action] { action = [options, &common] { Info(*options, common); }; });
  options->input.AddTo(command);
  options->requests.AddTo(command);
}
} // namespace pixelexact
