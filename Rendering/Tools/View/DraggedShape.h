// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/SurfaceOptions.h"

#include <memory>
#include <string>

class vtkAbstractWidget;

namespace pixelexact
{
class Surface;

/// A cut-surface that is dragged in a window, by a widget of VTK's.
class DraggedShape
{
public:
  DraggedShape() = default;
  virtual ~DraggedShape() = default;
  DraggedShape(const DraggedShape&) = delete;
  DraggedShape& operator=(const DraggedShape&) = delete;

  /// Puts the widget where the surface is, in a mesh's box as of vtkDataSet::GetBounds.
  virtual void Place(const double* bounds) = 0;
  [[nodiscard]] virtual vtkAbstractWidget& Widget() = 0;
  /// The surface at the widget's position. Throws Error where there is none, as with a radius of 0.
  [[nodiscard]] virtual std::shared_ptr<const Surface> Now() const = 0;
  /// The same as a word of the command line, "--sphere=0,0,0,1".
  [[nodiscard]] virtual std::string Word() const = 0;
};

/// A plane, sphere, cylinder or box; null for other surfaces, which stay where they are. `surface`:
/// the first one of a shot; `given`: how the command line describes it.
std::unique_ptr<DraggedShape> MakeDragged(
  const Surface& surface, const SurfaceOptions::Described& given);
} // namespace pixelexact
