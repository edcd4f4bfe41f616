// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/SurfaceOptions.h"

#include "Core/Math/Vec.h"
#include "Trace/Camera.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pixelexact
{
class Surface;

/// The movement of a handle by a pointer, in world space.
struct HandleMove
{
  Vec3 by;      ///< in the plane through the handle that is perpendicular to `forward`
  Vec3 forward; ///< direction of view at the handle, unit length
  Vec3 up;      ///< upwards on the screen, unit length
};

/// A cut-surface that is moved by its handles.
class DraggedShape
{
public:
  DraggedShape() = default;
  virtual ~DraggedShape() = default;
  DraggedShape(const DraggedShape&) = delete;
  DraggedShape& operator=(const DraggedShape&) = delete;

  /// The points that a pointer grabs. Some lie at the shape's outline as the view shows it.
  [[nodiscard]] virtual std::vector<Vec3> Handles(const CameraView& view) const = 0;
  /// Line segments that show the shape and connect its handles.
  [[nodiscard]] virtual std::vector<std::array<Vec3, 2>> Lines(const CameraView& view) const = 0;
  /// Moves the handle with this index in Handles(view).
  virtual void Drag(std::size_t handle, const CameraView& view, const HandleMove& move) = 0;

  [[nodiscard]] virtual std::shared_ptr<const Surface> Now() const = 0;
  /// The same as a word of the command line, "--sphere=0,0,0,1".
  [[nodiscard]] virtual std::string Word() const = 0;
};

/// A plane, sphere, cylinder or box; null for other surfaces, which stay where they are. `surface`:
/// the first one of a shot; `given`: how the command line describes it; `box`: of the mesh.
std::unique_ptr<DraggedShape> MakeDragged(
  const Surface& surface, const SurfaceOptions::Described& given, const Box3& box);
} // namespace pixelexact
