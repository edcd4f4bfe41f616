// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/NeededElements.h"

#include "Scene/SurfaceOptions.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Error.h"
#include "Core/Element/MeshRanges.h"
#include "Core/Location/Locator.h"
#include "Core/Shape/ShapeFace.h"
#include "PackedArrays.h"
#include "Parts/PartBorders.h"
#include "Parts/PartExchange.h"
#include "Trace/Scene.h"

#include <glm/geometric.hpp>
#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <set>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Chosen = std::set<vtkIdType>;

vtkMultiProcessController& Processes()
{
  return *vtkMultiProcessController::GetGlobalController();
}

/// `work` on each process; throws on all what it throws on one.
void OnAll(const std::function<void()>& work)
{
  std::string problem;
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  AgreeThatAllIsWell(problem, &Processes());
}

/// The element of lowest and that of highest number(e).
template <class Number>
void ChooseEnds(int elements, const Number& number, Chosen& chosen)
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  int first = -1;
  int last = -1;
  for (int e = 0; e < elements; ++e)
  {
    const auto [lower, upper] = number(e);
    if (lower < least)
    {
      least = lower;
      first = e;
    }
    if (upper > most)
    {
      most = upper;
      last = e;
    }
  }
  for (const int end : { first, last })
  {
    if (end >= 0)
    {
      chosen.insert(end);
    }
  }
}

/// The elements at the ends of the box, and those with the first and the last number.
Chosen Ends(const HighOrderModel& model)
{
  const auto& index = model.GetLocator().Index();
  const int elements = model.GetMesh().Elements();
  Chosen ends;
  for (int d = 0; d < 3; ++d)
  {
    ChooseEnds(
      elements,
      [&](int e)
      {
        const Box3& box = index.ElementBox(e);
        return std::pair(box.lower[d], box.upper[d]);
      },
      ends);
  }
  ChooseEnds(
    elements,
    [&](int e)
    {
      const auto number = static_cast<double>(model.SourceCells()[static_cast<std::size_t>(e)]);
      return std::pair(number, number);
    },
    ends);
  return ends;
}

/// Gathers the chosen elements of all parts as one grid with a model.
void Gather(const LoadedModel& part, const Chosen& chosen, LoadedModel& gathered)
{
  Grid sent = Grid::New();
  OnAll(
    [&]
    {
      if (!chosen.empty())
      {
        sent = PackedCells(part.grid, { chosen.begin(), chosen.end() }, true);
      }
    });
  const std::vector<Grid> received = FromAll(sent, &Processes());
  OnAll(
    [&]
    {
      const Grid all = Appended(received);
      if (!all)
      {
        throw Error("the input holds no elements");
      }
      gathered.grid = Unpack(all);
      gathered.model = HighOrderModel::From(gathered.grid);
    });
}

void ChooseNearSurface(const HighOrderModel& model, const Surface& surface, Chosen& chosen)
{
  for (int e = 0; e < model.GetMesh().Elements(); ++e)
  {
    const Box3& box = model.GetLocator().Index().ElementBox(e);
    const Vec3 centre = 0.5 * (box.lower + box.upper);
    if (!surface.IsClearOf(centre, (1.0 + 1e-12) * glm::distance(centre, box.upper)))
    {
      chosen.insert(e);
    }
  }
}

/// Elements whose proven range holds the value, and those at the ends of all values; of functions,
/// which have no proven ranges, all.
void ChooseOfIso(const HighOrderModel& model, const IsoChoice& iso, Chosen& chosen)
{
  const Field& field = model.GetField(iso.field);
  if (field.function != nullptr)
  {
    for (int e = 0; e < model.GetMesh().Elements(); ++e)
    {
      chosen.insert(e);
    }
    return;
  }
  const bool magnitude = iso.component == kMagnitude && field.values.components > 1;
  const RangeQuestion question{ magnitude ? Quantity::Magnitude : Quantity::Component, &field,
    std::max(0, iso.component) };
  const auto ranges = ElementRanges(model.GetMesh(), question, { .tolerance = 1.0, .boxes = 1 });
  for (std::size_t e = 0; e < ranges.size(); ++e)
  {
    if (!ranges[e].finite ||
      (ranges[e].outer.lower <= iso.value && iso.value <= ranges[e].outer.upper))
    {
      chosen.insert(static_cast<vtkIdType>(e));
    }
  }
  ChooseEnds(
    static_cast<int>(ranges.size()),
    [&](int e)
    {
      const Interval& outer = ranges[static_cast<std::size_t>(e)].outer;
      return std::pair(outer.lower, outer.upper);
    },
    chosen);
}

