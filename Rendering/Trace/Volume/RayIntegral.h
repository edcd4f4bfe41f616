// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Volume/RaySpans.h"
#include "Trace/Volume/TransferFunction.h"

#include <array>
#include <span>

namespace pixelexact
{
/// The largest error of a proven pixel's colour, of full scale: half a level of a byte, nearly.
inline constexpr double kVolumeTolerance = 1.0 / 512.0;

/// Emission and absorption along a ray, front to back:
///
///   C = integral of c(u(t)) tau(u(t)) T(t) dt,  T(t) = exp(-integral of tau(u) up to t).
///
/// Errors. If tau and c are replaced by tau' and c', each channel of C and the opacity 1 - T change
/// by at most the integral of T |tau - tau'| + T tau |c - c'|: C is the mean colour at the first
/// event of a Poisson process with rate tau, and both processes can be coupled so that they differ
/// with at most that probability. A step of length w in which u is in one part of the transfer
/// function takes Simpson's rule for the optical depth D (error at most w^3 / 81 max |tau''|), a
/// constant tau and a colour linear in t. By parts, a constant tau with the same D changes C by at
/// most T times max |tau'| w^2 / 8 times the change of c. Steps across places of the transfer
/// function have errors of first order, and are shortened.
class RayIntegral
{
public:
  /// `magnitude`: u is the Euclidean norm of the span's components; else there is one component. At
  /// most 9 components. The transfer function must outlive this object.
  RayIntegral(const TransferFunction& transfer, int components, bool magnitude)
    : transfer_(transfer)
    , components_(static_cast<std::size_t>(components))
    , magnitude_(magnitude)
  {
  }

  /// Starts a ray along which spans have this total length.
  void Begin(double length);
  /// Adds the part [from, to] of a span; parts follow each other by t. Returns false where nothing
  /// behind it is visible any more.
  bool Add(const RaySpan& span, const double* series, double from, double to);
  /// Adds the error of an end of a span at t that may be off by `length` to either side.
  void AddUncertainEnd(const RaySpan& span, const double* series, double t, double length);
  /// A thin layer of straight colour and opacity, exact.
  void AddLayer(const std::array<double, 3>& rgb, double alpha);

  /// Premultiplied colour, opacity, and bound of the error of each.
  [[nodiscard]] const std::array<double, 3>& Color() const { return color_; }
  [[nodiscard]] double Opacity() const { return 1.0 - through_; }
  [[nodiscard]] double Error() const { return error_; }
  [[nodiscard]] bool IsDark() const { return through_ < 1.0 / 4096.0; }

private:
  /// u at one place of a span, with its components.
  struct Place
  {
    double u;
    std::array<double, 9> v;
  };
  struct Step;

  /// Prepares for the places of a span.
  void BeginSpan(const RaySpan& span, const double* series);
  [[nodiscard]] Place PlaceAt(const RaySpan& span, const double* series, double x) const;
  [[nodiscard]] Step StepTo(
    const RaySpan& span, const Place& a, const Place& m, const Place& b, double width) const;
  void Take(const Step& step);

  const TransferFunction& transfer_;
  std::size_t components_;
  bool magnitude_;
  std::array<double, 3> color_{};
  double through_ = 1.0;
  double error_ = 0.0;
  double rate_ = 0.0;              ///< of the error that steps may add, per length
  double shortest_ = 0.0;          ///< steps are not shorter
  const double* begun_ = nullptr;  ///< the series of the span for which the bounds below hold
  std::array<double, 9> slopes_{}; ///< of its components by t, anywhere in the span
  std::array<double, 9> bends_{};  ///< their second derivatives
};
} // namespace pixelexact
