// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOptions.h"

#include "Command.h"
#include "Options.h"
#include "PatchFile.h"
#include "TriangleFile.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Disc.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"
#include "VtkPatches.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
using Given = std::vector<double>;

Vec3 At(const Given& numbers, std::size_t first)
{
  return { numbers[first], numbers[first + 1], numbers[first + 2] };
}

/// A surface that numbers describe.
struct Kind
{
  const char* name;
  int count;
  const char* form;
  const char* help;
  std::shared_ptr<const Surface> (*make)(const Given& p);
};
// In the order of the help.
const Kind kKinds[] = {
  { "--plane", 6, "ox,oy,oz,nx,ny,nz", "Cut by the plane through o with normal n",
    [](const Given& p) -> std::shared_ptr<const Surface>
    { return std::make_shared<Plane>(At(p, 0), At(p, 3)); } },
  { "--disc", 7, "cx,cy,cz,nx,ny,nz,r",
    "Cut by the disc about c with normal n: the part of a plane within a circle",
    [](const Given& p) -> std::shared_ptr<const Surface>
    { return std::make_shared<Disc>(At(p, 0), At(p, 3), p[6]); } },
  { "--sphere", 4, "cx,cy,cz,r", "Cut by a sphere",
    [](const Given& p) -> std::shared_ptr<const Surface>
    { return std::make_shared<Quadric>(MakeSphere(At(p, 0), p[3])); } },
  { "--cylinder", 7, "px,py,pz,ax,ay,az,r", "Cut by the cylinder about the line through p along a",
    [](const Given& p) -> std::shared_ptr<const Surface>
    { return std::make_shared<Quadric>(MakeCylinder(At(p, 0), At(p, 3), p[6])); } },
  { "--cone", 7, "ax,ay,az,dx,dy,dz,deg",
    "Cut by the cone, both halves, with apex a, axis d and so many degrees between axis and "
    "surface",
    [](const Given& p) -> std::shared_ptr<const Surface>
    { return std::make_shared<Quadric>(MakeCone(At(p, 0), At(p, 3), p[6])); } },
  { "--quadric", 10, "a0,...,a9",
    "Cut by a quadric, in vtkQuadric's order: xx, yy, zz, xy, yz, xz, x, y, z, 1",
    [](const Given& p) -> std::shared_ptr<const Surface>
    {
      std::array<double, 10> a{};
      std::ranges::copy(p, a.begin());
      return std::make_shared<Quadric>(MakeQuadric(a));
    } },
  { "--torus", 8, "cx,cy,cz,ax,ay,az,R,r", "Cut by the torus about c with axis a, of radii R and r",
    [](const Given& p) -> std::shared_ptr<const Surface>
    { return std::make_shared<Torus>(At(p, 0), At(p, 3), p[6], p[7]); } },
  { "--box", 6, "x0,y0,z0,x1,y1,z1", "Cut by the faces of a box",
    [](const Given& p) -> std::shared_ptr<const Surface>
    { return std::make_shared<ConvexBody>(MakeBox(At(p, 0), At(p, 3))); } },
};

struct Announced
{
  const char* name;
  const char* form;
  const char* help;
};
constexpr Announced kAnnounced[] = {
  { "--isosurface", "FIELD=VALUE", "Cut by an iso-surface of a field" },
};
} // namespace

void SurfaceOptions::AddTo(CLI::App& command)
{
  const char* group = "Surfaces (any number of each)";
  for (const Kind& kind : kKinds)
  {
    AddRepeatedNumbers(command, kind.name, Numbers[kind.name], kind.count, kind.form, kind.help)
      .Group(group);
  }
  AddRepeated(
    command, "--surface", [this](const std::string& file) { Files.push_back(file); }, "FILE",
    "Cut by the triangles of a file (.vtp, .stl), as they are")
    .Group(group);
  AddRepeated(
    command, "--patch", [this](const std::string& file) { Patches.push_back(file); }, "FILE",
    "Cut by the bicubic Bezier patches of a text file: per patch 16 lines 'x y z', rows of u; what "
    "stands behind a # counts nothing (not available yet)")
    .Group(group);
  for (const Announced& surface : kAnnounced)
  {
    AddRepeated(
      command, surface.name,
      [this, name = surface.name](const std::string&) { NotYet.emplace_back(name); }, surface.form,
      std::string(surface.help) + " (not available yet)")
      .Group(group);
  }
  AddFlag(command, "--boundary", Boundary, "The boundary of the mesh (not available yet)")
    .Group(group);
}

std::vector<std::shared_ptr<const Surface>> SurfaceOptions::Make() const
{
  if (!NotYet.empty() || Boundary)
  {
    throw Unsupported((NotYet.empty() ? "--boundary" : NotYet[0]) +
      " is not available yet; cut by a --plane or another surface of the help");
  }
  std::vector<std::shared_ptr<const Surface>> surfaces;
  for (const Kind& kind : kKinds)
  {
    for (const Given& numbers : Numbers.at(kind.name))
    {
      try
      {
        surfaces.push_back(kind.make(numbers));
      }
      catch (const Error& error)
      {
        throw UsageError(std::string(kind.name) + ": " + error.what());
      }
    }
  }
  for (const std::string& file : Files)
  {
    surfaces.push_back(ReadTriangles(file));
  }
  for (const std::string& file : Patches)
  {
    std::vector<BezierPatch> patches = ReadPatches(file);
    try
    {
      surfaces.push_back(SurfaceOf(std::move(patches)));
    }
    catch (const Error& error)
    {
      throw Error("--patch: '" + file + "': " + error.what());
    }
  }
  if (surfaces.empty())
  {
    throw UsageError("no surface was given; cut by a plane, say --plane 0,0,0,0,0,1");
  }
  return surfaces;
}
} // namespace pixelexact
