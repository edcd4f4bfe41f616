// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Picture/RenderOptions.h"
#include "View/GivenSurface.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkActor;
class vtkHighOrderMapper;
class vtkLookupTable;

namespace pixelexact
{
/// An actor that shows a shot as render draws it.
class ViewScene
{
public:
  /// Number of contours where the command line gives none.
  static constexpr int kDefaultContours = 10;

  /// The options must outlive this.
  explicit ViewScene(const RenderOptions& options);
  ~ViewScene();
  ViewScene(const ViewScene&) = delete;
  ViewScene& operator=(const ViewScene&) = delete;

  [[nodiscard]] vtkActor& Actor() const;
  [[nodiscard]] vtkHighOrderMapper& Mapper() const;

  /// The ranges of colours that follow from the picture of the shot: they stay when the surface or
  /// the camera moves.
  void FindRanges(const Shot& shot);
  /// Takes over the shot's surfaces, fields and appearance, with or without contours and edges.
  void Show(const Shot& shot, bool contours, bool edges);
  void MoveFirst(const std::shared_ptr<const Surface>& surface);

  /// By layer; none: it has one colour.
  [[nodiscard]] const std::vector<std::optional<std::array<double, 2>>>& Ranges() const
  {
    return FoundRanges;
  }
  /// The table of the first layer, for a colour bar; null: the layer has one colour.
  [[nodiscard]] vtkSmartPointer<vtkLookupTable> FirstTable(const Shot& shot) const;

private:
  const RenderOptions& Options;
  std::vector<std::optional<std::array<double, 2>>> FoundRanges;
  vtkNew<vtkHighOrderMapper> DrawnBy;
  vtkNew<vtkActor> Drawn;
  vtkNew<GivenSurfaceOfLayer> First;
};
} // namespace pixelexact
