// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Mat.h"
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeTree.h"
#include "Core/Questions/Sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

// Rays c + tau D through the points c(u) = a + u (b - a) of a chord, seen from a point of a sheet
// f = 0: with W about J^-1 and g about f' there, w = W D, q = w / (g . w), P = I - q g^T,
//
//   N(xi) = xi - P W (Phi(xi) - c) - q f(xi)
//
// has as fixed points those in which the ray meets the sheet: g . (xi - N) is f, because g P = 0;
// and what P takes to 0 is along w, so that Phi(xi) - c is along D. Neither W nor g has to be
// exact. q of a ray between two is a mean of theirs, as long as g . w has the same sign for both.
//
//   N' = -P (W J - I) - q (f' - g)
//
// is small near the point, by the node's bounds of W Phi'' and f''. Where N takes a box about a
// point of the path xi(u) to itself, the ray meets the sheet in it (Brouwer); by
// W (Phi(xi) - c) = tau w, the way there along the ray is tau = g . W (Phi(xi) - c) / (g . w).
namespace pixelexact
{
namespace edges
{
/// The distance, in xi, by which a path on a sheet may leave the element: far less than is visible,
/// and enough for the paths of two elements to overlap.
inline constexpr double kOverlap = 1e-10;
/// A ray is not known to cross the sheet where g . w is this much smaller than its terms. Otherwise
/// the error of q is at most kSteep.
inline constexpr double kGrazing = 1e-6;
inline constexpr double kSteep = 1e-8;

/// Three bounds, none of them negative.
struct Numbers
{
  double at[3]{};

  double& operator[](std::size_t k) { return at[k]; }
  double operator[](std::size_t k) const { return at[k]; }
  [[nodiscard]] double Largest() const { return std::max({ at[0], at[1], at[2] }); }
  [[nodiscard]] double Sum() const { return at[0] + at[1] + at[2]; }
};

inline Numbers Magnitudes(const Vec3& v)
{
  return { { std::fabs(v.x), std::fabs(v.y), std::fabs(v.z) } };
}
} // namespace edges

/// The element's end (EndsOf) that a face is.
[[nodiscard]] std::size_t EndOfFace(Shape shape, int face);

/// A sheet of an element.
class OnSheet
{
public:
  /// `ends`: of the element. They and the functions must outlive the object.
  OnSheet(
    const EdgeFunctions& functions, const std::array<EdgeNodeEnd, 6>& ends, const Sheet& sheet);

  struct Values
  {
    Vec3 y{ 0.0 }; ///< of the map, in the element's units
    Mat3 jacobian{ 0.0 };
    double f = 0.0; ///< 0 on the sheet
    Vec3 gradient{ 0.0 };
    double size = 0.0; ///< of the component
  };
  template <std::size_t N>
  [[nodiscard]] std::array<Values, N> At(const std::array<Vec3, N>& xi) const
  {
    std::array<Values, N> all;
    Evaluate(xi, all);
    return all;
  }

  /// The terms of N at a point, for all rays between two.
  struct Pencil
  {
    Mat3 inverse{ 0.0 };    ///< W
    edges::Numbers miss;    ///< row sums of |W J - I|
    edges::Numbers towards; ///< |q|
    double project[3][3]{};
    double across = std::numeric_limits<double>::infinity(); ///< |g . w|, the least
  };
  [[nodiscard]] std::optional<Pencil> PencilOf(
    const Values& at, const Vec3& first, const Vec3& last) const;

  /// Bounds the sagitta with the nodes of the tree.
  [[nodiscard]] double Sagitta(
    const EdgeTree& tree, const SheetPoint& a, const SheetPoint& b) const;
  [[nodiscard]] double Sagitta(const EdgeNode& node, const Pencil& pencil, const SheetPoint& a,
    const SheetPoint& b, const std::array<Values, 3>& at) const;
  [[nodiscard]] std::optional<SheetExit> ExitOf(
    const SheetPoint& from, const SheetPoint& towards) const;

private:
  void Evaluate(std::span<const Vec3> xi, std::span<Values> all) const;
  /// Bounds |f''| over a node, mixed ones twice. If f is a norm, the bound holds up to the distance
  /// `near` from the path's first point.
  struct Bent
  {
    double at[6]{};
  };
  [[nodiscard]] Bent BentOf(
    const EdgeNode& node, const Values& at, const edges::Numbers& near) const;
  [[nodiscard]] double SlopeErrorOf(const EdgeNode& node, const Values& at) const;
  [[nodiscard]] double ErrorOf(const Values& at) const;

  /// The boxes about the points of a path, each with half widths 4 u (1 - u) `middle` + `end`.
  struct Tube
  {
    edges::Numbers middle;
    edges::Numbers end;
    double rise = 0.0; ///< of g . W (Phi - c), from the path to the sheet
  };
  [[nodiscard]] std::optional<Tube> Contain(const EdgeNode& node, const Pencil& pencil,
    const Values& at, const edges::Numbers& length, const edges::Numbers& middle,
    const edges::Numbers& end) const;
  [[nodiscard]] bool IsInside(
    const EdgeNode& node, const Vec3& a, const Vec3& b, const Tube& tube) const;
  /// Bounds the second derivative by u of g . W Phi(xi(u)) - f(xi(u)).
  [[nodiscard]] double BendAlong(const EdgeNode& node, const Pencil& pencil, const Values& at,
    const Vec3& d, const Bent& f) const;
  [[nodiscard]] bool IsNorm() const { return sheet_.face < 0 && Of.Components() > 1; }

  const EdgeFunctions& Of;
  const std::array<EdgeNodeEnd, 6>& Ends;
  Sheet sheet_;
  std::size_t Own = 6; ///< the element's end that the face is
};
} // namespace pixelexact
