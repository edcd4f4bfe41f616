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
/// Layer::component: the Euclidean norm of all components, which for a scalar field is the scalar
/// itself, sign and all, as in VTK.
inline constexpr int kMagnitude = -1;

/// That of a field's value.
[[nodiscard]] double ComponentOf(std::span<const double> values, int component);

/// A surface and what is traced on it. How it is shown is told to the Painter (LayerAppearance):
/// other looks trace nothing.
struct Layer
{
  std::shared_ptr<const Surface> surface;
  const Field* field = nullptr; ///< null: there are no values, and no buffers of them
  int component = 0;            ///< of the field, or kMagnitude
  /// Of the values; see FrameCounters::floatCheck for what Float costs. Not with enclosures.
  Precision precision = Precision::Double;
  bool translucent = false; ///< rays go on behind it (SetTranslucency)

  bool operator==(const Layer&) const = default;
};

/// The points (x, y, z) with a x + b y + c z + d >= 0.
using KeptHalfSpace = std::array<double, 4>;

/// What is rendered. Locator and fields must outlive the scene.
struct Scene
{
  static constexpr std::size_t kMaxLayers = 255;

  const Locator* locator = nullptr;
  std::vector<Layer> layers;
  std::vector<KeptHalfSpace> kept; ///< rays go on through what lies outside of any of them

  bool operator==(const Scene&) const = default;
};

/// Whether rays of the scene go on behind the hits of some layer.
[[nodiscard]] bool HasTranslucent(const Scene& scene);

/// Whether a layer's field depends on elements' neighbours (FieldFunction::NeedsNeighbours).
[[nodiscard]] bool HasJumps(const Scene& scene);
} // namespace pixelexact
