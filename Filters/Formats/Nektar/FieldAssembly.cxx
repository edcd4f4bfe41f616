// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/Nektar/FieldBasis.h"
#include "Formats/Nektar/FieldFile.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace pixelexact::nektar
{
namespace
{
/// Where an element's coefficients are, and in which basis.
struct Placement
{
  FieldBlock* block = nullptr;
  const ElementData* data = nullptr;
  const ElementBasis* basis = nullptr;
};

std::string NameOf(const Expansion3& expansion)
{
  if (!expansion.IsPlane())
  {
    return Name(expansion.shape);
  }
  return expansion.shape == Shape::Prism ? "triangle" : "quadrilateral";
}
} // namespace

void AddFields(const std::vector<NamedText>& parts, SessionMesh& session)
{
  SolverModel& model = session.model;
  const SolverMesh& mesh = model.mesh;
  std::unordered_map<std::int64_t, int> elementOf;
  for (std::size_t e = 0; e < mesh.number.size(); ++e)
  {
    elementOf[mesh.number[e]] = static_cast<int>(e);
  }
  const auto shapeOf = [&mesh](int e) { return mesh.map.spaces[mesh.map.spaceOf[e]].shape; };
  std::vector<FieldFile> files;
  std::vector<Placement> places(mesh.number.size());
  std::map<Expansion3, ElementBasis> bases;
  std::vector<std::string> names;
  std::string basisName;
  files.reserve(parts.size());
  for (const NamedText& part : parts)
  {
    FieldFile& file = files.emplace_back(ReadFieldFile(part));
    model.time = file.time ? file.time : model.time;
    for (FieldBlock& block : file.blocks)
    {
      if (names.empty())
      {
        names = block.fields;
        basisName = Describe(block.expansions.empty() ? Expansion3{} : block.expansions.front());
      }
      if (block.fields != names)
      {
        throw InvalidData(part.name +
          ": its blocks hold different fields; write them anew with "
          "FieldConvert.");
      }
      for (const ElementData& data : block.elements)
      {
        const auto element = elementOf.find(data.id);
        const Expansion3& expansion = block.expansions[data.expansion];
        if (element == elementOf.end() || shapeOf(element->second) != expansion.shape ||
          expansion.IsPlane() != mesh.slab.has_value())
        {
          throw InvalidData(part.name + ": it has coefficients for " + NameOf(expansion) + " " +
            std::to_string(data.id) + ", which the mesh of " + std::to_string(mesh.number.size()) +
            " elements (" + session.name + ") has not; the two do not belong together.");
        }
        Placement& place = places[element->second];
        if (place.data)
        {
          throw InvalidData(
            part.name + ": element " + std::to_string(data.id) + " has coefficients twice.");
        }
        try
        {
          auto at = bases.find(expansion);
          at = at != bases.end() ? at : bases.emplace(expansion, MakeFieldBasis(expansion)).first;
          place = { &block, &data, &at->second };
        }
        catch (const Unsupported& error)
        {
          throw Unsupported(part.name + ": " + error.what());
        }
        catch (const InvalidData& error)
        {
          throw InvalidData(part.name + ": " + error.what());
        }
      }
    }
  }
  const auto missing = std::ranges::count(places, nullptr, &Placement::data);
  if (missing > 0 || names.empty())
  {
    const auto first = std::ranges::find(places, nullptr, &Placement::data);
    throw InvalidData(parts.front().name + ": it holds coefficients for " +
      std::to_string(mesh.number.size() - missing) + " of the mesh's " +
      std::to_string(mesh.number.size()) + " elements; element " +
      (missing > 0 ? std::to_string(mesh.number[first - places.begin()]) : "0") +
      " has none. The field belongs to another mesh, or parts are missing.");
  }
  std::vector<const ElementBasis*> ordered;
  std::ranges::transform(places, std::back_inserter(ordered), &Placement::basis);
  const auto beginOf = [](const Placement& place, std::size_t f, std::size_t plane)
  { return f * place.block->perField + place.data->offset + plane * place.data->count; };
  for (Placement& place : places)
  {
    const auto& along = place.block->homogeneous;
    const std::size_t planes = along ? along->functions.size() : 1;
    for (std::size_t f = 0; f < names.size(); ++f)
    {
      for (std::size_t plane = 0; plane < planes; ++plane)
      {
        place.block->values.Expect(beginOf(place, f, plane), place.data->count);
      }
    }
  }
  const auto assemble = [&](std::size_t f, std::size_t plane)
  {
    return AssembleField(ordered, 1,
      [&](std::size_t e, std::span<double> source)
      {
        Placement& place = places[e];
        place.block->values.Take(beginOf(place, f, plane), source.first(place.data->count));
      });
  };
  const auto& homogeneous = places.front().block->homogeneous;
  if (std::ranges::any_of(
        places, [&](const Placement& place) { return place.block->homogeneous != homogeneous; }))
  {
    throw Unsupported(parts.front().name +
      ": its blocks differ in their functions or lengths along z; join them (FieldConvert in.fld "
      "out.fld).");
  }
  std::vector<HomogeneousField> along;
  for (std::size_t f = 0; f < names.size(); ++f)
  {
    if (!homogeneous)
    {
      SolverField field;
      field.name = names[f];
      field.basis = basisName;
      field.values = assemble(f, 0);
      model.fields.push_back(std::move(field));
      continue;
    }
    HomogeneousField& field = along.emplace_back();
    field.name = names[f];
    field.basis = basisName;
    for (std::size_t plane = 0; plane < homogeneous->functions.size(); ++plane)
    {
      field.planes.push_back(assemble(f, plane));
    }
  }
  if (homogeneous)
  {
    try
    {
      LiftHomogeneous(*homogeneous, along, model);
    }
    catch (const Unsupported& error)
    {
      throw Unsupported(parts.front().name + ": " + error.what());
    }
  }
}
} // namespace pixelexact::nektar
