// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/ChebyshevModel.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// The part of the square (s, t) in [-1,1]^2 in which some functions are not positive, as strips
/// between limits that are functions of one of the variables. Places that are not classified, or by
/// less than rounding, have an area that the integrals' errors include.
class ClippedSquare
{
public:
  /// The whole square.
  ClippedSquare() = default;
  /// None where a function has a rim in the square and is proven monotone along neither variable,
  /// or where rims cross: subdivide the square.
  static std::optional<ClippedSquare> Of(std::span<const ChebyshevModel> functions);

  [[nodiscard]] bool IsEmpty() const { return !Whole && Strips.empty() && Unknown == 0.0; }
  /// About the fraction of the square that the part covers, 0 to 1.
  [[nodiscard]] double Part() const;
  /// The integral over the part.
  [[nodiscard]] Interval Integral(const ChebyshevModel& density) const;

private:
  using Powers = std::array<ChebyshevModel, ChebyshevModel::kDegree + 1>;
  /// A strip between two functions of s, with variables of its own in [-1,1]^2.
  struct Strip
  {
    Powers s; ///< Chebyshev's polynomials of the square's variables
    Powers t;
    ChebyshevModel area; ///< of the square by its own
  };
  class Search;
  friend class Search;
  static Powers PowersOf(const ChebyshevModel& argument);
  static ChebyshevModel Composed(const ChebyshevModel& f, const Powers& s, const Powers& t);

  bool Whole = true;
  bool Swapped = false; ///< strips are along t, and functions of it
  std::vector<Strip> Strips;
  double Unknown = 0.0; ///< an area that holds all places where it is not known
};
} // namespace pixelexact
