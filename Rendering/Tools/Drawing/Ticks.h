// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace pixelexact
{
/// A place on a scale, and what is written there.
struct Tick
{
  double value;
  std::string text;
};

/// Round values (1, 2 or 5 times a power of ten apart) within a range, at most `most`, but where
/// the range holds no two such values its ends. `logarithm`: powers of ten, and their multiples by
/// 2 and 5 where there is room, or as without where the range holds less than a decade. `range`
/// ascends.
std::vector<Tick> TicksWithin(const std::array<double, 2>& range, bool logarithm, int most);

/// The ends of bands that are equally wide (with `logarithm` in powers), or every second, third,
/// ... of them, so that there are at most `most`; in as few digits, from 3, as tell them apart.
std::vector<Tick> TicksOfBands(
  const std::array<double, 2>& range, bool logarithm, int bands, int most);
} // namespace pixelexact
