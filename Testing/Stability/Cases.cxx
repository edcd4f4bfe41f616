// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/Cases.h"

#include "Stability/Elements.h"
#include "Stability/Samplers.h"

#include "Core/Shape/Shape.h"

namespace pixelexact::testing
{
namespace
{
/// Curved, and linear in eta with it, stays injective on the shapes enlarged this much in eta.
constexpr double kReach = 0.1;

std::vector<int> Choose(Extent extent, std::vector<int> few, int from, int to, int step)
{
  if (extent == Extent::Short)
  {
    return few;
  }
  std::vector<int> all;
  for (int value = from; value <= to; value += step)
  {
    all.push_back(value);
  }
  return all;
}

LocationCase MakeCase(std::string sweep, std::string parameter, double at, Shape shape, int order,
  MeshBuilder mesh, double reach = kReach)
{
  LocationCase result{ std::move(sweep), std::move(parameter), at, shape, order, std::move(mesh), 0,
    {}, {} };
  result.inside = [shape](Random& random) { return AnywhereInside(shape, random); };
  result.outside = [shape, reach](Random& random) { return BeyondAFace(shape, reach, random); };
  return result;
}

using Cases = std::vector<LocationCase>;

void AddOrders(Extent extent, Cases& cases)
{
  for (const int order : extent == Extent::Short ? std::vector<int>{ 1, 2, 4, 7 } : AllOrders())
  {
    for (const Shape shape : kShapes)
    {
      const double reach = order > 8 ? 0.01 : 0.05;
      MeshBuilder mesh;
      AddPerturbed(mesh, UniformSpace(shape, order), reach);
      cases.push_back(MakeCase("order", "order", order, shape, order, std::move(mesh), reach));
    }
  }
}

void AddSizes(Extent extent, Cases& cases)
{
  for (const Shape shape : kShapes)
  {
    for (const int exponent : Choose(extent, { -150, -20, 0, 149, 150 }, -150, 150, 10))
    {
      MeshBuilder mesh;
      AddAffine(mesh, shape, Identity(), std::pow(10.0, exponent));
      cases.push_back(
        MakeCase("size", "size", std::pow(10.0, exponent), shape, 3, std::move(mesh)));
    }
  }
}

void AddOffsets(Extent extent, Cases& cases)
{
  for (const Shape shape : kShapes)
  {
    for (const int exponent : Choose(extent, { 0, 4, 8 }, 0, 14, 1))
    {
      const double offset = std::pow(10.0, exponent);
      MeshBuilder mesh;
      AddAffine(mesh, shape, Identity(), 1.0, offset * Vec3(1.0, -0.7, 0.3));
      cases.push_back(MakeCase("offset", "offset over size", offset, shape, 3, std::move(mesh)));
    }
  }
}

void AddAspectRatios(Extent extent, Cases& cases)
{
  for (const Shape shape : kShapes)
  {
    for (const int exponent : Choose(extent, { 2, 5, 8 }, 0, 12, 1))
    {
      const long double ratio = std::pow(10.0L, exponent);
      const auto add = [&](const char* sweep, const LongMat3& map)
      {
        MeshBuilder mesh;
        AddAffine(mesh, shape, map, 1.0);
        cases.push_back(
          MakeCase(sweep, "aspect ratio", static_cast<double>(ratio), shape, 3, std::move(mesh)));
      };
      add("plate along the axes", Diagonal(1, 1, 1 / ratio));
      add("plate, turned", Product(Rotation(), Diagonal(1, 1, 1 / ratio)));
      add("needle, turned", Product(Rotation(), Diagonal(1, 1 / ratio, 1 / ratio)));
    }
  }
}

void AddSkew(Extent extent, Cases& cases)
{
  for (const Shape shape : kShapes)
  {
    for (const int exponent : Choose(extent, { 1, -2, -6 }, -10, 1, 1))
    {
      const double degrees = std::pow(10.0, exponent);
      MeshBuilder mesh;
      AddAffine(mesh, shape, Product(Rotation(), Skew(degrees)), 1.0);
      cases.push_back(MakeCase("skew", "angle in degrees", degrees, shape, 3, std::move(mesh)));
    }
  }
}

void AddDeterminants(Extent extent, Cases& cases)
{
  for (const Shape shape : kShapes)
  {
    for (const int exponent : Choose(extent, { -1, -4, -8, -12 }, -14, 0, 1))
    {
      const double least = std::pow(10.0, exponent);
      MeshBuilder mesh;
      AddPinched(mesh, shape, least);
      auto added = MakeCase("det J to 0 inside", "least det J", least, shape, 3, std::move(mesh));
      // Half of the points close to the surface xi1 = 0, where det J is least.
      added.inside = [shape](Random& random)
      {
        Vec3 xi = AnywhereInside(shape, random);
        const double near = std::pow(10.0, random(-16.0, 0.0)) * (random() < 0.0 ? -1.0 : 1.0);
        const Vec3 moved(near, xi.y, xi.z);
        return random() < 0.0 && Margin(shape, moved) >= 0.0 ? moved : xi;
      };
      cases.push_back(std::move(added));
    }
  }
}

void AddBends(Extent extent, Cases& cases)
{
  for (const Shape shape : kShapes)
  {
    for (const int percent : Choose(extent, { 50, 90 }, 0, 95, 5))
    {
      MeshBuilder mesh;
      const int order = AddLetterC(mesh, shape, percent / 100.0);
      cases.push_back(
        MakeCase("letter C", "closed to", percent / 100.0, shape, order, std::move(mesh), 0.05));
    }
  }
}

void AddSpirals(Extent extent, Cases& cases)
{
  for (const double turns : extent == Extent::Short
      ? std::vector<double>{ 1.5 }
      : std::vector<double>{ 0.5, 1.0, 1.5, 2.0, 2.5 })
  {
    for (const auto& [shape, orders] : { std::pair{ Shape::Hexahedron, SpiralHexahedron() },
           std::pair{ Shape::Prism, SpiralPrism() } })
    {
      MeshBuilder mesh;
      AddSpiral(mesh, orders, turns);
      auto added = MakeCase("spiral", "turns", turns, shape, 20, std::move(mesh));
      // Beyond the ends a polynomial of order 20 goes anywhere: only across the spiral.
      const int along = shape == Shape::Prism ? 1 : 0;
      added.outside = [shape = shape, along](Random& random)
      {
        for (;;)
        {
          const Vec3 xi = BeyondAFace(shape, kReach, random);
          if (std::fabs(xi[along]) <= 1.0)
          {
            return xi;
          }
        }
      };
      cases.push_back(std::move(added));
    }
  }
}

void AddCollapsed(Extent extent, Cases& cases)
{
  for (const Shape shape : { Shape::Prism, Shape::Tetrahedron, Shape::Pyramid })
  {
    for (const int exponent : Choose(extent, { -1, -6, -12, -15 }, -16, 0, 1))
    {
      const double distance = std::pow(10.0, exponent);
      MeshBuilder mesh;
      AddAffine(mesh, shape, Identity(), 1.0);
      auto added = MakeCase("collapsed", "distance", distance, shape, 3, std::move(mesh));
      added.inside = [shape, distance](Random& random)
      { return NearCollapsed(shape, distance, random); };
      added.outside = [shape, distance](Random& random)
      { return BeyondNearCollapsed(shape, distance, random); };
      cases.push_back(std::move(added));
    }
  }
}

/// Elements of all sizes in one mesh.
void AddMixtures(Extent extent, Cases& cases)
{
  for (const Shape shape : kShapes)
  {
    const auto exponents = Choose(extent, { -150, 0, 150 }, -150, 150, 50);
    MeshBuilder mesh;
    for (const int exponent : exponents)
    {
      // The elements are apart: each is three of its own sizes away from the origin.
      const double size = std::pow(10.0, exponent);
      AddAffine(mesh, shape, Identity(), size, size * Vec3(3.0, 3.0, -3.0));
    }
    for (std::size_t e = 0; e < exponents.size(); ++e)
    {
      auto added =
        MakeCase("sizes in one mesh", "size", std::pow(10.0, exponents[e]), shape, 3, mesh);
      added.element = static_cast<int>(e);
      cases.push_back(std::move(added));
    }
  }
}
} // namespace

std::vector<int> AllOrders()
{
  std::vector<int> orders;
  for (int order = 1; order <= kMaxOrder; order += order < 16 ? 1 : 4)
  {
    orders.push_back(order);
  }
  return orders;
}

std::span<const LocationSweep> LocationSweeps()
{
  static constexpr LocationSweep kSweeps[] = { { "Orders", AddOrders }, { "Sizes", AddSizes },
    { "Offsets", AddOffsets }, { "AspectRatios", AddAspectRatios }, { "Skew", AddSkew },
    { "Determinants", AddDeterminants }, { "Bends", AddBends }, { "Spirals", AddSpirals },
    { "Collapsed", AddCollapsed }, { "Mixtures", AddMixtures } };
  return kSweeps;
}
} // namespace pixelexact::testing
