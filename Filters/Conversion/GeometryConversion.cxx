// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/GeometryConversion.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Basis/OrderReduction.h"
#include "Core/Basis/Space.h"
#include "Core/Element/ElementUnits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
ElementUnits UnitsOf(const SourceMesh& mesh, int element)
{
  Vec3 low(INFINITY);
  Vec3 high(-INFINITY);
  const auto xyz = mesh.Coordinates();
  for (const auto p : mesh.Points(element))
  {
    const Vec3 x(xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]);
    low = glm::min(low, x);
    high = glm::max(high, x);
  }
  if (const auto& slab = mesh.GetSlab(); slab && !slab->inSpace)
  {
    low.z = slab->middle - slab->thickness / 2;
    high.z = slab->middle + slab->thickness / 2;
  }
  try
  {
    return MakeElementUnits(low, high);
  }
  catch (const InvalidData& error)
  {
    throw InvalidData(mesh.Describe(element) + " " + error.what());
  }
}

/// The modes of all three components, world units, relative to the centre.
std::vector<double> ModesOf(
  const SourceMesh& mesh, int element, const ChangeOfBasis& change, const Vec3& centre)
{
  thread_local std::vector<double> nodes;
  thread_local ChangeOfBasis::Scratch scratch;
  std::vector<double> modes(3 * static_cast<std::size_t>(change.Target().Modes()));
  // The z of a slab in a plane does not come from the points.
  const std::size_t components = mesh.GetSlab() && !mesh.GetSlab()->inSpace ? 2 : 3;
  const std::array<double, 3> shifts{ centre.x, centre.y, centre.z };
  mesh.GatherAll(element, mesh.Coordinates(), 3, static_cast<int>(components), nodes);
  change.Apply(nodes, std::span(shifts).first(components), modes, scratch);
  return modes;
}

/// Distance of a pyramid of order 2 from the straight pyramid between its vertices, world units.
/// None where rounding does not explain it.
std::optional<double> DistanceToStraight(const CellBasis& basis, std::vector<double> modes,
  const std::vector<double>& straight, double roundings, double size)
{
  std::ranges::transform(modes, straight, modes.begin(), std::minus());
  std::vector<double> amplification(
    basis.change.Amplification().begin(), basis.change.Amplification().end());
  std::ranges::transform(
    amplification, basis.straight[0].Amplification(), amplification.begin(), std::plus());
  const Space& space = basis.GetSpace();
  const OrderReduction difference(
    space, amplification, modes, roundings, std::numeric_limits<double>::infinity(), size);
  if (!difference.IsNoise())
  {
    return std::nullopt;
  }
  double largest = 0.0;
  const auto count = static_cast<std::size_t>(space.Modes());
  for (int c = 0; c < 3; ++c)
  {
    double sum = 0.0;
    ForEachMode(space,
      [&](int p, int q, int r, int mode)
      { sum += std::fabs(modes[c * count + mode]) * ModeBound(space, p, q, r); });
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Maps the geometry from the plane's space to the slab's.
void Lift(const Slab& slab, const ElementUnits& units, ElementGeometry& geometry)
{
  const Space plane = geometry.space;
  const auto inUnits = [&units](double x) { return std::ldexp(x, -units.exponent); };
  std::vector<double> modes = std::move(geometry.coefficients);
  geometry.space = Lifted(plane);
  geometry.coefficients = std::vector<double>(3 * static_cast<std::size_t>(geometry.space.Modes()));
  if (slab.inSpace)
  {
    LiftSurface(plane, plane, modes, slab.thickness, geometry.coefficients);
    return;
  }
  modes.resize(2 * static_cast<std::size_t>(plane.Modes()));
  LiftMap(plane, modes, inUnits(slab.middle - units.centre.z), inUnits(slab.thickness / 2),
    geometry.coefficients);
}
} // namespace

ElementGeometry ConvertGeometry(const SourceMesh& mesh, int element)
{
  const ElementUnits units = UnitsOf(mesh, element);
  const CellBasis& basis = mesh.Basis(element);
  ElementGeometry geometry;
  geometry.centre = { units.centre.x, units.centre.y, units.centre.z };
  geometry.size = std::ldexp(1.0, units.exponent);
  const double roundings = kCoordinateRoundings * mesh.CoordinateRoundoff() * units.largest;
  const ChangeOfBasis* change = &basis.change;
  std::vector<double> modes = ModesOf(mesh, element, *change, units.centre);
  if (!basis.straight.empty())
  {
    const auto distance = DistanceToStraight(basis, modes,
      ModesOf(mesh, element, basis.straight[0], units.centre), roundings, geometry.size);
    if (distance)
    {
      geometry.uncertainty = *distance;
      change = &basis.straight[1];
      modes = ModesOf(mesh, element, *change, units.centre);
    }
  }
  const Space full = change->Target();
  const double noise =
    change == &basis.change ? basis.noise : std::numeric_limits<double>::infinity();
  const OrderReduction reduction(
    full, change->Amplification(), modes, roundings, noise, geometry.size);
  geometry.space = reduction.Reduce();
  geometry.uncertainty += reduction.Uncertainty(geometry.space) + mesh.Loss(element);
  const double inUnits = std::ldexp(1.0, -units.exponent);
  if (geometry.space == full && !mesh.GetSlab())
  {
    std::ranges::transform(
      modes, modes.begin(), [inUnits](double mode) { return inUnits * mode; }); // exact
    geometry.coefficients = std::move(modes);
    return geometry;
  }
  geometry.coefficients = reduction.Keep(geometry.space, inUnits); // exact
  if (mesh.GetSlab())
  {
    try
    {
      Lift(*mesh.GetSlab(), units, geometry);
    }
    catch (const InvalidData& error)
    {
      throw InvalidData(mesh.Describe(element) + " " + error.what());
    }
  }
  return geometry;
}

std::size_t MostCoefficients(const SourceMesh& mesh, int element)
{
  const CellBasis& basis = mesh.Basis(element);
  int modes = 0;
  const auto note = [&](const ChangeOfBasis& change)
  {
    const Space& space = change.Target();
    modes = std::max(modes, mesh.GetSlab() ? Lifted(space).Modes() : space.Modes());
  };
  note(basis.change);
  std::ranges::for_each(basis.straight, note);
  return 3 * static_cast<std::size_t>(modes);
}
} // namespace pixelexact
