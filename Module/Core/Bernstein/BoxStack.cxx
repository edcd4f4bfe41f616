// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/BoxStack.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Ends of boxes are multiples of this number, so sums and differences of them are exact.
constexpr double kGrid = 0x1p-50;
/// No box is narrower, so that its ends differ on the grid.
constexpr double kNarrowest = 0x1p-40;
/// A box that keeps more than this share of its width is not restricted.
constexpr double kWorthwhile = 0.75;
} // namespace

BoxStack::BoxStack(const PolynomialSystem& system, double smallest)
  : N(static_cast<std::size_t>(system.Variables()))
  , M(static_cast<std::size_t>(system.Equations()))
  , Degree(system.Degree())
  , Size(CoefficientCount(Degree))
  , Smallest(std::max(smallest, kNarrowest))
  , Coefficients(system.Coefficients().begin(), system.Coefficients().end())
{
  Box whole;
  std::fill_n(whole.width.begin(), N, 1.0);
  std::ranges::copy(system.Errors(), whole.error.begin());
  Boxes.push_back(whole);
}

LocalSystem BoxStack::Local() const
{
  return { static_cast<int>(N), static_cast<int>(M), Degree,
    std::span(Coefficients).subspan((Boxes.size() - 1) * M * Size, M * Size), Boxes.back().error };
}

ParameterBox BoxStack::PartOf(const Box& box)
{
  ParameterBox part;
  for (std::size_t d = 0; d < 3; ++d)
  {
    part.lower[d] = box.lower[d];
    part.upper[d] = box.lower[d] + box.width[d];
  }
  return part;
}

std::vector<ParameterBox> BoxStack::Parts() const
{
  std::vector<ParameterBox> parts;
  std::ranges::transform(Boxes, std::back_inserter(parts), &BoxStack::PartOf);
  return parts;
}

std::span<double> BoxStack::Slot(std::size_t box, std::size_t k)
{
  return std::span(Coefficients).subspan((box * M + k) * Size, Size);
}

bool BoxStack::Shrink(const Sections& sections)
{
  bool shrunk = false;
  Box& box = Boxes.back();
  for (std::size_t d = 0; d < N; ++d)
  {
    const double upper = box.lower[d] + box.width[d];
    // One grid unit outward covers the rounding of the ends.
    const double from = std::max(box.lower[d],
      (std::floor((box.lower[d] + sections[d].from * box.width[d]) / kGrid) - 1.0) * kGrid);
    const double to = std::min(
      upper, (std::ceil((box.lower[d] + sections[d].to * box.width[d]) / kGrid) + 1.0) * kGrid);
    const double width = to - from;
    if (!(width < kWorthwhile * box.width[d]) || !(width >= Smallest))
    {
      continue;
    }
    for (std::size_t k = 0; k < M; ++k)
    {
      const auto b = Slot(Boxes.size() - 1, k);
      box.error[k] =
        rounding::Above(box.error[k] + RestrictionError(Degree[d], LargestMagnitude(b)));
      Restrict(Degree, static_cast<int>(d), (from - box.lower[d]) / box.width[d],
        (to - box.lower[d]) / box.width[d], b);
    }
    box.lower[d] = from;
    box.width[d] = width;
    shrunk = true;
  }
  return shrunk;
}

bool BoxStack::Split()
{
  std::size_t direction = 3;
  double widest = 0.0;
  for (std::size_t d = 0; d < N; ++d)
  {
    const double width = Boxes.back().width[d];
    if (width >= 2.0 * Smallest && width > widest)
    {
      widest = width;
      direction = d;
    }
  }
  if (direction == 3)
  {
    return false;
  }
  Box upper = Boxes.back();
  // The middle, on the grid.
  const double part = std::floor(widest / 2.0 / kGrid) * kGrid;
  upper.lower[direction] += part;
  upper.width[direction] = widest - part;
  const std::size_t top = Boxes.size() - 1;
  Coefficients.resize(std::max(Coefficients.size(), (Boxes.size() + 1) * M * Size));
  for (std::size_t k = 0; k < M; ++k)
  {
    const auto b = Slot(top, k);
    const auto above = Slot(top + 1, k);
    upper.error[k] =
      rounding::Above(upper.error[k] + RestrictionError(Degree[direction], LargestMagnitude(b)));
    std::ranges::copy(b, above.begin());
    Restrict(Degree, static_cast<int>(direction), 0.0, part / widest, b);
    Restrict(Degree, static_cast<int>(direction), part / widest, 1.0, above);
  }
  Boxes.back().error = upper.error;
  Boxes.back().width[direction] = part;
  Boxes.push_back(upper);
  return true;
}

bool BoxStack::PlaceRoot(const ParameterIntervals& image, double reach, IsolatedRoot& root) const
{
  const Box& box = Boxes.back();
  for (std::size_t d = 0; d < N; ++d)
  {
    const Interval lower(box.lower[d]);
    const Interval width(box.width[d]);
    root.enclosure[d] = lower + width * image[d];
    root.alone[d] = { (lower + width * Interval(-reach)).upper,
      (lower + width * (Interval(1.0) + Interval(reach))).lower };
    if (!root.alone[d].Contains(root.enclosure[d]))
    {
      return false;
    }
  }
  return true;
}
} // namespace pixelexact
