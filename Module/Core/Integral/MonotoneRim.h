// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Integral/ChebyshevModel.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace pixelexact
{
/// What of a stretch of s is in, for all t of [-1, 1].
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

/// Where a function of (s, t) in [-1,1]^2 that is monotone in t is zero: t = rim(s). In is where it
/// is not positive.
class MonotoneRim
{
public:
  /// Nothing where it is not proven to be monotone.
  static std::optional<MonotoneRim> Of(const ChebyshevModel& function);

  /// Whether in is below the rim.
  [[nodiscard]] bool IsUpper() const { return Sign > 0.0; }
  /// Over all of [-1, 1].
  [[nodiscard]] RimEnds Ends() const;
  /// `strip` receives how wide a part of t may be that the answer is wrong in: rims that are at an
  /// end up to rounding count as being there.
  [[nodiscard]] RimKind KindOf(const RimEnds& ends, double& strip) const;

  /// A function f(s, t) of s = the stretch's variable in [-1, 1], and of t as a model.
  using Composition =
    std::function<ChebyshevModel(const ChebyshevModel& f, const ChebyshevModel& t)>;
  /// The rim over a stretch that it crosses, as a model of the stretch's variable; nothing where it
  /// is not found.
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
