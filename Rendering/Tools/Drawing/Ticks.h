// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace pixelexact
{
/// A place on a scale, and its text, whose minus signs are those of print (U+2212).
struct Tick
{
  double value;
  std::string text;
};

/// A number as text with minus signs of print, and without zeros before an exponent.
std::string WithMinus(const std::string& number);

/// The place of a value in a range, 0 to 1, and its inverse. `logarithm`: of a range above 0.
double PartOfRange(const std::array<double, 2>& range, bool logarithm, double value);
double ValueInRange(const std::array<double, 2>& range, bool logarithm, double part);

/// Round values (1, 2 or 5 times a power of ten apart) within a range, at most `most`; where the
/// range contains fewer than two such values, its ends. `logarithm`: powers of ten, and their
/// multiples by 2 and 5 where there is room; for less than a decade as without. `range` must
/// ascend.
std::vector<Tick> TicksWithin(const std::array<double, 2>& range, bool logarithm, int most);

/// Round values within a range, at most `most`, or the two or three of the coarsest step that has
/// two; for ranges whose ends are no values of the data. `range` must ascend.
std::vector<Tick> RoundTicks(const std::array<double, 2>& range, int most);

/// The ticks of a colour bar: those of TicksWithin that have room beside the ends of the range, and
/// the ends, to a thousandth of the range.
std::vector<Tick> TicksOfBar(const std::array<double, 2>& range, bool logarithm, int most);

/// Given values, each in the fewest digits, at least 4, that distinguish them.
std::vector<Tick> TicksAt(const std::vector<double>& values);

/// The ends of bands of equal width (with `logarithm` in powers), or every second, third, ... of
/// them, so that there are at most `most`, and the last one, in the fewest digits, at least 3, that
/// distinguish them.
std::vector<Tick> TicksOfBands(
  const std::array<double, 2>& range, bool logarithm, int bands, int most);
} // namespace pixelexact
