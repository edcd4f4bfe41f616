// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOptions.h"

#include "Command.h"
#include "Options.h"

#include "Core/Base/Error.h"
#include "Trace/Plane.h"

namespace pixelexact
{
namespace
{
struct Announced
{
  const char* name;
  const char* form;
  const char* help;
};
constexpr Announced kAnnounced[] = {
  { "--sphere", "cx,cy,cz,r", "Cut by a sphere" },
  { "--cylinder", "px,py,pz,ax,ay,az,r", "Cut by a cylinder" },
  { "--cone", "ax,ay,az,dx,dy,dz,deg", "Cut by a cone" },
  { "--quadric", "a0,...,a9", "Cut by a quadric, in vtkQuadric's order" },
  { "--torus", "cx,cy,cz,ax,ay,az,R,r", "Cut by a torus" },
  { "--patch", "FILE", "Cut by bicubic Bezier patches" },
  { "--isosurface", "FIELD=VALUE", "Cut by an iso-surface of a field" },
  { "--surface", "FILE", "Cut by triangles (.vtp, .stl)" },
};
} // namespace

void SurfaceOptions::AddTo(CLI::App& command)
{
  const char* group = "Surfaces (any number of each)";
  AddRepeatedNumbers(
    command, "--plane", Planes, 6, "ox,oy,oz,nx,ny,nz", "Cut by the plane through o with normal n")
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
    throw Unsupported(
      (NotYet.empty() ? "--boundary" : NotYet[0]) + " is not available yet; cut by a --plane");
  }
  if (Planes.empty())
  {
    throw UsageError("no surface was given; cut by a plane, say --plane 0,0,0,0,0,1");
  }
  std::vector<std::shared_ptr<const Surface>> surfaces;
  for (const std::vector<double>& p : Planes)
  {
    try
    {
      surfaces.push_back(std::make_shared<Plane>(Vec3(p[0], p[1], p[2]), Vec3(p[3], p[4], p[5])));
    }
    catch (const Error& error)
    {
      throw UsageError(std::string("--plane: ") + error.what());
    }
  }
  return surfaces;
}
} // namespace pixelexact
