// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <array>
#include <compare>
#include <cstdint>

// The canonical basis: orthogonal modal functions of generalised tensor-product form (Karniadakis
// and Sherwin 2005, section 3.2; paper, equation 9), unnormalised. P_n is Legendre's polynomial,
// P_n^a Jacobi's P_n^{(a,0)}, h_i = (1 - eta_i) / 2:
//
//   hexahedron              P_p(eta1) P_q(eta2) P_r(eta3)
//   prism                   P_p(eta1) P_q(eta2) h3^p P_r^{2p+1}(eta3),               p + r <= R
//   tetrahedron             P_p(eta1) h2^p P_q^{2p+1}(eta2) h3^{p+q} P_r^{2p+2q+2}(eta3),
//                                                                  p + q <= Q, p + q + r <= R
//   pyramid, Collapsed      P_p(eta1) P_q(eta2) h3^m P_r^{2m+2}(eta3), m = max(p,q), m + r <= R
//   pyramid, Tensor         P_p(eta1) P_q(eta2) P_r(eta3)
//
// A pyramid has two forms because solvers disagree on its space: Collapsed is that of Bergot,
// Cohen and Durufle (rational in xi, exact mode count); Tensor holds every polynomial in eta, hence
// every other space (VTK's quadratic pyramids among them).
// Coefficients lie p slowest, r fastest.
namespace pixelexact
{
enum class Form : std::uint8_t
{
  Collapsed = 0, ///< the only form of hexahedra, prisms and tetrahedra
  Tensor = 1     ///< pyramids only
};

/// Orders above this are refused.
inline constexpr int kMaxOrder = 32;

/// The polynomial space of one element.
struct Space
{
  Shape shape = Shape::Hexahedron;
  Form form = Form::Collapsed;
  std::array<std::uint8_t, 3> order{ 1, 1, 1 };

  auto operator<=>(const Space&) const = default;

  /// The largest of the three orders.
  [[nodiscard]] int MaxOrder() const;
  /// The number of modes, which is the number of coefficients of one component.
  [[nodiscard]] int Modes() const;
  /// The largest r of the modes (p, q, *); -1 where there are none.
  [[nodiscard]] int LastR(int p, int q) const;
  /// The largest q of the modes (p, *, *).
  [[nodiscard]] int LastQ(int p) const;
  /// The degree in each eta of the space's functions, seen as polynomials in eta.
  [[nodiscard]] std::array<int, 3> TensorDegree() const;
  /// Whether the space is one that the kernels evaluate: known shape and form, orders in range and
  /// nested as the collapsed shapes need them (prism p <= r; tetrahedron p <= q <= r; pyramid
  /// p, q <= r).
  [[nodiscard]] bool IsValid() const;
};

/// The space of equal orders in all directions, in the shape's collapsed form.
Space UniformSpace(Shape shape, int order);

/// Calls visit(p, q, r, mode) for every mode in the order of storage.
template <class Visit>
void ForEachMode(const Space& space, Visit&& visit)
{
  int mode = 0;
  for (int p = 0; p <= space.order[0]; ++p)
  {
    for (int q = 0; q <= space.LastQ(p); ++q)
    {
      for (int r = 0; r <= space.LastR(p, q); ++r)
      {
        visit(p, q, r, mode++);
      }
    }
  }
}
} // namespace pixelexact
