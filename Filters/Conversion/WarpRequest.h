// SPDX-License-Identifier: BSD-3-Clause
#ifndef WarpRequest_h
#define WarpRequest_h

#include "Core/Math/Vec.h"

#include <optional>
#include <string>

namespace pixelexact
{
/// How a mesh is deformed: x + scale * u.
struct WarpRequest
{
  /// u: a vector field, vec(a,b,c) of scalar fields or of 0, in the plane vec(a,b), or with a
  /// direction a scalar field.
  std::string field;
  double scale = 1.0;
  std::optional<Vec3> direction; ///< of a scalar's displacement; not normalised
};
} // namespace pixelexact
#endif
