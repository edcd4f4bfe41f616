// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace pixelexact::mfem
{
/// The order in which MFEM's non-conforming meshes visit the eight children of a refined cube.
struct HilbertState
{
  std::array<int, 8> child; ///< the children, in the order of the visit
  std::array<int, 8> state; ///< the state in which each of them is entered
};

/// One of the 24 states of the curve, numbered as in the files' root_state.
const HilbertState& HilbertCurve(int state);

/// The same of the four children of a refined square; one of 8 states.
struct PlaneHilbertState
{
  std::array<int, 4> child;
  std::array<int, 4> state;
};
PlaneHilbertState PlaneHilbertCurve(int state);
} // namespace pixelexact::mfem
