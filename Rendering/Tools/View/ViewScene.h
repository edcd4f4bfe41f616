// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Image.h"
#include "Picture/RenderOptions.h"
#include "Scene/ShotAppearance.h"
#include "View/GivenSurface.h"

#include <vtkNew.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkActor;
class vtkHighOrderMapper;

namespace pixelexact
{
/// Actors that show a shot as render draws it, and its legend.
class ViewScene
{
public:
  ViewScene();
  ~ViewScene();
  ViewScene(const ViewScene&) = delete;
  ViewScene& operator=(const ViewScene&) = delete;

  [[nodiscard]] vtkActor& Actor() const { return *Drawn; }
  /// The edges of the mesh's box (--mesh-outline).
  [[nodiscard]] vtkActor& Outline() const { return *Box; }
  [[nodiscard]] vtkHighOrderMapper& Mapper() const { return *DrawnBy; }

  /// Takes over the shot's surfaces, fields and appearance. Ranges of colours that are not given
  /// are those of the picture; they stay when the surface or the camera moves. The options must
  /// outlive the next call. Throws Error as Resolve.
  void Show(const RenderOptions& options, const Shot& shot);
  void MoveFirst(const std::shared_ptr<const Surface>& surface);

  /// By layer; none: it has one colour.
  [[nodiscard]] const std::vector<ValueRange>& Ranges() const { return Colors->Ranges(); }
  /// The figure without its picture, on an opaque background.
  [[nodiscard]] Image Figure(const RenderOptions& options, const Shot& shot) const;

private:
  void FindRanges(const RenderOptions& options, const Shot& shot);
  void ShowOutline(const RenderOptions& options, const Shot& shot);

  std::optional<Shot> Traced; ///< that the colours refer to
  std::unique_ptr<ShotAppearance> Colors;
  vtkNew<vtkHighOrderMapper> DrawnBy;
  vtkNew<vtkActor> Drawn;
  vtkNew<vtkActor> Box;
  vtkNew<GivenSurfaceOfLayer> First;
};
} // namespace pixelexact
