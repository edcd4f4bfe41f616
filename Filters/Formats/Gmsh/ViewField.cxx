// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Views.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/FileText.h"

#include <algorithm>
#include <limits>

namespace pixelexact::gmsh
{
namespace
{
/// A view's values element by element.
class ViewElements
{
public:
  /// `where`: file and view, for messages.
  ViewElements(std::string where, const View& view, const ViewPart& part, const ViewValues& values,
    const MeshFile& mesh, BasisTable& bases)
    : Where(std::move(where))
    , view_(view)
    , Part(part)
    , Values(values)
    , Mesh(mesh)
    , Bases(bases)
  {
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    {
      const bool given = HasValues(e);
      Given += given ? 1 : 0;
      BasisOf.push_back(given ? &Choose(e) : nullptr);
    }
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    {
      BasisOf[e] = BasisOf[e] != nullptr ? BasisOf[e] : &bases.Constant(ShapeOf(e));
    }
  }

  void Gather(std::size_t e, std::span<double> source) const;

  std::vector<const ElementBasis*> BasisOf;
  std::size_t Given = 0; ///< elements that have values

private:
  [[nodiscard]] Shape ShapeOf(std::size_t e) const { return Mesh.elements[e].type->shape; }
  [[nodiscard]] bool HasValues(std::size_t e) const;
  [[nodiscard]] int TuplesOf(std::size_t e) const;
  const ElementBasis& Choose(std::size_t e);

  std::string Where;
  const View& view_;
  const ViewPart& Part;
  const ViewValues& Values;
  const MeshFile& Mesh;
  BasisTable& Bases;
};

bool ViewElements::HasValues(std::size_t e) const
{
  if (view_.kind != ViewKind::Node)
  {
    return Values.first[e] >= 0;
  }
  return std::ranges::all_of(Mesh.NodesOf(Mesh.elements[e]),
    [this](std::int32_t node) { return Values.first[static_cast<std::size_t>(node)] >= 0; });
}

int ViewElements::TuplesOf(std::size_t e) const
{
  switch (view_.kind)
  {
    case ViewKind::Node:
      return Mesh.elements[e].type->nodes;
    case ViewKind::Element:
      return 1;
    default:
      return Values.count[e];
  }
}

const ElementBasis& ViewElements::Choose(std::size_t e)
{
  const ElementType& type = *Mesh.elements[e].type;
  const int tuples = TuplesOf(e);
  if (Part.scheme)
  {
    const ElementBasis* basis =
      NameErrors(Where + ", interpolation scheme '" + Part.schemeName + "'",
        [&] { return Bases.Of(*Part.scheme, type); });
    if (basis != nullptr)
    {
      if (basis->sources != tuples)
      {
        throw InvalidData(Where + " has " + Counted(static_cast<std::size_t>(tuples), "value") +
          " on element " + std::to_string(Mesh.elements[e].number) +
          ", but its interpolation scheme '" + Part.schemeName + "' " +
          std::to_string(basis->sources) + " functions there.");
      }
      return *basis;
    }
  }
  if (tuples == type.nodes)
  {
    return Bases.Nodal(type);
  }
  if (tuples == 1)
  {
    return Bases.Constant(type.shape);
  }
  throw Unsupported(Where + " has " + Counted(static_cast<std::size_t>(tuples), "value") +
    " on element " + std::to_string(Mesh.elements[e].number) + " of " + std::to_string(type.nodes) +
    " nodes, and no interpolation scheme says what they are; write one value for each node, or an "
    "$InterpolationScheme.");
}

void ViewElements::Gather(std::size_t e, std::span<double> source) const
{
  const auto components = static_cast<std::size_t>(Values.components);
  if (!HasValues(e))
  {
    std::ranges::fill(source, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const std::size_t tuples = source.size() / components;
  const auto nodes = Mesh.NodesOf(Mesh.elements[e]);
  for (std::size_t i = 0; i < tuples; ++i)
  {
    const auto first = view_.kind == ViewKind::Node
      ? static_cast<std::size_t>(Values.first[static_cast<std::size_t>(nodes[i])])
      : static_cast<std::size_t>(Values.first[e]) + i * components;
    for (std::size_t c = 0; c < components; ++c)
    {
      source[c * tuples + i] = Values.values[first + c];
    }
  }
}

std::string Description(const View& view, const ViewPart& part)
{
  if (!part.schemeName.empty())
  {
    return "Gmsh, interpolation scheme '" + part.schemeName + "'";
  }
  switch (view.kind)
  {
    case ViewKind::Node:
      return "Gmsh, values at nodes";
    case ViewKind::Element:
      return "Gmsh, values of elements";
    default:
      return "Gmsh, values at elements' nodes";
  }
}
} // namespace

const ElementBasis& BasisTable::Nodal(const ElementType& type)
{
  const auto found = ByType.find(type.number);
  return found != ByType.end() ? found->second
                               : ByType.emplace(type.number, NodalBasis(type)).first->second;
}

const ElementBasis* BasisTable::Of(const Scheme& scheme, const ElementType& type)
{
  const std::pair shape(type.dimension, type.shape);
  const auto interpolation = scheme.find(shape);
  if (interpolation == scheme.end())
  {
    return nullptr;
  }
  const std::pair key{ &scheme, shape };
  auto found = ByScheme.find(key);
  if (found == ByScheme.end())
  {
    found =
      ByScheme.emplace(key, InterpolationBasis(type.dimension, type.shape, interpolation->second))
        .first;
  }
  return &found->second;
}

const ElementBasis& BasisTable::Constant(Shape shape)
{
  const auto found = Constants.find(shape);
  return found != Constants.end() ? found->second
                                  : Constants.emplace(shape, ConstantBasis(shape)).first->second;
}

void AddView(std::vector<Scanner>& scanners, const View& view, std::int64_t step,
  const MeshFile& mesh, BasisTable& bases, SolverModel& model)
{
  const auto at = view.steps.size() == 1 ? view.steps.begin() : view.steps.find(step);
  const std::string where =
    scanners[view.steps.begin()->second.front().file].Name() + ": the view '" + view.name + "'";
  if (at == view.steps.end())
  {
    model.notes.push_back(
      where + " has no values at step " + std::to_string(step) + " and is left out there.");
    return;
  }
  const ViewPart& part = at->second.front();
  const ViewValues values = ReadValues(scanners, view, at->second, mesh);
  if (view.kind == ViewKind::Node && values.strangers > 0)
  {
    model.notes.push_back(where + " has " + Counted(values.strangers, "value") +
      " at nodes that the mesh does not have.");
  }
  const ViewElements elements(where, view, part, values, mesh, bases);
  if (elements.Given == 0)
  {
    model.notes.push_back(where + " has no values on elements of " +
      (mesh.dimension == 3 ? "volumes" : "surfaces") + " and is left out.");
    return;
  }
  const std::size_t missing = mesh.elements.size() - elements.Given;
  if (missing > 0)
  {
    model.notes.push_back(where + " has no values on " + std::to_string(missing) + " of " +
      Counted(mesh.elements.size(), "element") + "; it is NaN there.");
  }
  SolverField field;
  field.name = view.name;
  field.basis = Description(view, part);
  field.continuous = view.kind == ViewKind::Node && missing == 0;
  field.values = AssembleField(elements.BasisOf, values.components,
    [&](std::size_t e, std::span<double> source) { elements.Gather(e, source); });
  model.fields.push_back(std::move(field));
}
} // namespace pixelexact::gmsh
