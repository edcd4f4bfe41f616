// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/MeshSurfaces.h"

#include "HighOrderModel.h"
#include "Trace/Appearance/FieldRange.h"
#include "Views/FieldChoice.h"

#include "Core/Base/Error.h"
#include "Core/Element/MeshRanges.h"
#include "Core/Faces/AttributedFace.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Shape/ShapeFace.h"
#include "Trace/Surfaces/ElementFaces.h"
#include "Trace/Surfaces/FieldSamples.h"
#include "Trace/Surfaces/IsoSurface.h"
#include "Trace/Surfaces/JumpWalls.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

namespace pixelexact
{
namespace
{
void RequireElements(const HighOrderModel& model, const std::vector<std::int64_t>& elements)
{
  std::vector<std::int64_t> there(model.SourceCells().begin(), model.SourceCells().end());
  std::ranges::sort(there);
  for (const std::int64_t element : elements)
  {
    if (!std::ranges::binary_search(there, element))
    {
      throw Error("the mesh has no element " + std::to_string(element) +
        (there.empty() ? "; it has none at all"
                       : "; its elements are numbered from " + std::to_string(there.front()) +
              " to " + std::to_string(there.back())));
    }
  }
}

/// A name for messages, such as "component 1 of field 'v'".
std::string NameOf(const Field& field, int component)
{
  std::string name = "field '" + field.name + "'";
  if (field.values.components == 1)
  {
    return name;
  }
  return component == kMagnitude ? "the magnitude of " + name
                                 : "component " + std::to_string(component) + " of " + name;
}

/// The shortest digits that round to the number.
std::string Digits(double number)
{
  std::array<char, 32> text{};
  return { text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr };
}

void RequireValue(const HighOrderModel& model, const Field& field, int component, double value)
{
  const Interval range = ProvenRange(model.GetMesh(), field, component);
  if (range.lower <= value && value <= range.upper)
  {
    return;
  }
  throw Error("iso-surface: " + NameOf(field, component) +
    (range.IsEmpty() ? " has no finite value; choose another field"
                     : " has values from " + Digits(range.lower) + " to " + Digits(range.upper) +
          ", and " + Digits(value) + " is none of them; choose a value between"));
}

/// Adds the faces that `keep` selects of all elements.
template <class Keep>
void AddFaces(const Mesh& mesh, Keep keep, std::vector<ElementFace>& faces)
{
  for (int element = 0; element < mesh.Elements(); ++element)
  {
    const auto count = static_cast<int>(FacesOf(mesh.ShapeOf(element)).size());
    for (int face = 0; face < count; ++face)
    {
      if (keep(element, face))
      {
        faces.push_back({ element, face });
      }
    }
  }
}

/// The union of all chosen faces. Without a choice, faces that are not completely covered by other
/// elements.
std::vector<ElementFace> FacesFor(const HighOrderModel& model, const BoundaryChoice& choice)
{
  std::vector<ElementFace> faces;
  if (choice == BoundaryChoice())
  {
    AddFaces(
      model.GetMesh(),
      [&](int element, int face)
      {
        if (model.IsGhost(element) || model.IsInner(element, face))
        {
          return false;
        }
        if (model.IsShell())
        {
          return face == ShellFace(model.GetMesh().ShapeOf(element));
        }
        const FaceKind kind = model.Faces().KindOf(element, face);
        return kind == FaceKind::Boundary || kind == FaceKind::Partly;
      },
      faces);
    return faces;
  }
  for (const int attribute : choice.attributes)
  {
    std::ranges::copy(
      FacesOfAttribute(model.BoundaryFaces(), attribute), std::back_inserter(faces));
  }
  const auto cells = model.SourceCells();
  AddFaces(
    model.GetMesh(),
    [&](int element, int face)
    {
      return (!model.IsShell() || face == ShellFace(model.GetMesh().ShapeOf(element))) &&
        std::ranges::find(choice.elements, cells[static_cast<std::size_t>(element)]) !=
        choice.elements.end();
    },
    faces);
  if (choice.inner)
  {
    model.RequireSolids("faces between elements");
    const FaceTable& table = model.Faces();
    const std::size_t before = faces.size();
    AddFaces(
      model.GetMesh(),
      [&table](int element, int face)
      {
        const FaceKind kind = table.KindOf(element, face);
        return kind == FaceKind::Hanging ||
          (kind == FaceKind::Interior && table.NeighbourOf(element, face).element > element);
      },
      faces);
    if (faces.size() == before)
    {
      throw Error("the mesh has no face between elements; choose another surface");
    }
  }
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// Wraps the surface so that it keeps the model alive.
std::shared_ptr<const Surface> KeepingAlive(
  const std::shared_ptr<const HighOrderModel>& model, std::unique_ptr<const Surface> surface)
{
  return { surface.release(), [model](const Surface* kept) { delete kept; } };
}
} // namespace

std::shared_ptr<const Surface> MakeBoundary(
  const std::shared_ptr<const HighOrderModel>& model, const BoundaryChoice& choice)
{
  RequireElements(*model, choice.elements);
  const std::vector<ElementFace> faces = FacesFor(*model, choice);
  std::vector<bool> partly;
  if (choice == BoundaryChoice() && !model->IsShell())
  {
    for (const ElementFace& one : faces)
    {
      partly.push_back(model->Faces().KindOf(one.element, one.face) == FaceKind::Partly);
    }
  }
  if (std::ranges::find(partly, true) == partly.end())
  {
    return KeepingAlive(
      model, std::make_unique<const ElementFaces>(model->GetLocator().Index(), faces));
  }
  return KeepingAlive(
    model, std::make_unique<const ElementFaces>(model->GetLocator(), faces, std::move(partly)));
}

namespace
{
/// The field of the choice. Checks its component and value.
const Field& FieldFor(const HighOrderModel& model, const IsoChoice& choice)
{
  model.RequireSolids("an iso-surface");
  if (!std::isfinite(choice.value))
  {
    throw Error("iso-surface: the value is not finite; choose a number");
  }
  if (model.Fields().empty())
  {
    throw Error("iso-surface: the mesh carries no field; choose another surface");
  }
  const FieldChoice chosen{ .name = choice.field };
  const Field& field = chosen.In(model);
  RequireComponent(field, choice.component);
  if (field.function != nullptr)
  {
    return field; // of which no range is known
  }
  RequireValue(model, field, choice.component, choice.value);
  return field;
}
} // namespace

std::shared_ptr<const Surface> MakeIsoSurface(
  const std::shared_ptr<const HighOrderModel>& model, const IsoChoice& choice)
{
  const Field& field = FieldFor(*model, choice);
  if (field.function != nullptr)
  {
    auto samples = std::make_shared<const FieldSamples>(
      model->GetLocator(), field, choice.component, choice.value);
    constexpr int kEnds = 2; // and what FieldSamples asks for
    return KeepingAlive(model,
      std::make_unique<const SearchedSurface>(
        std::move(samples), model->GetLocator().Bounds(), kEnds));
  }
  return KeepingAlive(model,
    std::make_unique<const IsoSurface>(
      model->GetLocator().Index(), field, choice.component, choice.value, choice.mayBeEmpty));
}

std::shared_ptr<const Surface> MakeJumpWalls(
  const std::shared_ptr<const HighOrderModel>& model, const IsoChoice& choice)
{
  const Field& field = FieldFor(*model, choice);
  return KeepingAlive(model,
    std::make_unique<const JumpWalls>(
      model->GetLocator(), model->Faces(), field, choice.component, choice.value));
}
} // namespace pixelexact
