// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/FieldDifference.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
DifferenceNumbers NumbersOf(const FieldDifference& difference)
{
  const SampleBuffers& centres = difference.frame.centres;
  DifferenceNumbers numbers;
  numbers.bounded = !centres.valueLower.empty();
  std::int64_t finite = 0;
  double sum = 0.0;
  double squares = 0.0;
  double firstSquares = 0.0;
  for (std::size_t i = 0; i < difference.side.size(); ++i)
  {
    switch (static_cast<DifferenceSide>(difference.side[i]))
    {
      case DifferenceSide::Nothing:
        ++numbers.nothing;
        continue;
      case DifferenceSide::Unknown:
        ++numbers.unknown;
        continue;
      case DifferenceSide::First:
        ++numbers.onlyFirst;
        continue;
      case DifferenceSide::Second:
        ++numbers.onlySecond;
        continue;
      default:
        ++numbers.both;
    }
    const double size = std::fabs(centres.value[i]);
    if (!std::isfinite(size))
    {
      ++numbers.notFinite;
      continue;
    }
    ++finite;
    sum += size;
    squares += size * size;
    firstSquares += difference.first[i] * difference.first[i];
    if (numbers.largestPixel < 0 || size > numbers.largest)
    {
      numbers.largest = size;
      numbers.largestPixel = static_cast<std::int64_t>(i);
      numbers.largestAt = centres.position[i];
    }
    if (!numbers.bounded)
    {
      continue;
    }
    const Interval held(centres.valueLower[i], centres.valueUpper[i]);
    numbers.unbounded += held.IsFinite() ? 0 : 1;
    if (held.IsFinite())
    {
      numbers.largestBound = std::max(numbers.largestBound, held.RadiusAround(centres.value[i]));
    }
    const Interval absolute = Abs(held);
    numbers.largestTrue = { std::max(numbers.largestTrue.lower, absolute.lower),
      std::max(numbers.largestTrue.upper, absolute.upper) };
    numbers.provenApart += absolute.lower > 0.0 ? 1 : 0;
  }
  if (finite > 0)
  {
    const auto pixels = static_cast<double>(finite);
    numbers.mean = sum / pixels;
    numbers.rootMeanSquare = std::sqrt(squares / pixels);
    numbers.firstRootMeanSquare = std::sqrt(firstSquares / pixels);
  }
  return numbers;
}
} // namespace pixelexact
