// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"
#include "Core/Math/Interval.h"

#include <vector>

namespace pixelexact
{
/// The input of the lanes of EnclosureKernels.cxx.
struct EnclosureTask
{
  Space mapSpace;
  const double* mapCoefficients; ///< of Phi, in the element's units
  double centre[3];
  double inverseSize;
  double uncertainty; ///< of Phi - y, in the element's units
  Space space;
  const double* coefficients; ///< of the field
  int components;
  Mapping mapping;
};

/// Middles and radii, as arrays over the points.
struct BallArrays
{
  double* const* middle = nullptr;
  double* const* radius = nullptr;
};

/// Encloses the field's values in the element's units, for which J and its inverse are those of
/// Phi. Unproven points have a middle or a radius that is not finite. `gradients`, for a field that
/// is not mapped, receives the derivatives by the element's coordinates, [3 c + d].
void EncloseInLanes(const EnclosureTask& task, const LanePoints& xi, const LanePoints& x,
  const BallArrays& values, const BallArrays& gradients = {});

/// Converts an element and a field to the lanes' units, and results to world units. The arrays of
/// both must outlive it.
class EnclosureProblem
{
public:
  /// `uncertainty`: the largest distance between Phi and the stored map, world units.
  EnclosureProblem(const Mesh& mesh, const Field& field, int element, double uncertainty);
  EnclosureProblem(const EnclosureProblem&) = delete;
  EnclosureProblem& operator=(const EnclosureProblem&) = delete;

  /// Whether the lanes' arithmetic supports the element's size: a power of two from 2^-900 to
  /// 2^900. If not, there is no task.
  [[nodiscard]] bool IsUsable() const { return Usable; }
  [[nodiscard]] const EnclosureTask& Task() const { return task_; }
  /// Converts a value or a derivative that the lanes enclosed. Returns -inf to inf where they
  /// proved nothing.
  [[nodiscard]] Interval ToWorld(double middle, double radius, bool isDerivative = false) const;

private:
  EnclosureTask task_{};
  std::vector<double> Scaled; ///< the field's coefficients, where they are tiny
  double Factor = 1.0;        ///< the true coefficients are those in use times this
  double Size = 1.0;
  bool Usable = false;
  bool IsZero = false; ///< the field's coefficients are all zero
};
} // namespace pixelexact
