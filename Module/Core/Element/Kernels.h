// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

#include <array>

// The batch kernels evaluate many points of one element, as many at a time as the instruction set
// has lanes. They are chosen once per (batch, element) by space; each is compiled for every
// instruction set and dispatched at run time.
namespace pixelexact
{
/// Arrays for the kernels are padded to a multiple of this number, with points that the kernels may
/// evaluate.
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

/// Total degree of the polynomial that gives Newton's starting points, and its number of terms.
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
  /// The polynomial that gives Newton's starting points, if not null: in s = (xi_0 - guessCentre)
  /// guessScale, xi_0 the frame's preimage; kGuessTerms coefficients for each xi, of s_0^i s_1^j
  /// s_2^k with i, j, k falling, k fastest.
  const double* guess;
  double guessCentre[3];
  double guessScale[3];
  /// Estimates the map's curvature: a Newton step squares the error and multiplies it by about this
  /// number, in xi and max norm; for a pyramid, in units of the distance to its apex. It determines
  /// the number of steps.
  double curvature;
  /// Bounds, for all coordinates c of Phi and two xi of the shape or next to it, the change of sum
  /// over j of |d Phi_c / d xi_j| from one to the other, over their distance in the max norm. For a
  /// pyramid this number is multiplied by the distance to its apex, in tensor form by the square of
  /// that distance. Infinite where no bound is known.
  double bend;
  /// Newton's starting points, coordinate by coordinate, if not null; they replace all of the
  /// above.
  std::array<const double*, 3> from{};
};

/// The largest distance from the root, in xi, at which a Jacobian is reused. After a step smaller
/// than this the Jacobian is kept: a correction with it costs half of a full step and gains as many
/// digits as the step for which it was computed.
inline constexpr double kKeepJacobian = 3e-3;

/// A xi is accepted where Phi(xi) is the point up to this many times the uncertainty, per
/// coordinate. The last correction proves it, or Phi is evaluated.
inline constexpr double kMaxMiss = 4.0;

/// The result of Newton's iteration for a point.
enum class NewtonStatus : std::uint8_t
{
  RootOutside = 0, ///< converged to a xi beyond the faces' tolerance
  RootInside = 1,  ///< a xi in the shape or within the faces' tolerance; kMaxMiss holds there
  NotConverged = 2
};

/// Points this close, in xi3, to a pyramid's apex are NotConverged: beyond the faces the map there
/// does not continue the function inside (CollapsedQuotient), and its Jacobian varies with the
/// direction.
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
  /// out[c][i] is the sum of component c at point i. `coefficients` is component-major.
  void (*value)(const Space&, const double* coefficients, int components, const LanePoints& xi,
    double* const* out);
  /// The same in single precision with input and output in doubles: twice the lanes. Coefficients
  /// are scaled by a power of two per component, so that their size does not matter, and rounded,
  /// as xi are. Errors are some roundoffs of a float (6e-8) of the sum of |coefficient| |mode|. A
  /// sum that is not finite is recomputed in double precision.
  void (*valueInFloats)(const Space&, const double* coefficients, int components,
    const LanePoints& xi, double* const* out) = nullptr;
  /// The same, and gradient[3 c + d][i] is the derivative of component c by xi_d.
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
