// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "View/DraggedShape.h"

#include <vtkNew.h>

#include <array>
#include <memory>
#include <optional>

class vtkActor;
class vtkCamera;
class vtkPolyData;
class vtkRenderer;

namespace pixelexact
{
/// The handles of a shape over a picture: balls and lines of constant width in pixels, which no
/// surface hides. A pointer grabs a ball only, so that a drag elsewhere is the camera's.
class ShapeHandles
{
public:
  /// `shape` null: there are no handles.
  explicit ShapeHandles(std::unique_ptr<DraggedShape> shape);
  ~ShapeHandles();
  ShapeHandles(const ShapeHandles&) = delete;
  ShapeHandles& operator=(const ShapeHandles&) = delete;

  /// The renderer of the handles, in a layer above that of the picture.
  [[nodiscard]] vtkRenderer& Renderer() const { return *Over; }
  /// Null: the surface stays where it is.
  [[nodiscard]] const DraggedShape* Shape() const { return Moved.get(); }

  void TurnVisible();
  /// Draws the handles as the picture's camera shows them.
  void Update(vtkCamera& picture);

  /// Marks the handle at a position of the window, in pixels from below. Returns whether that
  /// changes the picture.
  bool PointAt(const std::array<int, 2>& at);
  /// Grabs the handle at the position. Returns whether there is one.
  bool Grab(const std::array<int, 2>& at);
  [[nodiscard]] bool IsGrabbed() const { return Grabbed.has_value(); }
  /// Moves the grabbed handle under the pointer.
  void DragTo(const std::array<int, 2>& at);
  void Release() { Grabbed.reset(); }

private:
  [[nodiscard]] std::optional<std::size_t> HandleAt(const std::array<int, 2>& at) const;

  std::unique_ptr<DraggedShape> Moved;
  CameraView View; ///< of the picture
  std::optional<std::size_t> Grabbed;
  std::optional<std::size_t> Marked; ///< under the pointer
  std::array<int, 2> Last{};         ///< position of the pointer
  vtkNew<vtkRenderer> Over;
  vtkNew<vtkPolyData> Balls;
  vtkNew<vtkPolyData> Segments;
  vtkNew<vtkActor> BallActor;
  vtkNew<vtkActor> SegmentActor;
};
} // namespace pixelexact
