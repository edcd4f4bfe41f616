// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/FileText.h"
#include "Formats/Nektar/Fields/FieldBasis.h"
#include "Formats/Nektar/Fields/FieldFile.h"
#include "Formats/Nektar/Reader.h"

#include <algorithm>
#include <deque>
#include <map>
#include <unordered_map>

namespace pixelexact::nektar
{
namespace
{
/// The place of an element's coefficients, and their basis.
struct Placement
{
  FieldBlock* block = nullptr;
  const ElementData* data = nullptr;
  const ElementBasis* basis = nullptr;
};

/// Builds the fields of a file's parts, after finding each element's coefficients.
class FieldBuilder
{
public:
  FieldBuilder(const std::vector<NamedText>& parts, SessionMesh& session)
    : Name(parts.front().name)
    , Session(session)
  {
    const std::vector<std::int64_t>& numbers = Session.model.mesh.number;
    for (std::size_t e = 0; e < numbers.size(); ++e)
    {
      ElementOf[numbers[e]] = static_cast<int>(e);
    }
    for (const NamedText& part : parts)
    {
      FieldFile& file = Files.emplace_back(ReadFieldFile(part));
      Session.model.time = file.time ? file.time : Session.model.time;
      Session.model.notes.insert(Session.model.notes.end(), file.notes.begin(), file.notes.end());
      for (FieldBlock& block : file.blocks)
      {
        Enlist(block, part.name);
      }
    }
    std::ranges::sort(Strips);
    RequireEnough();
    Places.resize(Strips.size() * numbers.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      for (FieldBlock& block : Files[k].blocks)
      {
        Place(block, parts[k].name);
      }
    }
    RequireAll();
    for (Placement& place : Places)
    {
      Bases.push_back(place.basis);
      for (std::size_t f = 0; f < Names.size(); ++f)
      {
        for (std::size_t plane = 0; plane < Planes(); ++plane)
        {
          place.block->values.Expect(BeginOf(place, f, plane), place.data->count);
        }
      }
    }
  }

  void Build()
  {
    if (Along)
    {
      BuildHomogeneous();
      return;
    }
    for (std::size_t f = 0; f < Names.size(); ++f)
    {
      SolverField field;
      field.name = Names[f];
      field.basis = BasisName;
      field.values = Assemble(f, 0, 0);
      Session.model.fields.push_back(std::move(field));
    }
  }

private:
  /// Checks that a block has the same fields and homogeneous functions as the others, and records
  /// its strip.
  void Enlist(const FieldBlock& block, const std::string& part)
  {
    if (Names.empty())
    {
      Names = block.fields;
      BasisName = Describe(block.expansions.empty() ? Expansion3{} : block.expansions.front());
      Along = block.homogeneous;
    }
    if (block.fields != Names)
    {
      throw InvalidData(
        part + ": its blocks hold different fields; write them again with FieldConvert.");
    }
    if (block.homogeneous != Along)
    {
      throw Unsupported(part +
        ": its blocks differ in their homogeneous functions or lengths; join them (FieldConvert "
        "in.fld out.fld).");
    }
    Coefficients += block.elements.size();
    if (std::ranges::find(Strips, block.strip) == Strips.end())
    {
      Strips.push_back(block.strip);
    }
  }

  [[nodiscard]] std::string InStrips() const
  {
    return Strips.size() > 1 ? " in " + std::to_string(Strips.size()) + " strips" : "";
  }

  /// Throws where the file has too few coefficients, so that the result's size is in proportion to
  /// the file.
  void RequireEnough() const
  {
    const std::size_t elements = Session.model.mesh.number.size();
    if (Names.empty() || (Strips.size() > 1 && Coefficients < Strips.size() * elements))
    {
      const std::size_t all = std::max(Strips.size(), std::size_t{ 1 }) * elements;
      throw InvalidData(Name + ": it holds coefficients for " + std::to_string(Coefficients) +
        " of the mesh's " + std::to_string(all) + " elements" + InStrips() +
        ". The field belongs to another mesh, or parts are missing.");
    }
  }

