// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/PixelDistance.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{

/// Of every place p the least of (p - q)^2 + values[q]: parabolas' lower envelope. `stride` apart.
class Envelope
{
public:
  explicit Envelope(std::size_t most)
    : Roots(most)
    , Begins(most + 1)
    , Line(most)
  {
  }

  void Apply(double* values, std::size_t count, std::size_t stride)
  {
    for (std::size_t q = 0; q < count; ++q)
    {
      Line[q] = values[q * stride];
    }
    std::size_t used = 0;
    for (std::size_t q = 0; q < count; ++q)
    {
      if (Line[q] < kInfinity)
      {
        Add(q, used);
      }
    }
    std::size_t k = 0;
    for (std::size_t p = 0; p < count; ++p)
    {
      while (k + 1 < used && Begins[k + 1] < static_cast<double>(p))
      {
        ++k;
      }
      const double away =
        used > 0 ? static_cast<double>(p) - static_cast<double>(Roots[k]) : kInfinity;
      values[p * stride] = used > 0 ? away * away + Line[Roots[k]] : kInfinity;
    }
  }

private:
  void Add(std::size_t q, std::size_t& used)
  {
    const auto height = [this](std::size_t root)
    { return Line[root] + static_cast<double>(root) * static_cast<double>(root); };
    double begin = -kInfinity;
    while (used > 0)
    {
      const std::size_t last = Roots[used - 1];
      begin = (height(q) - height(last)) / (2.0 * static_cast<double>(q - last));
      if (begin > Begins[used - 1])
      {
        break;
      }
      --used;
    }
    Begins[used] = used == 0 ? -kInfinity : begin;
    Roots[used] = q;
    ++used;
  }

  std::vector<std::size_t> Roots; ///< where parabolas stand
  std::vector<double> Begins;     ///< from where on each is the lowest
  std::vector<double> Line;
};
} // namespace

std::vector<double> DistanceToMarked(
  std::span<const std::uint8_t> pixels, std::uint8_t mark, int width, int height)
{
  const auto across = static_cast<std::size_t>(width);
  const auto up = static_cast<std::size_t>(height);
  std::vector<double> squares(pixels.size());
  std::ranges::transform(pixels, squares.begin(),
    [mark](std::uint8_t pixel) { return pixel == mark ? 0.0 : kInfinity; });
  Envelope envelope(std::max(across, up));
  for (std::size_t row = 0; row < up; ++row)
  {
    envelope.Apply(&squares[row * across], across, 1);
  }
  for (std::size_t column = 0; column < across; ++column)
  {
    envelope.Apply(&squares[column], up, across);
  }
  std::ranges::transform(squares, squares.begin(), [](double square) { return std::sqrt(square); });
  return squares;
}
} // namespace pixelexact
