// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Appearance.h"
#include "Trace/Appearance/Resolve.h"
#include "Trace/Scene.h"
#include "Views/FieldChoice.h"
#include "Views/VtkCamera.h"

#include <limits>
#include <memory>
#include <optional>
#include <vector>

class vtkScalarsToColors;

namespace pixelexact
{
class HighOrderModel;

/// A cut-surface and how it is shown.
struct LayerRequest
{
  std::shared_ptr<const Surface> surface; ///< another object where it is another surface
  FieldChoice field;
  std::optional<int> component; ///< or kMagnitude; none: the table's choice
  Precision precision = Precision::Double;
  /// Of the surface's colours; null: they are the appearance's solid one.
  vtkScalarsToColors* table = nullptr;
  /// That of contours on a surface of one colour: their component and, where they have none,
  /// colours.
  vtkScalarsToColors* contourTable = nullptr;
  /// Its table and range group are filled in from these tables, and its material is left out of
  /// flat surfaces but for `litWhereFlat` (AppearanceOf).
  LayerAppearance appearance;
  bool litWhereFlat = false; ///< also a plane
};

/// The table that the layer is coloured by, or else its contours are; null: none.
[[nodiscard]] vtkScalarsToColors* TableOf(const LayerRequest& layer);

/// The layer's field. Null where the model has none and none is asked for, by name or to be mapped
/// to colours. Throws Error when there is no such field.
[[nodiscard]] const Field* FieldOf(const LayerRequest& layer, const HighOrderModel& model);

/// The component that the layer shows of its field: what it asks for, else the table's choice.
/// Throws Error when the field has no such component.
[[nodiscard]] int ComponentOf(const LayerRequest& layer, const Field& field);

/// What is to be seen. The objects are the caller's; all spaces are the data's, but for lights.
struct FrameRequest
{
  std::shared_ptr<HighOrderModel> model;
  std::vector<LayerRequest> layers;
  std::vector<KeptHalfSpace> kept; ///< clipping planes, and the near plane where it cuts the data
  CameraSetup camera;
  bool translucent = false; ///< all of it, for somebody who blends frames over what is there
  Appearance appearance;    ///< its layers are those of the requests (AppearanceOf)
  bool edgesByKind = false; ///< edges are told apart by what lies behind the face
  /// Of the model's fields, kept for as long as it stays the same; null: found for each frame.
  std::shared_ptr<FieldRanges> ranges;
  /// Beyond what drawing needs.
  Buffer buffers = Buffer::None;
  /// What tracing may take. Where the frame takes longer it is made coarse, and finer by each
  /// further call with the same scene.
  double seconds = std::numeric_limits<double>::infinity();
  bool refine = true; ///< whether a coarse frame of the same scene is made finer
  /// Above 1: of each stride x stride pixels the middle one is traced, and all show it. Throws
  /// Error with what is of each pixel: contours, edges.
  int stride = 1;
};

/// What of a layer rays depend on.
struct TracedLayer
{
  // Kept alive, so that no other surface can have its address.
  std::shared_ptr<const Surface> surface;
  FieldChoice field;
  int component = 0;
  Precision precision = Precision::Double;
  bool translucent = false;

  bool operator==(const TracedLayer&) const = default;
};

/// What a frame's rays depend on: where it stays the same, nothing is traced.
struct TraceKey
{
  std::vector<TracedLayer> layers;
  std::vector<KeptHalfSpace> kept;
  CameraSetup camera;
  int stride = 1;

  bool operator==(const TraceKey&) const = default;
};

/// Of a request with a model. Throws Error where that lacks a field or a component.
[[nodiscard]] TraceKey TraceKeyOf(const FrameRequest& request);

/// How the request's layers are shown, as those of `scene`, which is made of them.
[[nodiscard]] Appearance AppearanceOf(const FrameRequest& request, const Scene& scene);
} // namespace pixelexact
