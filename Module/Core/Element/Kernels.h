// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

#include <array>

// The batch kernels: many points of one element, as many at a time as the instruction set has
// lanes. Chosen once per (batch, element) by space; each is compiled for every instruction set and
// dispatched at run time.
namespace pixelexact
{
/// Arrays handed to the kernels are padded to a multiple of this, with points that may be computed.
inline constexpr int kLanePadding = 8;

constexpr int PaddedCount(int count)
{
  return (count + kLanePadding - 1) / kLanePadding * kLanePadding;
}

/// `count` points, coordinate by coordinate; the arrays hold PaddedCount(count) doubles.
struct LanePoints
{
  const double* x[3];
  int count;
};

/// Total degree of the polynomial where Newton's iteration begins, and its number of terms.
inline constexpr int kGuessDegree = 4;
inline constexpr int kGuessTerms = (kGuessDegree + 1) * (kGuessDegree + 2) * (kGuessDegree + 3) / 6;

/// The inverse map's data of one element, in its own units: y = (x - centre) / size.
struct InverseProblem
{
  Space space;
  const double* coefficients; ///< of Phi, three components, in the element's units
  double centre[3];
  double inverseSize;
  double origin[3];      ///< frame: y at xi = start
  double start[3];       ///< frame: xi there
  double inverse[9];     ///< frame: row-major inverse Jacobian; 0: Newton begins at `start`
  double uncertainty[3]; ///< of Phi and y, per coordinate, in the element's units
  bool affine;           ///< Phi is its frame, up to the uncertainty
  /// Where Newton begins, if not null: a polynomial in s = (xi_0 - guessCentre) guessScale, xi_0
  /// the frame's preimage; kGuessTerms coefficients for each xi, of s_0^i s_1^j s_2^k with i, j, k
  /// falling, k fastest.
  const double* guess;
  double guessCentre[3];
  double guessScale[3];
  /// How much the map bends: after a Newton step errors are squared, times about this, in xi and
  /// max norm; of a pyramid, in the distance to its apex. It decides how many steps are made.
  double curvature;
  /// Bounds, for all coordinates c of Phi and two xi of the shape or next to it, the change of
  /// sum over j of |d Phi_c / d xi_j| from one to the other, over their distance in the max norm.
  /// Of a pyramid, times the distance to its apex, of one in tensor form twice. Infinite where
  /// nothing is known.
  double bend;
  /// Where Newton begins at each point, coordinate by coordinate, if not null; instead of all
  /// above.
  std::array<const double*, 3> from{};
};

/// The Jacobian of the last correction is that of a point no farther from the root than this, in
/// xi: after a step smaller than it the Jacobian is kept, for its corrections cost half of a full
/// step and gain as many digits as the step that it was made for had.
inline constexpr double kKeepJacobian = 3e-3;

/// A xi is accepted where Phi(xi) is the point up to this many times the uncertainty, per
/// coordinate; proven from the last correction, or evaluated.
inline constexpr double kMaxMiss = 4.0;

/// What Newton's iteration found for a point.
enum class NewtonStatus : std::uint8_t
{
  RootOutside = 0, ///< converged to a xi beyond the faces' tolerance
  RootInside = 1,  ///< a xi in the shape or within the faces' tolerance; kMaxMiss holds there
  NotConverged = 2
};

/// Nearer to a pyramid's apex than this, in xi3, its map is not continued beyond the faces as the
/// function that it is (CollapsedQuotient), and its Jacobian turns with the direction: the
/// iteration is not trusted there, and NotConverged.
inline constexpr double kApexRegion = 1e-7;

/// Arrays of PaddedCount(count).
struct InverseResult
{
  double* xi[3];
  double* status;          ///< NewtonStatus as a number
  double* margin;          ///< Margin(shape, xi); 0 of roots inside
  double* residual;        ///< the last Newton correction, max norm in xi
  double* steps = nullptr; ///< of the iteration, where wanted
};

struct KernelSet
{
  /// out[c][i] = sum of component c at point i. `coefficients` is component-major.
  void (*value)(const Space&, const double* coefficients, int components, const LanePoints& xi,
    double* const* out);
  /// The same in single precision, but for the way in and out: twice the lanes. Coefficients are
  /// scaled by a power of two per component, so that their size does not matter, and rounded as xi
  /// are. Errors are some roundoffs of a float (6e-8) of the sum of |coefficient| |mode|. Where a
  /// sum is not finite it is made in double precision after all.
  void (*valueInFloats)(const Space&, const double* coefficients, int components,
    const LanePoints& xi, double* const* out) = nullptr;
  /// Also gradient[3 c + d][i] = derivative of component c by xi_d.
  void (*gradient)(const Space&, const double* coefficients, int components, const LanePoints& xi,
    double* const* out, double* const* gradient);
  /// Newton's iteration for Phi(xi) = x from the frame's preimage of x. The result of a point
  /// depends on that point and the element alone, not on its neighbours in the batch.
  void (*invert)(const InverseProblem&, const LanePoints& x, const InverseResult& out);
};

/// The kernels of a valid space.
KernelSet KernelsFor(const Space& space);

/// The instruction set in use, for reports: "AVX3", "AVX2", "SSE2", ...
const char* InstructionSet();

KernelSet HexahedronKernels(const Space& space);
KernelSet PrismKernels(const Space& space);
KernelSet TetrahedronKernels(const Space& space);
KernelSet PyramidKernels(const Space& space);
KernelSet TensorPyramidKernels(const Space& space);
} // namespace pixelexact
