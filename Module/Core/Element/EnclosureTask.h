// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"
#include "Core/Math/Interval.h"

#include <vector>

namespace pixelexact
{
/// What the lanes work on; see EnclosureKernels.cxx.
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

/// Encloses the field's values in the element's units: J and its inverse are those of Phi. Nothing
/// is known where they are not both finite. With arrays for them, of a field that is not mapped,
/// also of its derivatives by the element's coordinates, [3 c + d].
void EncloseInLanes(const EnclosureTask& task, const LanePoints& xi, const LanePoints& x,
  const BallArrays& values, const BallArrays& gradients = {});

/// An element and a field as the lanes take them, and the way back to the world. The arrays of both
/// must outlive it.
class EnclosureProblem
{
public:
  /// `uncertainty`: how far Phi may be from the stored map, world units.
  EnclosureProblem(const Mesh& mesh, const Field& field, int element, double uncertainty);
  EnclosureProblem(const EnclosureProblem&) = delete;
  EnclosureProblem& operator=(const EnclosureProblem&) = delete;

  /// Whether the element's size is one that the lanes' arithmetic takes: a power of two from 2^-900
  /// to 2^900. Else there is no task.
  [[nodiscard]] bool IsUsable() const { return Usable; }
  [[nodiscard]] const EnclosureTask& Task() const { return task_; }
  /// A value, or a derivative, that the lanes enclosed; everything where they knew nothing.
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
