// SPDX-License-Identifier: BSD-3-Clause
#include "IntegralSurfaces.h"

#include "Command.h"
#include "FunctionOfSurface.h"
#include "MeshSurfaceOptions.h"
#include "Options.h"
#include "QuadricKinds.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkImplicitFunction.h>

#include <algorithm>
#include <string>

namespace pixelexact
{
void IntegralSurfaces::AddTo(CLI::App& command)
{
  const char* group = "Surfaces (any number of each)";
  AddRepeated(
    command, "--plane",
    [this](const std::string& text) { Planes.push_back(PlaneChoice::Read(text)); },
    PlaneChoice::kForm,
    "Over the plane through o with normal n; or across x, y or z, through the middle of the mesh's "
    "box, at a coordinate (z=0.2), or at a part of the box (z=10%). Without any surface: through "
    "the middle, across the shortest side")
    .Group(group);
  for (const QuadricKind& kind : kQuadricKinds)
  {
    AddRepeatedNumbers(command, kind.name, Numbers[kind.name], kind.count, kind.form,
      std::string("Over ") + kind.what)
      .Group(group);
  }
  AddRepeated(
    command, "--boundary",
    [this](const std::string& text)
    {
      Boundaries.push_back(ParseBoundary(text));
      if (!Boundaries.back().elements.empty())
      {
        throw UsageError("--boundary: integrals over faces of single elements are not there; give "
                         "attributes of the boundary");
      }
    },
    "[=all|ATTRIBUTE,...]", "Over the boundary of the mesh, or its parts with these attributes")
    .Group(group);
}

std::vector<IntegralSurface> IntegralSurfaces::Make(const Box3& box) const
{
  std::vector<IntegralSurface> surfaces;
  const auto addPlane = [&](const PlaneChoice& choice) {
    surfaces.push_back({ "--plane " + choice.Numbers(box), FunctionOf(choice.Make(box)), {} });
  };
  std::ranges::for_each(Planes, addPlane);
  for (const QuadricKind& kind : kQuadricKinds)
  {
    for (const GivenNumbers& numbers : Numbers.at(kind.name))
    {
      const std::string name = fmt::format("{} {}", kind.name, fmt::join(numbers, ","));
      try
      {
        surfaces.push_back({ name, FunctionOf(kind.make(numbers)), {} });
      }
      catch (const Error& error)
      {
        throw UsageError(std::string(kind.name) + ": " + error.what());
      }
    }
  }
  for (const BoundaryChoice& choice : Boundaries)
  {
    surfaces.push_back(
      { choice.attributes.empty() ? "--boundary"
                                  : fmt::format("--boundary={}", fmt::join(choice.attributes, ",")),
        nullptr, { choice.attributes.begin(), choice.attributes.end() } });
  }
  if (surfaces.empty())
  {
    addPlane(PlaneChoice::ThroughTheMiddle());
  }
  return surfaces;
}
} // namespace pixelexact
