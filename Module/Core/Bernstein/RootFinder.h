// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/PolynomialSystem.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// A part of the unit cube; its ends are dyadic numbers, exactly.
struct ParameterBox
{
  Parameters lower{ 0.0, 0.0, 0.0 };
  Parameters upper{ 1.0, 1.0, 1.0 };
};

/// A root of a system of as many equations as variables.
struct IsolatedRoot
{
  /// Holds exactly one root of every system within the coefficients' errors. It may reach out of
  /// the unit cube by its own width, and so may the root.
  ParameterIntervals enclosure;
  /// A larger box around it in which there is no other root.
  ParameterIntervals alone;
};

struct RootSearch
{
  int budget = 20000;        ///< boxes looked at
  double smallest = 0x1p-40; ///< boxes are not split below this width; at least 2^-40
  bool keepEmpty = false;    ///< whether the boxes proven empty are listed
};

struct RootSearchResult
{
  std::vector<IsolatedRoot> roots;
  /// Boxes that may hold roots that are not listed: multiple roots, roots closer to each other than
  /// the coefficients' errors allow to tell apart, whatever the budget left. Touching boxes are
  /// joined. For systems of fewer equations than variables, whose solutions are no points, and of
  /// more, these boxes are the answer: all solutions lie in them.
  std::vector<ParameterBox> undecided;
  std::vector<ParameterBox> empty; ///< on request: proven to hold no root but listed ones
  std::int64_t boxes = 0;          ///< looked at
  bool budgetSpent = false;

  /// Whether `roots` are all roots in the unit cube, proven.
  [[nodiscard]] bool IsComplete() const { return undecided.empty(); }
};

/// All roots of a polynomial system in the unit cube, or the boxes where that could not be decided.
/// Never loses a root, never invents one: see Module/Documentation/element-tree.md for the method
/// and its proofs.
RootSearchResult FindRoots(const PolynomialSystem& system, const RootSearch& search = {});
} // namespace pixelexact
