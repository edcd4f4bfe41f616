// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/IntegralSurfaces.h"

#include "Base/Command.h"
#include "Base/Options.h"
#include "Input/TriangleFile.h"
#include "Surfaces/FunctionOfSurface.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Disc.h"
#include "Trace/Surfaces/Torus.h"
#include "Trace/Surfaces/Triangles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkImplicitFunction.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// A surface that numbers describe.
struct Kind
{
  const char* name;
  std::function<void(const GivenNumbers& p, IntegralSurface& surface)> make;
};

void TakeFunction(const Surface& shown, IntegralSurface& surface)
{
  surface.function = FunctionOf(shown);
  surface.pieces = PiecesOf(surface.function);
}

void TakeDisc(const GivenNumbers& p, IntegralSurface& surface)
{
  (void)Disc(VectorAt(p, 0), VectorAt(p, 3), p[6]); // which refuses what is none
  QuadricForm plane;
  plane.origin = VectorAt(p, 0);
  plane.g = VectorAt(p, 3);
  QuadricForm ball;
  ball.origin = plane.origin;
  ball.q = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
  ball.c = -p[6] * p[6];
  const Vec3 reach(p[6] * (1.0 + 1e-12));
  surface.pieces.push_back({ std::make_shared<QuadricSurface>(plane), { ball },
    Box3{ plane.origin - reach, plane.origin + reach } });
}

/// In the order of the help.
const std::vector<Kind>& Kinds()
{
  static const std::vector<Kind> kinds = []
  {
    std::vector<Kind> all;
    all.push_back({ "--disc", TakeDisc });
    for (const QuadricKind& kind : kQuadricKinds)
    {
      all.push_back({ kind.name,
        [make = kind.make](const GivenNumbers& p, IntegralSurface& surface)
        { TakeFunction(make(p), surface); } });
    }
    all.push_back({ "--torus", [](const GivenNumbers& p, IntegralSurface& surface) {
                     TakeFunction(Torus(VectorAt(p, 0), VectorAt(p, 3), p[6], p[7]), surface);
                   } });
    all.push_back({ "--box", [](const GivenNumbers& p, IntegralSurface& surface) {
                     TakeFunction(MakeBox(VectorAt(p, 0), VectorAt(p, 3)), surface);
                   } });
    return all;
  }();
  return kinds;
}
} // namespace

void IntegralSurfaces::AddTo(CLI::App& command)
{
  Bind(command, "--plane",
    [this](const std::string& text) { Planes.push_back(PlaneChoice::Read(text)); });
  for (const Kind& kind : Kinds())
  {
    Bind(command, kind.name, Numbers[kind.name]);
  }
  Bind(command, "--surface", [this](const std::string& file) { Files.push_back(file); });
  Bind(command, "--patch",
    [](const std::string&)
    {
      throw UsageError(
        "--patch: integrals over Bezier patches are not there; give the triangles of "
        "a file (--surface)");
    });
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

std::vector<QuadricForm> IntegralSurfaces::Clips() const
{
  std::vector<QuadricForm> clips;
  for (const GivenNumbers& numbers : HalfSpaces)
  {
    QuadricForm clip;
    clip.origin = VectorAt(numbers, 0);
    clip.g = -VectorAt(numbers, 3);
    if (clip.g == Vec3(0.0))
    {
      throw UsageError("--clip: the normal is zero; give it a direction");
    }
    clips.push_back(clip);
  }
  return clips;
}

std::vector<IntegralSurface> IntegralSurfaces::Make(const Box3& box) const
{
  std::vector<IntegralSurface> surfaces;
  const auto addPlane = [&](const PlaneChoice& choice)
  {
    surfaces.push_back({ .name = "--plane " + choice.Numbers(box) });
    TakeFunction(choice.Make(box), surfaces.back());
  };
  std::ranges::for_each(Planes, addPlane);
  for (const Kind& kind : Kinds())
  {
    for (const GivenNumbers& numbers : Numbers.at(kind.name))
    {
      surfaces.push_back({ .name = fmt::format("{} {}", kind.name, fmt::join(numbers, ",")) });
      try
      {
        kind.make(numbers, surfaces.back());
      }
      catch (const Error& error)
      {
        throw UsageError(std::string(kind.name) + ": " + error.what());
      }
    }
  }
  for (const std::string& file : Files)
  {
    surfaces.push_back({ .name = "--surface " + file });
    const auto triangles = std::dynamic_pointer_cast<const Triangles>(ReadTriangles(file));
    for (const Triangles::Triangle& triangle : triangles->Corners())
    {
      if (auto piece = TrianglePiece(triangle))
      {
        surfaces.back().pieces.push_back(std::move(*piece));
      }
    }
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
  if (surfaces.empty())
  {
    addPlane(PlaneChoice::ThroughTheMiddle());
  }
  return surfaces;
}
} // namespace pixelexact
