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
/// What a window shows of a shot, as an actor: layers in render's colours, and contours.
class ViewScene
{
public:
  /// Contours where the command line asks for none.
  static constexpr int kUsualContours = 10;

  /// The options must outlive this.
  explicit ViewScene(const RenderOptions& options);
  ~ViewScene();
  ViewScene(const ViewScene&) = delete;
  ViewScene& operator=(const ViewScene&) = delete;

  [[nodiscard]] vtkActor& Actor() const;
  [[nodiscard]] vtkHighOrderMapper& Mapper() const;

  /// Colours over the ranges of what the shot's view shows, as render's.
  void MakeTables(const Shot& shot);
  /// The shot's surfaces and fields, in these colours.
  void MakeLayers(const Shot& shot);
  /// Of values between the ends of the first range.
  void ShowContours(bool on);
  void MoveFirst(const std::shared_ptr<const Surface>& surface);

  /// By layer; none: it has one colour.
  [[nodiscard]] const std::vector<std::optional<std::array<double, 2>>>& Ranges() const
  {
    return TheRanges;
  }
  /// Of the first layer; null: it has one colour.
  [[nodiscard]] vtkLookupTable* FirstTable() const;

private:
  const RenderOptions& Options;
  std::vector<vtkSmartPointer<vtkLookupTable>> Tables; ///< by layer; null: one colour
  std::vector<std::optional<std::array<double, 2>>> TheRanges;
  std::vector<std::array<double, 3>> Solids;
  vtkNew<vtkHighOrderMapper> TheMapper;
  vtkNew<vtkActor> TheActor;
  vtkNew<GivenSurfaceOfLayer> First;
};
} // namespace pixelexact