void ChooseOfBoundary(const HighOrderModel& model, const BoundaryChoice& choice, Chosen& chosen)
{
  const Mesh& mesh = model.GetMesh();
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const auto number = model.SourceCells()[static_cast<std::size_t>(e)];
    bool wanted = std::ranges::find(choice.elements, number) != choice.elements.end();
    const auto faces = static_cast<int>(FacesOf(mesh.ShapeOf(e)).size());
    for (int face = 0; face < faces && choice == BoundaryChoice(); ++face)
    {
      wanted = wanted || !model.IsInner(e, face);
    }
    if (wanted)
    {
      chosen.insert(e);
    }
  }
  for (const AttributedFace& face : model.BoundaryFaces())
  {
    if (std::ranges::find(choice.attributes, face.attribute) != choice.attributes.end())
    {
      chosen.insert(face.face.element);
    }
  }
}

bool IsMeshBoundaryAsked(const SurfaceOptions& surfaces)
{
  return std::ranges::find(surfaces.BoundaryChoices(), BoundaryChoice()) !=
    surfaces.BoundaryChoices().end();
}
} // namespace

namespace
{
/// A plane mesh's slab is as thick as the part that was read suggests.
void RequireOneSlab(const LoadedModel& part)
{
  const auto slab = part.model ? SlabOf(part.grid) : std::nullopt;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  // The least, and the most as the least of what is negative; without a part neither.
  const std::array<double, 2> own{ slab ? slab->thickness : (part.model ? 0.0 : kNone),
    slab ? -slab->thickness : (part.model ? 0.0 : kNone) };
  std::array<double, 2> all{};
  Processes().AllReduce(own.data(), all.data(), 2, vtkCommunicator::MIN_OP);
  if (all[0] != -all[1])
  {
    throw Error(
      "the parts of a plane mesh have different extents, and so become slabs of different "
      "thickness; start one process, without mpirun");
  }
}
} // namespace

LoadedModel LoadPart(const InputRequest& request, const std::string& field, Stopwatch& stopwatch)
{
  LoadedModel part;
  OnAll([&] { part = LoadModel(request, field, stopwatch); });
  RequireOneSlab(part);
  return part;
}

LoadedModel WithNeededElements(LoadedModel part, const SurfaceOptions& surfaces)
{
  LoadedModel needed = part;
  const Chosen ends = part.model ? Ends(*part.model) : Chosen();
  Gather(part, ends, needed);
  const LoadedModel box = needed;
  if (IsMeshBoundaryAsked(surfaces))
  {
    part.grid = WithInnerFaces(part.grid, &Processes());
  }
  Chosen chosen = ends;
  OnAll(
    [&]
    {
      const auto given = surfaces.MakeInSpace();
      if (!part.model)
      {
        return;
      }
      part.model = HighOrderModel::From(part.grid);
      for (const GivenSurface& surface : given)
      {
        ChooseNearSurface(*part.model, *surface(box.model), chosen);
      }
      for (const IsoText& iso : surfaces.IsoSurfaces())
      {
        ChooseOfIso(*part.model, Resolve(iso, *part.model), chosen);
      }
      for (const BoundaryChoice& choice : surfaces.BoundaryChoices())
      {
        ChooseOfBoundary(*part.model, choice, chosen);
      }
    });
  Gather(part, chosen, needed);
  const long long own = part.grid->GetNumberOfCells();
  long long all = 0;
  Processes().AllReduce(&own, &all, 1, vtkCommunicator::SUM_OP);
  needed.elements = all;
  return needed;
}
} // namespace pixelexact
