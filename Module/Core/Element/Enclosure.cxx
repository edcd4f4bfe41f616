// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Enclosure.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
/// The lanes' arithmetic adds 2^-1000 here and there in place of a closer look at underflow: what
/// they work on has to be far above that.
constexpr double kLeast = 0x1p-900;

/// A field's coefficients in one element, multiplied by a power of two where they are tiny.
class ScaledCoefficients
{
public:
  ScaledCoefficients(const Expansion& values, int element)
    : Coefficients(values.Coefficients(element))
  {
    const auto count =
      static_cast<std::size_t>(values.components) * values.SpaceOf(element).Modes();
    double largest = 0.0;
    for (std::size_t k = 0; k < count; ++k)
    {
      largest = std::max(largest, std::fabs(Coefficients[k]));
    }
    if (largest > 0.0 && largest < kLeast)
    {
      const int exponent = std::ilogb(largest);
      Scale = std::ldexp(1.0, exponent);
      // Upwards, and to no more than 2: exact.
      Storage.resize(count);
      std::transform(Coefficients, Coefficients + count, Storage.begin(),
        [exponent](double c) { return std::ldexp(c, -exponent); });
      Coefficients = Storage.data();
    }
  }
  [[nodiscard]] const double* Data() const { return Coefficients; }
  /// The true coefficients are Data() times this.
  [[nodiscard]] double Factor() const { return Scale; }

private:
  const double* Coefficients;
  std::vector<double> Storage;
  double Scale = 1.0;
};

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

Interval ToWorld(double middle, double radius, double factor, int powers, double size)
{
  if (!(std::fabs(middle) <= std::numeric_limits<double>::max()) ||
    !(radius <= std::numeric_limits<double>::max()))
  {
    return Interval::Everything();
  }
  Interval value = Interval::Around(middle, radius);
  if (factor != 1.0)
  {
    value *= factor;
  }
  // One factor after the other: the cube of a size may overflow where the quotient does not.
  for (int k = 0; k < powers; ++k)
  {
    value = value / size;
  }
  return value;
}

bool IsUsableSize(double size)
{
  int exponent = 0;
  return size >= kLeast && size <= 1.0 / kLeast && std::frexp(size, &exponent) == 0.5;
}
} // namespace

void EncloseValues(const Mesh& mesh, const Field& field, int element, const LanePoints& xi,
  const LanePoints& x, double* const* lower, double* const* upper, const EnclosureOptions& options)
{
  const double size = mesh.size[element];
  const int components = field.values.components;
  if (!IsUsableSize(size))
  {
    for (int c = 0; c < components; ++c)
    {
      std::fill_n(lower[c], xi.count, Interval::Everything().lower);
      std::fill_n(upper[c], xi.count, Interval::Everything().upper);
    }
    return;
  }
  const ScaledCoefficients coefficients(field.values, element);
  EnclosureTask task{};
  task.mapSpace = mesh.map.SpaceOf(element);
  task.mapCoefficients = mesh.map.Coefficients(element);
  std::copy_n(&mesh.centre[3 * static_cast<std::size_t>(element)], 3, task.centre);
  task.inverseSize = 1.0 / size;
  task.uncertainty =
    options.meshUncertainty ? rounding::Above(mesh.uncertainty[element] / size) : 0.0;
  task.space = field.values.SpaceOf(element);
  task.coefficients = coefficients.Data();
  task.components = components;
  task.mapping = field.mapping;
  EncloseInLanes(task, xi, x, lower, upper);
  const int powers = PowersOfInverseSize(field.mapping);
  for (int c = 0; c < components; ++c)
  {
    for (int i = 0; i < xi.count; ++i)
    {
      const Interval value = ToWorld(lower[c][i], upper[c][i], coefficients.Factor(), powers, size);
      lower[c][i] = value.lower;
      upper[c][i] = value.upper;
    }
  }
}
} // namespace pixelexact
