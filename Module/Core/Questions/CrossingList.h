// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/Questions.h"

namespace pixelexact
{
/// Crossings found in the nodes of an element's tree, each listed once: neighbouring nodes may find
/// the same one at their common end.
class CrossingList
{
public:
  /// Lists a crossing that is the only one in `alone`, a box of eta around its own. It is one that
  /// is listed if either lies where the other is alone, another one if the two lie apart. Where
  /// neither is proven, what covers both becomes undecided.
  void Add(const Crossing& crossing, const std::array<Interval, 3>& alone);
  void AddUndecided(const Interval& t, const EtaBox& box);

  /// In ascending order.
  Crossings Take();

private:
  struct Entry
  {
    Crossing crossing;
    std::array<Interval, 3> alone;
  };
  std::vector<Entry> Found;
  std::vector<UndecidedCrossing> Undecided;
};
} // namespace pixelexact
