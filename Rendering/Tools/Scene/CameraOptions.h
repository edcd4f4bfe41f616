// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Core/Math/Vec.h"
#include "Trace/Camera.h"

#include <optional>
#include <vector>

namespace pixelexact
{
/// The camera of the command line. What is not given is chosen so that all that is cut is seen from
/// --view, else along the first surface's normal, or, where that is no plane, from the
/// direction (1, 1, 1).
class CameraOptions
{
public:
  void AddTo(CLI::App& command);

  /// Throws UsageError when the options contradict each other.
  [[nodiscard]] CameraView Make(
    const Box3& bounds, const Vec3& surfaceNormal, const ImageSize& size) const;
  /// Whether the camera's position was given.
  [[nodiscard]] bool IsPlaced() const { return !Position.empty(); }
  /// Whether a parallel view's scale was given.
  [[nodiscard]] bool HasScale() const { return ParallelScale.has_value(); }
  /// The part of Make's checks that needs no data, for failing before the file is read.
  void Check() const;

private:
  std::optional<Vec3> From; ///< the viewer's direction
  std::vector<double> Position;
  std::vector<double> FocalPoint;
  std::vector<double> ViewUp;
  std::optional<double> ViewAngle;
  std::optional<double> ParallelScale;
};
} // namespace pixelexact
