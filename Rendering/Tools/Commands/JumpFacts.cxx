// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/JumpFacts.h"

#include "Scene/Model.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Counted.h"
#include "Core/Faces/FaceJumps.h"
#include "Core/Location/Sample.h"
#include "Formats/Slab.h"

#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
constexpr std::size_t kMaxFacesListed = 10;
/// Jumps up to this part of the largest value count as rounding.
constexpr double kJumpRounding = 1e-12;

JumpsOfField Summarise(
  const LoadedModel& input, const Field& field, const FaceJumps& found, const Slab* slab)
{
  const HighOrderModel& model = *input.model;
  JumpsOfField facts;
  facts.name = field.name;
  facts.faces = static_cast<std::int64_t>(found.faces.size());
  facts.size = found.size;
  facts.notFinite = found.notFinite;
  facts.notFound = found.notFound;
  double square = 0.0;
  std::vector<const FaceJump*> order;
  order.reserve(found.faces.size());
  for (const FaceJump& face : found.faces)
  {
    order.push_back(&face);
    facts.largest = std::max(facts.largest, face.largest);
    facts.bound = std::max(facts.bound, face.bound);
    facts.proven += std::isfinite(face.bound) ? 1 : 0;
    facts.zero += face.largest <= kJumpRounding * found.size ? 1 : 0;
    square += face.square;
    facts.area += face.area;
  }
  if (found.notFinite + found.notFound > 0)
  {
    facts.bound = kInfinity; // of what is left out nothing is known
  }
  const double thickness = slab != nullptr ? slab->thickness : 1.0;
  facts.l2 = std::sqrt(square / thickness);
  facts.area /= thickness;
  std::ranges::stable_sort(
    order, [](const FaceJump* a, const FaceJump* b) { return a->largest > b->largest; });
  order.resize(std::min(order.size(), kMaxFacesListed));
  const auto cellOf = [&model](int element)
  { return model.SourceCells()[static_cast<std::size_t>(element)]; };
  for (const FaceJump* const face : order)
  {
    WorstFace& worst = facts.worst.emplace_back();
    worst.largest = face->largest;
    worst.bound = face->bound;
    worst.elements = { cellOf(face->face.element), cellOf(face->neighbour) };
    MapForward(
      model.GetMesh(), face->face.element, std::span(&face->xi, 1), std::span(&worst.position, 1));
    worst.position.z = slab != nullptr ? slab->middle : worst.position.z;
  }
  return facts;
}

std::string JumpText(double largest, double bound)
{
  return Short(largest, 9) +
    (std::isfinite(bound) ? ", proven at most " + Rounded(bound, true, 6)
                          : std::string(" (numeric)"));
}
} // namespace

JumpFacts FindJumpFacts(const LoadedModel& input, const std::vector<std::string>& names)
{
  const auto begin = std::chrono::steady_clock::now();
  const HighOrderModel& model = *input.model;
  model.RequireSolids("--jumps");
  const std::optional<Slab> slab = SlabOf(input.grid);
  JumpFacts facts;
  facts.isPlane = slab.has_value();
  ProgressLine line("comparing faces");
  double done = 0.0;
  for (const std::string& name : names)
  {
    const Field& field = model.GetField(name);
    const FaceJumps found = FindFaceJumps(model.GetLocator(), model.Faces(), field,
      [&](double part) { line((done + part) / static_cast<double>(names.size())); });
    facts.fields.push_back(Summarise(input, field, found, slab ? &*slab : nullptr));
    done += 1.0;
  }
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return facts;
}

void AddTo(Table& table, const JumpFacts& facts)
{
  std::string name = "jumps";
  for (const JumpsOfField& field : facts.fields)
  {
    const std::string faces = Counted(field.faces, "face") + " between elements";
    const bool isComplete = field.notFinite + field.notFound == 0;
    if (field.faces == 0)
    {
      table.Row(name, "{}: {}", field.name,
        isComplete ? "there is no face between elements" : "no face could be compared");
    }
    else if (isComplete && field.zero == field.faces)
    {
      table.Row(name, "{}: zero within rounding, {}, on {}", field.name,
        JumpText(field.largest, field.bound), faces);
    }
    else
    {
      table.Row(name, "{}: largest {}", field.name, JumpText(field.largest, field.bound));
      table.Row("", "  L2 {} over {} of {} {} (numeric)", Short(field.l2, 9), faces,
        facts.isPlane ? "length" : "area", Short(field.area, 9));
    }
    name.clear();
    if (field.proven < field.faces)
    {
      table.Row("", "  numeric on {}, proven on {}", Counted(field.faces - field.proven, "face"),
        field.proven);
    }
    if (field.notFinite > 0)
    {
      table.Row("", "  not finite on {}, left out", Counted(field.notFinite, "face"));
    }
    if (field.notFound > 0)
    {
      table.Row(
        "", "  the other side is not known at {}, left out", Counted(field.notFound, "place"));
    }
    for (const WorstFace& face : field.worst)
    {
      if (face.largest > kJumpRounding * field.size)
      {
        table.Row("", "  {}, elements {} and {}, at ({}, {}, {})",
          JumpText(face.largest, face.bound), face.elements[0], face.elements[1],
          Short(face.position.x, 9), Short(face.position.y, 9), Short(face.position.z, 9));
      }
    }
  }
  table.Row("", "compared in {} s", Short(facts.seconds));
}

void AddTo(nlohmann::ordered_json& summary, const JumpFacts& facts)
{
  auto fields = nlohmann::ordered_json::array();
  for (const JumpsOfField& field : facts.fields)
  {
    auto worst = nlohmann::ordered_json::array();
    for (const WorstFace& face : field.worst)
    {
      // A bound that is not known becomes null.
      worst.push_back(
        { { "largest", face.largest }, { "bound", face.bound }, { "elements", face.elements },
          { "position", { face.position.x, face.position.y, face.position.z } } });
    }
    fields.push_back(
      { { "field", field.name }, { "largest", field.largest }, { "bound", field.bound },
        { "zero_within_rounding",
          field.zero == field.faces && field.notFinite + field.notFound == 0 },
        { "l2", field.l2 }, { "area", field.area }, { "largest_value", field.size },
        { "faces", field.faces }, { "proven_faces", field.proven }, { "zero_faces", field.zero },
        { "not_finite_faces", field.notFinite }, { "not_found", field.notFound },
        { "worst", std::move(worst) } });
  }
  summary["jumps"] = { { "fields", std::move(fields) }, { "seconds", facts.seconds } };
}
} // namespace pixelexact
