// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

#include <array>
#include <limits>

namespace pixelexact
{
/// A polynomial of total degree kGuessDegree about the inverse of an element's map, where Newton's
/// iteration begins: the least squares fit to the map's own values at points all over the shape.
/// Nothing that is said of a point rests on it.
struct InverseGuess
{
  /// See InverseProblem::guess.
  std::array<double, 3 * kGuessTerms> terms{};
  std::array<double, 3> centre{};
  std::array<double, 3> scale{};
  /// The largest at the points that it was fitted to, in xi; infinite where there is no guess.
  double error = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool IsKnown() const { return error < std::numeric_limits<double>::infinity(); }
};

/// `problem`: with its frame, not affine. Not known where the fit is no better than the frame
/// alone.
InverseGuess MakeInverseGuess(const InverseProblem& problem);
} // namespace pixelexact
