// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Bernstein/ChebyshevModel.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace pixelexact
{
/// Classifies a stretch of s by where the function is not positive, for all t of [-1, 1].
enum class RimKind : std::uint8_t
{
  AllIn,
  NothingIn,
  Crosses, ///< the rim crosses it once, from end to end of the stretch
  Undecided
};

/// A function at t = -1 and t = 1, over a stretch of s.
struct RimEnds
{
  BoxPolynomial low; ///< of the variable 0
  BoxPolynomial high;
};

/// The zeros t = rim(s) of a function of (s, t) in [-1,1]^2 that is monotone in t. Inside is where
/// the function is not positive.
class MonotoneRim
{
public:
  /// None where the function is not proven to be monotone.
  static std::optional<MonotoneRim> Of(const ChebyshevModel& function);

  /// Whether the inside is below the rim.
  [[nodiscard]] bool IsUpper() const { return Sign > 0.0; }
  /// The ends over all of [-1, 1].
  [[nodiscard]] RimEnds Ends() const;
  /// `strip` receives the width of the part of t in which the result may be wrong: a rim at an end,
  /// up to rounding, counts as being at the end.
  [[nodiscard]] RimKind KindOf(const RimEnds& ends, double& strip) const;

  /// Composes a function f(s, t) with s = the stretch's variable in [-1, 1] and t as a model.
  using Composition =
    std::function<ChebyshevModel(const ChebyshevModel& f, const ChebyshevModel& t)>;
  /// The rim over a stretch that it crosses, as a model of the stretch's variable; none where it is
  /// not found.
  [[nodiscard]] std::optional<ChebyshevModel> Between(
    double from, double to, const Composition& compose) const;

private:
  MonotoneRim() = default;
  [[nodiscard]] double RootAt(double s) const;

  ChebyshevModel Function;
  ChebyshevModel Slope;   ///< by t
  double Sign = 1.0;      ///< of the slope
  double Steepness = 0.0; ///< the slope's magnitude is larger, also a little beyond the square
  double Tolerance = 0.0; ///< smaller values at the ends are zero
};
} // namespace pixelexact
