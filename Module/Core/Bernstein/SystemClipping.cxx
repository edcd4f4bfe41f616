// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/SystemClipping.h"

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pixelexact
{
namespace
{
/// A box is not made thinner than this in one step, relative to its largest width.
constexpr double kThinnest = 0x1p-8;

bool Meet(Section& section, const Section& other)
{
  section.from = std::max(section.from, other.from);
  section.to = std::min(section.to, other.to);
  return !(section.from > section.to);
}

SmallMatrix MeanJacobian(const LocalSystem& system)
{
  const std::size_t size = CoefficientCount(system.degree);
  SmallMatrix mean{};
  for (int k = 0; k < system.equations; ++k)
  {
    const auto b = system.Polynomial(k);
    for (int d = 0; d < system.variables; ++d)
    {
      const std::size_t stride = StrideOf(system.degree, d);
      const auto count = static_cast<std::size_t>(system.degree[static_cast<std::size_t>(d)]) + 1;
      double sum = 0.0;
      for (std::size_t block = 0; count > 1 && block < size; block += stride * count)
      {
        for (std::size_t at = block; at < block + stride; ++at)
        {
          sum -= b[at];
        }
        for (std::size_t at = block + stride * (count - 1); at < block + stride * count; ++at)
        {
          sum += b[at];
        }
      }
      mean[static_cast<std::size_t>(k)][static_cast<std::size_t>(d)] =
        sum * static_cast<double>(count) / static_cast<double>(size);
    }
  }
  return mean;
}

/// Clips by P f, P near the inverse of the mean Jacobian: P f vanishes exactly where f does, and
/// its i-th component is nearly t_i minus the root's. `room`: half of the width that a section
/// should keep.
bool ClipPreconditioned(const LocalSystem& system, Sections& sections, Parameters& room)
{
  const auto inverse = Inverse(system.variables, MeanJacobian(system));
  if (!inverse)
  {
    return true;
  }
  std::vector<double> combined(CoefficientCount(system.degree));
  for (std::size_t i = 0; i < static_cast<std::size_t>(system.variables); ++i)
  {
    double error = 0.0;
    double magnitude = 0.0;
    std::array<const double*, 3> rows{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(system.equations); ++k)
    {
      const double weight = (*inverse)[i][k];
      const auto from = system.Polynomial(static_cast<int>(k));
      rows[k] = from.data();
      error += std::fabs(weight) * system.error[k];
      magnitude += std::fabs(weight) * LargestMagnitude(from);
    }
    Combine(
      { (*inverse)[i].data(), static_cast<std::size_t>(system.equations) }, rows.data(), combined);
    error = (error + Gamma(8) * magnitude) * (1.0 + Gamma(16)) +
      16.0 * std::numeric_limits<double>::denorm_min();
    if (!Meet(sections[i], ClipToZero(system.degree, static_cast<int>(i), combined, error)))
    {
      return false;
    }
    // In a box that is no wider than the effect of the errors on a root, Krawczyk's test could not
    // succeed.
    room[i] = std::max(room[i], 8.0 * error);
  }
  return true;
}

/// The Jacobian at a corner; bit d of its number: the upper end in direction d.
SmallMatrix CornerJacobian(const LocalSystem& system, unsigned corner)
{
  const auto isUpper = [corner](int d) { return (corner >> static_cast<unsigned>(d) & 1U) != 0U; };
  std::size_t at = 0;
  for (int d = 0; d < system.variables; ++d)
  {
    const auto degree = static_cast<std::size_t>(system.degree[static_cast<std::size_t>(d)]);
    at += isUpper(d) ? degree * StrideOf(system.degree, d) : 0;
  }
  SmallMatrix jacobian{};
  for (int k = 0; k < system.equations; ++k)
  {
    const auto b = system.Polynomial(k);
    for (int d = 0; d < system.variables; ++d)
    {
      const std::size_t stride = StrideOf(system.degree, d);
      const int degree = system.degree[static_cast<std::size_t>(d)];
      if (degree > 0)
      {
        jacobian[static_cast<std::size_t>(k)][static_cast<std::size_t>(d)] =
          degree * (isUpper(d) ? b[at] - b[at - stride] : b[at + stride] - b[at]);
      }
    }
  }
  return jacobian;
}
} // namespace

bool ClipSystem(const LocalSystem& system, const Parameters& width, Sections& sections)
{
  const auto n = static_cast<std::size_t>(system.variables);
  for (int k = 0; k < system.equations; ++k)
  {
    for (std::size_t d = 0; d < n; ++d)
    {
      if (!Meet(sections[d],
            ClipToZero(system.degree, static_cast<int>(d), system.Polynomial(k),
              system.error[static_cast<std::size_t>(k)])))
      {
        return false;
      }
    }
  }
  // One equation may narrow one direction far more than the others can be: a sliver, in which
  // nothing can be said of the others.
  Parameters room{};
  for (std::size_t d = 0; d < n; ++d)
  {
    room[d] = kThinnest * std::ranges::max(width) / width[d];
  }
  if (system.variables == system.equations && !ClipPreconditioned(system, sections, room))
  {
    return false;
  }
  for (std::size_t d = 0; d < n; ++d)
  {
    const double middle = 0.5 * (sections[d].from + sections[d].to);
    sections[d].from = std::min(sections[d].from, std::max(0.0, middle - room[d]));
    sections[d].to = std::max(sections[d].to, std::min(1.0, middle + room[d]));
  }
  return true;
}

bool IsLostInErrors(const LocalSystem& system)
{
  const auto n = static_cast<std::size_t>(system.variables);
  double least = std::numeric_limits<double>::infinity();
  for (unsigned corner = 0; corner < (1U << n); ++corner)
  {
    const auto inverse = Inverse(system.variables, CornerJacobian(system, corner));
    if (!inverse)
    {
      continue;
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      double moved = 0.0;
      for (std::size_t k = 0; k < n; ++k)
      {
        moved += std::fabs((*inverse)[i][k]) * system.error[k];
      }
      largest = std::max(largest, moved);
    }
    least = std::min(least, largest);
  }
  return least > 0.5;
}
} // namespace pixelexact
