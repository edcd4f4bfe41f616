// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/View.h"
#include "Views/FieldChoice.h"

#include <memory>
#include <optional>

class vtkHighOrderLayer;
class vtkHighOrderMapper;
class vtkMapper;
class vtkProperty;
class vtkScalarsToColors;

// Converts the settings of a mapper, its actor and its layers to the layers of a view.
namespace pixelexact
{
class HighOrderModel;

/// A cut-surface and its appearance, from the settings of VTK's objects.
struct LayerRequest
{
  std::shared_ptr<const Surface> surface; ///< a different object for a different surface
  FieldChoice field;
  std::optional<int> component; ///< or kMagnitude; none: the table's component
  Precision precision = Precision::Double;
  /// Colours the surface; null: the surface has the appearance's solid colour.
  vtkScalarsToColors* table = nullptr;
  /// Determines the component of contours on a surface of one colour and, if they have none, their
  /// colours.
  vtkScalarsToColors* contourTable = nullptr;
  LayerAppearance appearance; ///< AddLayer sets its colour table and range group from these tables
  bool litWhereFlat = false;  ///< a flat surface is lit with the appearance's material
};

/// The table that colours the layer, or else its contours; null: none.
[[nodiscard]] vtkScalarsToColors* TableOf(const LayerRequest& layer);

/// Adds the layer to a view of the model. Throws Error if the model lacks the field, or the field
/// lacks the component.
void AddLayer(const LayerRequest& layer, const HighOrderModel& model, View& view);

/// The settings of mapper and property for all surfaces, without a surface.
[[nodiscard]] LayerRequest LayerOf(vtkHighOrderMapper* mapper, vtkProperty* property);

/// A layer's settings, without its surface. Settings that the layer does not have come from
/// `ofAll`.
[[nodiscard]] LayerRequest LayerOf(vtkHighOrderLayer* layer, LayerRequest ofAll);

/// A layer of the mapper hides everything behind it. `layer` null: a surface without settings of
/// its own.
[[nodiscard]] bool IsOpaque(vtkMapper* mapper, vtkHighOrderLayer* layer);
} // namespace pixelexact
