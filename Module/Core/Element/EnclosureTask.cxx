// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/EnclosureTask.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{
/// The lanes' arithmetic adds 2^-1000 here and there in place of a closer look at underflow: what
/// they work on has to be far above that.
constexpr double kMin = 0x1p-900;

/// Powers of 1 / size by which a value in the element's units becomes one in the world's.
int PowersOfInverseSize(Mapping mapping)
{
  switch (mapping)
  {
    case Mapping::Covariant:
      return 1;
    case Mapping::Contravariant:
      return 2;
    case Mapping::Density:
      return 3;
    default:
      return 0;
  }
}

bool IsUsableSize(double size)
{
  int exponent = 0;
  return size >= kMin && size <= 1.0 / kMin && std::frexp(size, &exponent) == 0.5;
}
} // namespace

EnclosureProblem::EnclosureProblem(
  const Mesh& mesh, const Field& field, int element, double uncertainty)
  : Size(mesh.size[element])
  , Usable(IsUsableSize(Size))
{
  if (!Usable)
  {
    return;
  }
  task_.mapSpace = mesh.map.SpaceOf(element);
  task_.mapCoefficients = mesh.map.Coefficients(element);
  std::copy_n(&mesh.centre[3 * static_cast<std::size_t>(element)], 3, task_.centre);
  task_.inverseSize = 1.0 / Size;
  task_.uncertainty = uncertainty == 0.0 ? 0.0 : rounding::Above(uncertainty / Size);
  task_.space = field.values.SpaceOf(element);
  task_.coefficients = field.values.Coefficients(element);
  task_.components = field.values.components;
  task_.mapping = field.mapping;

  const std::span coefficients(
    task_.coefficients, static_cast<std::size_t>(task_.components) * task_.space.Modes());
  double largest = 0.0;
  for (const double c : coefficients)
  {
    largest = std::max(largest, std::fabs(c));
  }
  IsZero = std::ranges::all_of(coefficients, [](double c) { return c == 0.0; });
  if (largest > 0.0 && largest < kMin)
  {
    const int exponent = std::ilogb(largest);
    Factor = std::ldexp(1.0, exponent);
    // Upwards, and to no more than 2: exact.
    Scaled.resize(coefficients.size());
    std::ranges::transform(
      coefficients, Scaled.begin(), [exponent](double c) { return std::ldexp(c, -exponent); });
    task_.coefficients = Scaled.data();
  }
}

Interval EnclosureProblem::ToWorld(double middle, double radius, bool isDerivative) const
{
  if (!(std::fabs(middle) <= std::numeric_limits<double>::max()) ||
    !(radius <= std::numeric_limits<double>::max()))
  {
    return Interval::Everything();
  }
  if (IsZero)
  {
    return 0.0;
  }
  Interval value = Interval::Around(middle, radius);
  if (Factor != 1.0)
  {
    value *= Factor;
  }
  // One factor after the other: the cube of a size may overflow where the quotient does not.
  for (int k = isDerivative ? -1 : 0; k < PowersOfInverseSize(task_.mapping); ++k)
  {
    value = value / Size;
  }
  return value;
}
} // namespace pixelexact
