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

// From the settings of a mapper, its actor and its layers to the layers of a view.
namespace pixelexact
{
class HighOrderModel;

/// A cut-surface and how it is drawn, by the settings of VTK's objects.
struct LayerRequest
{
  std::shared_ptr<const Surface> surface; ///< another object where it is another surface
  FieldChoice field;
  std::optional<int> component; ///< or kMagnitude; none: the table's choice
  Precision precision = Precision::Double;
  /// Colours the surface; null: it has the appearance's solid colour.
  vtkScalarsToColors* table = nullptr;
  /// Gives contours on a surface of one colour their component and, where they have none, colours.
  vtkScalarsToColors* contourTable = nullptr;
  LayerAppearance appearance; ///< its colour table and range group follow from these tables
  bool litWhereFlat = false;  ///< whether a flat surface has the appearance's material
};

/// The table that colours the layer, or else its contours; null: none.
[[nodiscard]] vtkScalarsToColors* TableOf(const LayerRequest& layer);

/// Adds the layer to a view of the model. Throws Error where the model lacks its field or the field
/// its component.
void AddLayer(const LayerRequest& layer, const HighOrderModel& model, View& view);

/// The settings of mapper and property for all surfaces; the surface itself is left open.
[[nodiscard]] LayerRequest LayerOf(vtkHighOrderMapper* mapper, vtkProperty* property);

/// A layer: what it does not say itself is as `ofAll`. Its surface is left open, too.
[[nodiscard]] LayerRequest LayerOf(vtkHighOrderLayer* layer, LayerRequest ofAll);

/// Whether a layer of the mapper hides all that is behind it; null: one without a look of its own.
[[nodiscard]] bool IsOpaque(vtkMapper* mapper, vtkHighOrderLayer* layer);
} // namespace pixelexact
