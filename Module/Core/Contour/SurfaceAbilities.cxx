// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/SurfaceAbilities.h"

#include <array>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr std::array<SurfaceAbility, 15> kAbilities{ {
  { "planes", "vtkPlane", "--plane", 1, true, true, true },
  { "discs", "", "--disc", 1, true, true, false },
  { "spheres", "vtkSphere", "--sphere", 2, true, true, true },
  { "cylinders", "vtkCylinder", "--cylinder", 2, true, true, true },
  { "double cones", "vtkCone", "--cone", 2, true, true, true },
  { "quadrics", "vtkQuadric", "--quadric", 2, true, true, true },
  { "tori", "vtkImplicitTorus", "--torus", 4, true, true, true },
  { "boxes", "vtkBox", "--box", 1, true, true, true },
  { "convex bodies", "vtkPlanes", "", 1, true, true, true },
  { "triangles", "vtkHighOrderTriangleSurface", "--surface", 1, false, true, false },
  { "Bezier patches", "vtkHighOrderPatchSurface", "--patch", 0, false, false, false },
  { "iso-surfaces", "vtkHighOrderIsoSurface", "--isosurface", 0, false, true, false },
  { "walls of iso-surfaces", "vtkHighOrderJumpWalls", "--jump-walls", 0, false, false, false },
  { "the boundary", "vtkHighOrderBoundarySurface", "--boundary", 0, false, true, false },
  { "other functions", "vtkImplicitFunction", "", 0, false, false, false },
} };
} // namespace

std::span<const SurfaceAbility> SurfaceAbilities()
{
  return kAbilities;
}

std::string DescribeSurfacesWith(SurfaceUse use)
{
  std::vector<std::string> names;
  for (const SurfaceAbility& one : kAbilities)
  {
    if (one.Has(use))
    {
      names.emplace_back(one.plural);
    }
  }
  std::string text = use == SurfaceUse::Lines ? "contour lines are traced on "
    : use == SurfaceUse::Integrals            ? "integrals are taken over "
                                              : "integrals are clipped by ";
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  }
  return text + "; give one of these";
}
} // namespace pixelexact
