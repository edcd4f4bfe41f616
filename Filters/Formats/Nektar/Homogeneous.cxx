// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Homogeneous.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/FourierLayers.h"
#include "Formats/Nektar/HomogeneousAccuracy.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

namespace pixelexact::nektar
{
namespace
{
/// Half modes: the field that is the imaginary part, and the function that it has among Fourier's.
constexpr const char* kImaginaryField = "w";
constexpr int kFirstSine = 3;

std::size_t Across(Shape shape)
{
  return shape == Shape::Prism ? 1 : 2;
}

/// A number as people read it.
std::string Short(double number)
{
  constexpr int kDigits = 3;
  char text[32];
  const auto end =
    std::to_chars(text, text + sizeof(text), number, std::chars_format::general, kDigits);
  return { text, end.ptr };
}

Space WithOrderAcross(const Space& plane, int order)
{
  Space space = plane;
  space.order[Across(plane.shape)] = static_cast<std::uint8_t>(order);
  return space;
}

/// Per layer, function and order the coefficients of Legendre's polynomials, orders fastest.
std::vector<double> LayerCoefficients(const FourierLayers& layers, std::size_t functions, int order)
{
  std::vector<double> values;
  for (int layer = 0; layer < layers.Layers(); ++layer)
  {
    for (std::size_t f = 0; f < functions; ++f)
    {
      for (int n = 0; n <= order; ++n)
      {
        values.push_back(layers.Coefficient(layer, f, n));
      }
    }
  }
  return values;
}

SolverExpansion AllocateLayers(const SolverExpansion& plane, int layers, int order)
{
  SolverExpansion lifted;
  for (const Space& space : plane.spaces)
  {
    lifted.spaces.push_back(WithOrderAcross(space, order));
  }
  std::size_t size = 0;
  for (int layer = 0; layer < layers; ++layer)
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

SolverExpansion LiftField(const HomogeneousField& field, const FourierLayers& layers, int order)
{
  const SolverExpansion& plane = field.planes.front();
  const std::size_t elements = plane.spaceOf.size();
  const std::size_t functions = field.planes.size();
  const std::size_t orders = static_cast<std::size_t>(order) + 1;
  const auto along = LayerCoefficients(layers, functions, order);
  SolverExpansion lifted = AllocateLayers(plane, layers.Layers(), order);
  const auto lift = [&](std::size_t at, std::vector<double>& sums)
  {
    const std::size_t layer = at / elements;
    const std::size_t e = at % elements;
    const Space& space = lifted.spaces[static_cast<std::size_t>(lifted.spaceOf[at])];
    const std::size_t modes = CoefficientsOf(plane, e).size();
    sums.assign(orders * modes, 0.0);
    for (std::size_t f = 0; f < functions; ++f)
    {
      const auto source = CoefficientsOf(field.planes[f], e);
      for (std::size_t n = 0; n < orders; ++n)
      {
        const double factor = along[(layer * functions + f) * orders + n];
        for (std::size_t m = 0; m < modes; ++m)
        {
          sums[n * modes + m] += factor * source[m];
        }
      }
    }
    const std::size_t across = Across(space.shape);
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

/// Copies the slab's elements into layers.
void LiftMesh(const FourierLayers& layers, SolverMesh& mesh)
{
  const std::size_t elements = mesh.number.size();
  SolverMesh lifted;
  lifted.map.components = 3;
  lifted.map.spaces = mesh.map.spaces;
  const std::size_t size = mesh.map.coefficients.size;
  const auto count = static_cast<std::size_t>(layers.Layers());
  const std::int64_t largest = *std::ranges::max_element(mesh.number);
  if (largest >= std::numeric_limits<std::int64_t>::max() / layers.Layers() ||
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
          double& z = target[2 * modes + static_cast<std::size_t>(mode)];
          const bool linear =
            p + q + r == 1 && std::array<int, 3>{ p, q, r }[Across(space.shape)] == 1;
          z = linear ? std::copysign(layers.Half() / own, z) : 0.0;
        });
      lifted.map.spaceOf.push_back(mesh.map.spaceOf[e]);
      lifted.map.offset.push_back(static_cast<std::int64_t>(offset));
      lifted.centre.insert(lifted.centre.end(),
        { mesh.centre[3 * e], mesh.centre[3 * e + 1], layers.Middle(static_cast<int>(layer)) });
      lifted.size.push_back(own);
      lifted.uncertainty.push_back(mesh.uncertainty[e] +
        8 * std::numeric_limits<double>::epsilon() * 2 * layers.Half() * layers.Layers());
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
} // namespace

void LiftHomogeneous(
  const Homogeneous& along, const std::vector<HomogeneousField>& fields, SolverModel& model)
{
  const FourierLayers cosines(along);
  LiftMesh(cosines, model.mesh);
  Homogeneous other = along;
  other.functions = { kFirstSine };
  const FourierLayers sines(other);
  const std::string functions = std::to_string(along.functions.size()) + " Fourier functions";
  std::string orders;
  double worst = 0.0;
  for (const HomogeneousField& field : fields)
  {
    const bool isSine = along.isHalfMode && field.name == kImaginaryField;
    const FourierLayers& layers = isSine ? sines : cosines;
    const Accuracy accuracy = AccuracyOf(field, layers);
    SolverField lifted;
    lifted.name = field.name;
    lifted.basis = field.basis + " x " + functions;
    lifted.values = LiftField(field, layers, accuracy.order);
    if (along.isHalfMode && !isSine)
    {
      CoefficientBlock& block = lifted.values.coefficients;
      std::transform(
        block.data.get(), block.data.get() + block.size, block.data.get(), std::negate<>());
    }
    model.fields.push_back(std::move(lifted));
    orders +=
      (orders.empty() ? "" : ", ") + std::to_string(accuracy.order) + " (" + field.name + ")";
    worst = std::max(worst, accuracy.range > 0.0 ? accuracy.loss / accuracy.range : 0.0);
  }
  model.notes.push_back("homogeneous along z: periodic with the length " + Short(along.length) +
    ", " + functions + "; they are polynomials in " + std::to_string(cosines.Layers()) +
    " layers of elements, of order " + orders + ", which are off by at most " + Short(worst) +
    " of a field's range.");
  if (along.isHalfMode)
  {
    model.notes.emplace_back(
      "half mode: fields are cosines of z, and w, as Nektar++'s solvers take it, a sine; where "
      "others are imaginary, convert the file (FieldConvert -m halfmodetofourier:realmodetoimag=2 "
      "in.xml in.fld out.fld, with the numbers of these fields).");
  }
}
} // namespace pixelexact::nektar
