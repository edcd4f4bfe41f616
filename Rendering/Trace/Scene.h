// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Locator.h"
#include "Core/Location/Sample.h"
#include "Trace/Surfaces/Surface.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// Value of Layer::component: the Euclidean norm of all components. For a scalar field it is the
/// signed scalar, as in VTK.
inline constexpr int kMagnitude = -1;

/// The component, or kMagnitude, of a field's value.
[[nodiscard]] double ComponentOf(std::span<const double> values, int component);

/// A surface and the field that is traced on it. A change of its appearance (LayerAppearance) needs
/// no trace.
struct Layer
{
  std::shared_ptr<const Surface> surface;
  const Field* field = nullptr; ///< null: there are no values, and no buffers of them
  int component = 0;            ///< of the field, or kMagnitude
  /// Precision of the values; FrameCounters::floatCheck measures the error of Float. Float excludes
  /// enclosures.
  Precision precision = Precision::Double;
  bool translucent = false; ///< rays continue after its hits (SetTranslucency)

  bool operator==(const Layer&) const = default;
};

/// The points (x, y, z) with a x + b y + c z + d >= 0.
using KeptHalfSpace = std::array<double, 4>;

/// The traced objects. Locator and fields must outlive the scene.
struct Scene
{
  static constexpr std::size_t kMaxLayers = 255;

  const Locator* locator = nullptr;
  std::vector<Layer> layers;
  std::vector<KeptHalfSpace> kept; ///< rays ignore hits outside any of them

  bool operator==(const Scene&) const = default;
};

/// The scene's rays continue after the hits of some layer.
[[nodiscard]] bool HasTranslucent(const Scene& scene);

/// A layer's field depends on elements' neighbours (FieldFunction::NeedsNeighbours).
[[nodiscard]] bool HasJumps(const Scene& scene);
} // namespace pixelexact
