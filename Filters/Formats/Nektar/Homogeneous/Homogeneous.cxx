// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Homogeneous/Homogeneous.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Homogeneous/FourierLayers.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace pixelexact::nektar
{
namespace
{
// Turns one layer of elements into many, with Fourier's functions as polynomials across them.

/// The direction in which layers are stacked.
enum class Along : std::uint8_t
{
  Y,
  Z
};

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

OwnedExpansion AllocateLayers(
  const OwnedExpansion& plane, std::size_t layers, Along direction, int order)
{
  OwnedExpansion lifted;
  for (Space space : plane.spaces)
  {
    space.order[Across(space.shape, direction)] = static_cast<std::uint8_t>(order);
    lifted.spaces.push_back(space);
  }
  for (std::size_t layer = 0; layer < layers; ++layer)
  {
    lifted.spaceOf.insert(lifted.spaceOf.end(), plane.spaceOf.begin(), plane.spaceOf.end());
  }
  lifted.Allocate();
  return lifted;
}

/// The field on them: `planes` has all functions of one beginning after the other.
OwnedExpansion LiftField(
  std::span<const OwnedExpansion> planes, const FourierLayers& layers, Along direction, int order)
{
  const std::size_t elements = planes.front().spaceOf.size();
  const std::size_t functions = layers.Functions();
  const auto count = static_cast<std::size_t>(layers.Layers());
  const std::size_t orders = static_cast<std::size_t>(order) + 1;
  const auto along = LayerCoefficients(layers, order);
  OwnedExpansion lifted =
    AllocateLayers(planes.front(), planes.size() / functions * count, direction, order);
  const auto lift = [&](std::size_t at, std::vector<double>& sums)
  {
    const std::size_t layer = at / elements % count;
    const auto own = planes.subspan(at / elements / count * functions, functions);
    const std::size_t e = at % elements;
    const Space& space = lifted.SpaceOf(at);
    const std::size_t modes = own.front().Coefficients(e).size();
    sums.assign(orders * modes, 0.0);
    for (std::size_t f = 0; f < functions; ++f)
    {
      const auto source = own[f].Coefficients(e);
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
    double* target = lifted.Coefficients(at).data();
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

/// Copies the elements into the layers, once from each of `begin` on. A map's modes along the
/// direction go: what was there is a slab. Throws Unsupported for more elements, or larger numbers,
/// than there may be.
void LiftMesh(
  const FourierLayers& layers, Along direction, const std::vector<double>& begin, SolverMesh& mesh)
{
  if (mesh.slab)
  {
    RequirePlane(*mesh.slab, "Fourier functions");
  }
  const std::size_t elements = mesh.number.size();
  const auto component = static_cast<std::size_t>(direction == Along::Y ? 1 : 2);
  SolverMesh lifted;
  lifted.map.components = 3;
  lifted.map.spaces = mesh.map.spaces;
  const std::size_t size = mesh.map.coefficients.size();
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
  lifted.map.coefficients = CoefficientBlock(size * count);
  int exponent = 0;
  std::frexp(layers.Half(), &exponent);
  for (std::size_t layer = 0; layer < count; ++layer)
  {
    const double from = begin[layer / each];
    for (std::size_t e = 0; e < elements; ++e)
    {
      const Space& space = mesh.map.SpaceOf(e);
      const auto modes = static_cast<std::size_t>(space.Modes());
      const auto offset = layer * size + static_cast<std::size_t>(mesh.map.offset[e]);
      const double own = std::max(mesh.size[e], std::ldexp(1.0, exponent)); // powers of two
      double* target = lifted.map.coefficients.data() + offset;
      std::ranges::transform(mesh.map.Coefficients(e), target,
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

/// Half modes: the field that is the imaginary part, and the functions of the parts among
/// Fourier's.
constexpr const char* kImaginaryField = "w";
constexpr int kFirstCosine = 2;
constexpr int kFirstSine = 3;

/// A number as people read it.
std::string Short(double number)
{
  constexpr int kDigits = 3;
  char text[32];
  const auto end =
    std::to_chars(text, text + sizeof(text), number, std::chars_format::general, kDigits);
  return { text, end.ptr };
}

FourierLayers LayersAlongZ(const Homogeneous& along, bool imaginary)
{
  return FourierLayers(along.half == HalfMode::None
      ? along.z
      : Periodic{ along.z.length, { imaginary ? kFirstSine : kFirstCosine } });
}

/// The planes of a field in layers along y, those of one function of z after the other.
std::vector<OwnedExpansion> LiftAlongY(
  std::vector<OwnedExpansion> planes, const FourierLayers& layers, int order)
{
  std::vector<OwnedExpansion> lifted;
  for (std::size_t at = 0; at < planes.size(); at += layers.Functions())
  {
    lifted.push_back(
      LiftField(std::span(planes).subspan(at, layers.Functions()), layers, Along::Y, order));
  }
  return lifted;
}

std::string Counts(const FourierLayers* y, const std::string& z, const std::string& ofY)
{
  return y != nullptr ? ofY + " x " + z : z;
}

void AddNotes(const Homogeneous& along, const std::vector<double>& begin, const FourierLayers* y,
  const FourierLayers& z, const std::string& end, std::vector<std::string>& notes)
{
  notes.push_back(std::string("homogeneous along ") + (y != nullptr ? "y and z" : "z") +
    ": periodic with the length" + (y != nullptr ? "s " : " ") +
    Counts(y, Short(along.z.length), y != nullptr ? Short(along.y->length) : "") + ", " +
    Counts(y, std::to_string(along.z.functions.size()),
      y != nullptr ? std::to_string(y->Functions()) : "") +
    " Fourier functions; they are polynomials in " +
    Counts(y, std::to_string(z.Layers()), y != nullptr ? std::to_string(y->Layers()) : "") +
    " layers of elements, of order " + end);
  if (along.strips)
  {
    notes.push_back(std::to_string(begin.size()) + " strips, from z = " + Short(begin.front()) +
      " to " + Short(begin.back() + along.z.length) +
      ", where DistStrip puts them; between them there is nothing, and in each the field has the "
      "period.");
  }
  if (along.half != HalfMode::None)
  {
    notes.emplace_back(std::string("half mode: fields are ") +
      (along.half == HalfMode::Real ? "cosines of z, and w, as Nektar++'s solvers take it, a sine"
                                    : "sines of z, with the sign of Nektar++'s derivatives") +
      "; where others are imaginary, convert the file (FieldConvert -m "
      "halfmodetofourier:realmodetoimag=2 in.xml in.fld out.fld, with the numbers of these "
      "fields).");
  }
}
} // namespace

void LiftHomogeneous(const Homogeneous& along, const std::vector<double>& begin,
  std::vector<HomogeneousField> fields, SolverModel& model)
{
  const FourierLayers cosines = LayersAlongZ(along, false);
  const FourierLayers sines = LayersAlongZ(along, true);
  std::optional<FourierLayers> alongY;
  if (along.y)
  {
    alongY.emplace(*along.y);
    LiftMesh(*alongY, Along::Y, { 0.0 }, model.mesh);
  }
  const FourierLayers* y = alongY ? &*alongY : nullptr;
  LiftMesh(cosines, Along::Z, begin, model.mesh);
  std::string orders;
  double worst = 0.0;
  for (HomogeneousField& field : fields)
  {
    const bool isImaginary = along.half == HalfMode::Imaginary || field.name == kImaginaryField;
    const FourierLayers& z = isImaginary ? sines : cosines;
    const Accuracy accuracy = AccuracyOf(field, y, z);
    SolverField lifted;
    lifted.name = field.name;
    lifted.basis = field.basis + " x " + std::to_string(along.Functions()) + " Fourier functions";
    if (y != nullptr)
    {
      field.planes = LiftAlongY(std::move(field.planes), *y, accuracy.orderY);
    }
    lifted.values = LiftField(field.planes, z, Along::Z, accuracy.orderZ);
    field.planes.clear();
    if (along.half != HalfMode::None && !isImaginary)
    {
      CoefficientBlock& block = lifted.values.coefficients;
      std::ranges::transform(block, block.begin(), std::negate<>());
    }
    model.fields.push_back(std::move(lifted));
    orders += (orders.empty() ? "" : ", ") +
      Counts(y, std::to_string(accuracy.orderZ), std::to_string(accuracy.orderY)) + " (" +
      field.name + ")";
    worst = std::max(worst, accuracy.range > 0.0 ? accuracy.loss / accuracy.range : 0.0);
  }
  AddNotes(along, begin, y, cosines,
    orders + ", which are off by at most " + Short(worst) + " of a field's range.", model.notes);
}
} // namespace pixelexact::nektar