  void Place(FieldBlock& block, const std::string& part)
  {
    const SolverMesh& mesh = Session.model.mesh;
    const auto strip =
      static_cast<std::size_t>(std::ranges::find(Strips, block.strip) - Strips.begin());
    for (const ElementData& data : block.elements)
    {
      const auto element = ElementOf.find(data.id);
      const Expansion3& expansion = block.expansions[static_cast<std::size_t>(data.expansion)];
      const auto shapeOf = [&mesh](int e)
      {
        const auto space = mesh.map.spaceOf[static_cast<std::size_t>(e)];
        return mesh.map.spaces[static_cast<std::size_t>(space)].shape;
      };
      if (element == ElementOf.end() || shapeOf(element->second) != expansion.shape ||
        expansion.IsPlane() != mesh.slab.has_value() || expansion.IsLine() != Session.isLine)
      {
        throw InvalidData(part + ": it has coefficients for " + NameOf(expansion) + " " +
          std::to_string(data.id) + ", which the mesh of " + std::to_string(mesh.number.size()) +
          " elements (" + Session.name + ") has not; the two do not belong together.");
      }
      Placement& place =
        Places[strip * mesh.number.size() + static_cast<std::size_t>(element->second)];
      if (place.data)
      {
        throw InvalidData(part + ": element " + std::to_string(data.id) +
          " has coefficients twice" +
          (Strips.size() > 1 ? " in strip " + std::to_string(block.strip) : "") + ".");
      }
      place = { &block, &data, BasisOf(expansion, part) };
    }
  }

  const ElementBasis* BasisOf(const Expansion3& expansion, const std::string& part)
  {
    auto at = KnownBases.find(expansion);
    if (at == KnownBases.end())
    {
      at =
        KnownBases.emplace(expansion, NameErrors(part, [&] { return MakeFieldBasis(expansion); }))
          .first;
    }
    return &at->second;
  }

  void RequireAll() const
  {
    const auto first = std::ranges::find(Places, nullptr, &Placement::data);
    if (first == Places.end())
    {
      return;
    }
    const auto missing =
      static_cast<std::size_t>(std::ranges::count(Places, nullptr, &Placement::data));
    const std::vector<std::int64_t>& numbers = Session.model.mesh.number;
    const auto at = static_cast<std::size_t>(first - Places.begin());
    throw InvalidData(Name + ": it holds coefficients for " +
      std::to_string(Places.size() - missing) + " of the mesh's " + std::to_string(Places.size()) +
      " elements" + InStrips() + "; element " + std::to_string(numbers[at % numbers.size()]) +
      " has none. The field belongs to another mesh, or parts are missing.");
  }

  [[nodiscard]] std::size_t Planes() const { return Along ? Along->Functions() : 1; }

  static std::size_t BeginOf(const Placement& place, std::size_t f, std::size_t plane)
  {
    return f * place.block->perField + place.data->offset + plane * place.data->count;
  }

  OwnedExpansion Assemble(std::size_t f, std::size_t strip, std::size_t plane)
  {
    const std::size_t elements = Session.model.mesh.number.size();
    const std::size_t first = strip * elements;
    return AssembleField(std::span(Bases).subspan(first, elements), 1,
      [&](std::size_t e, std::span<double> source)
      {
        Placement& place = Places[first + e];
        place.block->values.Take(BeginOf(place, f, plane), source.first(place.data->count));
      });
  }

  /// The position along z where each strip begins.
  [[nodiscard]] std::vector<double> Beginnings() const
  {
    if (!Along->strips)
    {
      return { 0.0 };
    }
    if (!Session.stripDistance || !(*Session.stripDistance > 0.0))
    {
      throw InvalidData(Name +
        ": its fields are in strips, and the session gives no distance between them (the parameter "
        "DistStrip); name the session that they were computed with.");
    }
    std::vector<double> begin;
    for (const int strip : Strips)
    {
      begin.push_back(strip * *Session.stripDistance);
    }
    return begin;
  }

  void BuildHomogeneous()
  {
    std::vector<HomogeneousField> fields;
    for (std::size_t f = 0; f < Names.size(); ++f)
    {
      HomogeneousField& field = fields.emplace_back();
      field.name = Names[f];
      field.basis = BasisName;
      for (std::size_t strip = 0; strip < Strips.size(); ++strip)
      {
        for (std::size_t plane = 0; plane < Planes(); ++plane)
        {
          field.planes.push_back(Assemble(f, strip, plane));
        }
      }
    }
    try
    {
      LiftHomogeneous(*Along, Beginnings(), std::move(fields), Session.model);
    }
    catch (const Unsupported& error)
    {
      throw Unsupported(Name + ": " + error.what());
    }
  }

  const std::string& Name; ///< of the first file
  SessionMesh& Session;
  std::unordered_map<std::int64_t, int> ElementOf;
  std::deque<FieldFile> Files;
  std::vector<std::string> Names;
  std::string BasisName;
  std::optional<Homogeneous> Along;
  std::vector<int> Strips; ///< their numbers; 0 alone without strips
  std::size_t Coefficients = 0;
  std::map<Expansion3, ElementBasis> KnownBases;
  std::vector<Placement> Places; ///< strip by strip
  std::vector<const ElementBasis*> Bases;
};
} // namespace

void AddFields(const std::vector<NamedText>& parts, SessionMesh& session)
{
  FieldBuilder(parts, session).Build();
}
} // namespace pixelexact::nektar
