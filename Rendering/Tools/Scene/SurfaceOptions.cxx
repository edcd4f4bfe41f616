// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SurfaceOptions.h"

#include "Base/Command.h"
#include "Base/Options.h"
#include "Input/PatchFile.h"
#include "Input/TriangleFile.h"
#include "Scene/Model.h"
#include "Scene/NumberedSurfaces.h"

#include "Core/Base/Error.h"
#include "Surfaces/VtkPatches.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// A surface that is the same for all meshes of solids.
GivenSurface Made(const char* option, std::shared_ptr<const Surface> surface)
{
  return [option, surface = std::move(surface)](const std::shared_ptr<const HighOrderModel>& model)
  {
    model->RequireSolids(option);
    return surface;
  };
}

/// A surface that `make` creates from the mesh. Its errors get the option's name.
template <class Make>
GivenSurface OfMesh(const char* option, Make make)
{
  return [option, make = std::move(make)](const std::shared_ptr<const HighOrderModel>& model)
  {
    try
    {
      return make(model);
    }
    catch (const Error& error)
    {
      throw Error(option + std::string(": ") + error.what());
    }
  };
}
} // namespace

void SurfaceOptions::AddTo(CLI::App& command)
{
  Bind(command, "--plane",
    [this](const std::string& text) { Planes.push_back(PlaneChoice::Read(text)); });
  for (const NumberedSurface& kind : kNumberedSurfaces)
  {
    Bind(command, kind.option, Numbers[kind.option]);
  }
  Bind(command, "--surface", [this](const std::string& file) { Files.push_back(file); });
  Bind(command, "--patch", [this](const std::string& file) { Patches.push_back(file); });
  Bind(
    command, "--isosurface", [this](const std::string& text) { Isos.push_back(ParseIso(text)); });
  Bind(command, "--boundary",
    [this](const std::string& text) { Boundaries.push_back(ParseBoundary(text)); });
  Bind(command, "--faces", InnerFaces);
  Bind(command, "--jump-walls", Walls);
}

SurfaceOptions::Described SurfaceOptions::First() const
{
  for (const NumberedSurface& kind : kNumberedSurfaces)
  {
    const auto found = Planes.empty() ? Numbers.find(kind.option) : Numbers.end();
    if (found != Numbers.end() && !found->second.empty())
    {
      return { kind.option, found->second.front() };
    }
  }
  return {};
}

std::size_t SurfaceOptions::CountGiven() const
{
  std::size_t count = Planes.size() + Files.size() + Patches.size() + Isos.size() +
    Boundaries.size() + (InnerFaces ? 1 : 0) + CountWalls();
  for (const auto& [name, given] : Numbers)
  {
    count += given.size();
  }
  return count;
}

std::vector<std::string> SurfaceOptions::Fields() const
{
  std::vector<std::string> names;
  std::ranges::transform(
    Isos, std::back_inserter(names), [](const IsoText& iso) { return iso.name; });
  return names;
}

std::vector<GivenSurface> SurfaceOptions::MakeInSpace() const
{
  std::vector<GivenSurface> surfaces;
  for (const PlaneChoice& choice : Planes)
  {
    surfaces.push_back(OfMesh("--plane",
      [choice](const std::shared_ptr<const HighOrderModel>& model)
      {
        model->RequireSolids("a plane");
        return std::make_shared<Plane>(choice.Make(BoxOf(*model)));
      }));
  }
  if (!AreGiven())
  {
    surfaces.emplace_back(
      [](const std::shared_ptr<const HighOrderModel>& model) -> std::shared_ptr<const Surface>
      {
        return model->IsShell()
          ? MakeBoundary(model, {})
          : std::make_shared<Plane>(PlaneChoice::ThroughTheMiddle().Make(BoxOf(*model)));
      });
  }
  for (const NumberedSurface& kind : kNumberedSurfaces)
  {
    for (const GivenNumbers& numbers : Numbers.at(kind.option))
    {
      surfaces.push_back(Made(kind.option, MakeNumbered(kind, numbers)));
    }
  }
  for (const std::string& file : Files)
  {
    surfaces.push_back(Made("--surface", ReadTriangles(file)));
  }
  for (const std::string& file : Patches)
  {
    const std::vector<BezierPatch> patches = ReadPatches(file);
    try
    {
      surfaces.push_back(Made("--patch", SurfaceOf(patches)));
    }
    catch (const Error& error)
    {
      throw Error("--patch: '" + file + "': " + error.what());
    }
  }
  return surfaces;
}

std::vector<GivenSurface> SurfaceOptions::Make() const
{
  std::vector<GivenSurface> surfaces = MakeInSpace();
  for (const IsoText& iso : Isos)
  {
    surfaces.push_back(OfMesh("--isosurface",
      [iso, walls = Walls](const std::shared_ptr<const HighOrderModel>& model)
      {
        IsoChoice choice = Resolve(iso, *model);
        choice.mayBeEmpty = walls;
        return MakeIsoSurface(model, choice);
      }));
  }
  for (const BoundaryChoice& choice : Boundaries)
  {
    surfaces.push_back(OfMesh("--boundary",
      [choice](const std::shared_ptr<const HighOrderModel>& model)
      { return MakeBoundary(model, choice); }));
  }
  if (InnerFaces)
  {
    surfaces.push_back(OfMesh("--faces",
      [](const std::shared_ptr<const HighOrderModel>& model)
      {
        BoundaryChoice choice;
        choice.inner = true;
        return MakeBoundary(model, choice);
      }));
  }
  for (std::size_t k = 0; k < CountWalls(); ++k)
  {
    surfaces.push_back(OfMesh("--jump-walls",
      [iso = Isos[k]](const std::shared_ptr<const HighOrderModel>& model)
      { return MakeJumpWalls(model, Resolve(iso, *model)); }));
  }
  return surfaces;
}
} // namespace pixelexact
