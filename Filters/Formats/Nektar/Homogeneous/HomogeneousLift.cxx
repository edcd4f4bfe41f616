// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Homogeneous/HomogeneousLift.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Homogeneous/HomogeneousAccuracy.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pixelexact::nektar
{
namespace
{
/// The direction of xi.
std::size_t Across(Shape shape, Along direction)
{
  return shape == Shape::Prism || direction == Along::Y ? 1 : 2;
}

/// Per layer, function and order the coefficients of Legendre's polynomials, orders fastest.
std::vector<double> LayerCoefficients(const FourierLayers& layers, int order)
{
  std::vector<double> values;
  for (int layer = 0; layer < layers.Layers(); ++layer)
  {
    for (std::size_t f = 0; f < layers.Functions(); ++f)
    {
      for (int n = 0; n <= order; ++n)
      {
        values.push_back(layers.Coefficient(layer, f, n));
      }
    }
  }
  return values;
}

SolverExpansion AllocateLayers(
  const SolverExpansion& plane, std::size_t layers, Along direction, int order)
{
  SolverExpansion lifted;
  for (Space space : plane.spaces)
  {
    space.order[Across(space.shape, direction)] = static_cast<std::uint8_t>(order);
    lifted.spaces.push_back(space);
  }
  std::size_t size = 0;
  for (std::size_t layer = 0; layer < layers; ++layer)
  {
    for (const std::int32_t space : plane.spaceOf)
    {
      lifted.spaceOf.push_back(space);
      lifted.offset.push_back(static_cast<std::int64_t>(size));
      size += static_cast<std::size_t>(lifted.spaces[static_cast<std::size_t>(space)].Modes());
    }
  }
  lifted.coefficients = { std::unique_ptr<double[]>(new double[size]), size };
  return lifted;
}
} // namespace

SolverExpansion LiftField(
  std::span<const SolverExpansion> planes, const FourierLayers& layers, Along direction, int order)
{
  const std::size_t elements = planes.front().spaceOf.size();
  const std::size_t functions = layers.Functions();
  const auto count = static_cast<std::size_t>(layers.Layers());
  const std::size_t orders = static_cast<std::size_t>(order) + 1;
  const auto along = LayerCoefficients(layers, order);
  SolverExpansion lifted =
    AllocateLayers(planes.front(), planes.size() / functions * count, direction, order);
  const auto lift = [&](std::size_t at, std::vector<double>& sums)
  {
    const std::size_t layer = at / elements % count;
    const auto own = planes.subspan(at / elements / count * functions, functions);
    const std::size_t e = at % elements;
    const Space& space = lifted.spaces[static_cast<std::size_t>(lifted.spaceOf[at])];
    const std::size_t modes = CoefficientsOf(own.front(), e).size();
    sums.assign(orders * modes, 0.0);
    for (std::size_t f = 0; f < functions; ++f)
    {
      const auto source = CoefficientsOf(own[f], e);
      for (std::size_t n = 0; n < orders; ++n)
      {
        const double factor = along[(layer * functions + f) * orders + n];
        for (std::size_t m = 0; m < modes; ++m)
        {
          sums[n * modes + m] += factor * source[m];
        }
      }
    }
    const std::size_t across = Across(space.shape, direction);
    const bool downwards = space.shape == Shape::Prism; // xi2 runs against z
    std::vector<std::size_t> planar(orders, 0);
    double* target = &lifted.coefficients.data[static_cast<std::size_t>(lifted.offset[at])];
    ForEachMode(space,
      [&](int p, int q, int r, int mode)
      {
        // Modes of one order across follow each other as those of the plane element.
        const auto n = static_cast<std::size_t>(std::array<int, 3>{ p, q, r }[across]);
        const double value = sums[n * modes + planar[n]++];
        target[mode] = downwards && n % 2 != 0 ? -value : value;
      });
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lifted.spaceOf.size(), 64),
    [&lift](const tbb::blocked_range<std::size_t>& range)
    {
      std::vector<double> sums;
      for (std::size_t at = range.begin(); at < range.end(); ++at)
      {
        lift(at, sums);
      }
    });
  return lifted;
}

void LiftMesh(
  const FourierLayers& layers, Along direction, const std::vector<double>& begin, SolverMesh& mesh)
{
  const std::size_t elements = mesh.number.size();
  const auto component = static_cast<std::size_t>(direction == Along::Y ? 1 : 2);
  SolverMesh lifted;
  lifted.map.components = 3;
  lifted.map.spaces = mesh.map.spaces;
  const std::size_t size = mesh.map.coefficients.size;
  const auto each = static_cast<std::size_t>(layers.Layers());
  const std::size_t count = each * begin.size();
  const std::int64_t largest = *std::ranges::max_element(mesh.number);
  if (largest >= std::numeric_limits<std::int64_t>::max() / static_cast<std::int64_t>(count) ||
    elements > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()) / count)
  {
    throw Unsupported("the mesh in " + std::to_string(count) +
      " layers has more elements, or larger numbers, than are read.");
  }
  const std::int64_t stride = 1 + largest;
  lifted.map.coefficients = { std::unique_ptr<double[]>(new double[size * count]), size * count };
  int exponent = 0;
  std::frexp(layers.Half(), &exponent);
  for (std::size_t layer = 0; layer < count; ++layer)
  {
    const double from = begin[layer / each];
    for (std::size_t e = 0; e < elements; ++e)
    {
      const Space& space = mesh.map.spaces[static_cast<std::size_t>(mesh.map.spaceOf[e])];
      const auto modes = static_cast<std::size_t>(space.Modes());
      const auto offset = layer * size + static_cast<std::size_t>(mesh.map.offset[e]);
      const double own = std::max(mesh.size[e], std::ldexp(1.0, exponent)); // powers of two
      double* target = &lifted.map.coefficients.data[offset];
      std::ranges::transform(CoefficientsOf(mesh.map, e), target,
        [&](double value) { return value * (mesh.size[e] / own); });
      ForEachMode(space,
        [&](int p, int q, int r, int mode)
        {
          double& place = target[component * modes + static_cast<std::size_t>(mode)];
          const bool linear =
            p + q + r == 1 && std::array<int, 3>{ p, q, r }[Across(space.shape, direction)] == 1;
          place = linear ? std::copysign(layers.Half() / own, place) : 0.0;
        });
      lifted.map.spaceOf.push_back(mesh.map.spaceOf[e]);
      lifted.map.offset.push_back(static_cast<std::int64_t>(offset));
      std::array<double, 3> centre{ mesh.centre[3 * e], mesh.centre[3 * e + 1],
        mesh.centre[3 * e + 2] };
      centre[component] = from + layers.Middle(static_cast<int>(layer % each));
      lifted.centre.insert(lifted.centre.end(), centre.begin(), centre.end());
      lifted.size.push_back(own);
      lifted.uncertainty.push_back(mesh.uncertainty[e] +
        8 * std::numeric_limits<double>::epsilon() * (std::fabs(from) + layers.Length()));
      lifted.number.push_back(mesh.number[e] + static_cast<std::int64_t>(layer) * stride);
      lifted.corners.push_back(mesh.corners[e]);
      lifted.attribute.push_back(mesh.attribute[e]);
    }
    for (const BoundaryFace& face : mesh.boundary)
    {
      lifted.boundary.push_back(
        { face.element + static_cast<std::int32_t>(layer * elements), face.face, face.attribute });
    }
  }
  lifted.groups = std::move(mesh.groups);
  mesh = std::move(lifted);
}
} // namespace pixelexact::nektar
