// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/IntegralSurfaces.h"

#include "Base/Command.h"
#include "Base/Options.h"
#include "Core/Contour/SurfaceAbilities.h"
#include "HighOrderModel.h"
#include "Input/TriangleFile.h"
#include "Scene/Model.h"
#include "Surfaces/FunctionOfSurface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkImplicitFunction.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace pixelexact
{
void IntegralSurfaces::AddTo(CLI::App& command)
{
  Bind(command, "--plane",
    [this](const std::string& text) { Planes.push_back(PlaneChoice::Read(text)); });
  for (const NumberedSurface& kind : kNumberedSurfaces)
  {
    Bind(command, kind.option, Numbers[kind.option]);
  }
  Bind(command, "--surface", [this](const std::string& file) { Files.push_back(file); });
  Bind(command, "--patch",
    [](const std::string&)
    { throw UsageError("--patch: " + DescribeSurfacesWith(SurfaceUse::Integrals)); });
  Bind(
    command, "--isosurface", [this](const std::string& text) { Isos.push_back(ParseIso(text)); });
  Bind(command, "--boundary",
    [this](const std::string& text)
    {
      Boundaries.push_back(ParseBoundary(text));
      if (!Boundaries.back().elements.empty())
      {
        throw UsageError("--boundary: integrals over faces of single elements are not there; give "
                         "attributes of the boundary");
      }
    });
  Bind(command, "--clip", HalfSpaces);
}

std::string IntegralSurfaces::NotLinear() const
{
  const std::pair<const char*, bool> given[] = { { "--disc", !Numbers.at("--disc").empty() },
    { "--surface", !Files.empty() }, { "--isosurface", !Isos.empty() },
    { "--boundary", !Boundaries.empty() }, { "--clip", !HalfSpaces.empty() } };
  const auto* const first =
    std::ranges::find_if(given, [](const auto& option) { return option.second; });
  return first != std::end(given) ? first->first : "";
}

std::vector<ImplicitPolynomial> IntegralSurfaces::Clips() const
{
  std::vector<ImplicitPolynomial> clips;
  for (const GivenNumbers& numbers : HalfSpaces)
  {
    const Vec3 normal = VectorAt(numbers, 3);
    if (normal == Vec3(0.0))
    {
      throw UsageError("--clip: the normal is zero; give it a direction");
    }
    clips.push_back(ImplicitPolynomial::Plane(VectorAt(numbers, 0), -normal));
  }
  return clips;
}

std::vector<IntegralSurface> IntegralSurfaces::Make(const HighOrderModel& model) const
{
  const Box3 box = BoxOf(model);
  std::vector<IntegralSurface> surfaces;
  const auto add = [&surfaces](std::string name, const Surface& surface)
  {
    surfaces.push_back({ .name = std::move(name),
      .patches = IntegralPatchesOf(surface.Implicit()),
      .function = FunctionOf(surface) });
  };
  const auto addPlane = [&](const PlaneChoice& choice)
  { add("--plane " + choice.Numbers(box), choice.Make(box)); };
  std::ranges::for_each(Planes, addPlane);
  for (const NumberedSurface& kind : kNumberedSurfaces)
  {
    for (const GivenNumbers& numbers : Numbers.at(kind.option))
    {
      add(fmt::format("{} {}", kind.option, fmt::join(numbers, ",")), *MakeNumbered(kind, numbers));
    }
  }
  for (const std::string& file : Files)
  {
    add("--surface " + file, *ReadTriangles(file));
  }
  for (const IsoText& iso : Isos)
  {
    surfaces.push_back(
      { .name = fmt::format("--isosurface {}={}", iso.name, iso.value), .iso = iso });
  }
  for (const BoundaryChoice& choice : Boundaries)
  {
    surfaces.push_back({ .name = choice.attributes.empty()
        ? "--boundary"
        : fmt::format("--boundary={}", fmt::join(choice.attributes, ",")),
      .boundary = true,
      .attributes = { choice.attributes.begin(), choice.attributes.end() } });
  }
  const auto isBoundary = [](const IntegralSurface& surface) { return surface.boundary; };
  if (const auto other = std::ranges::find_if_not(surfaces, isBoundary); other != surfaces.end())
  {
    model.RequireSolids(other->name);
  }
  if (surfaces.empty() && model.IsShell())
  {
    surfaces.push_back({ .name = "--boundary", .boundary = true });
  }
  else if (surfaces.empty())
  {
    addPlane(PlaneChoice::ThroughTheMiddle());
  }
  return surfaces;
}
} // namespace pixelexact
