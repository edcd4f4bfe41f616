// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Block.h"

#include "Trace/Modules/ColorMapping.h"
#include "Trace/Surfaces/Quadric.h"

#include <algorithm>
#include <cmath>

// A scene of two layers, opaque or translucent, and colours for it.
namespace pixelexact::testing
{
/// A tilted plane through a sphere.
class LayeredScene
{
public:
  explicit LayeredScene(bool translucent)
  {
    block.MakeCurved();
    scene_.locator = block.scene_.locator;
    const auto sphere = std::make_shared<Quadric>(MakeSphere({ 0.2, 0.0, 0.1 }, 0.8));
    const auto plane = std::make_shared<Plane>(Vec3(0.1), Vec3(0.3, 0.4, 1.0));
    scene_.layers = { { sphere, &block.field_, 0, Precision::Double, translucent },
      { plane, &field, 0, Precision::Double, translucent } };
  }

  Block block;
  const Field& field =
    block.Add(1, [](const LongVec3& x, long double* u) { u[0] = 2 * x[0] * x[1] - x[2] + 1; });
  Scene scene_;
};

inline CameraView ObliqueView()
{
  CameraView view;
  view.position = { 2.0, 1.5, 4.0 };
  view.viewAngle = 33.0;
  return view;
}

/// Colours and opacities that distinguish most values.
inline ColorMap Striped(double step)
{
  return [step](std::span<const double> values, std::uint8_t* rgba)
  {
    for (const double v : values)
    {
      const auto channel = [&](double of)
      { return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * std::sin(of * v / step))); };
      const std::uint8_t color[4] = { channel(1.0), channel(1.7), channel(2.3),
        static_cast<std::uint8_t>(std::max<int>(60, channel(0.6))) };
      rgba = std::copy_n(color, 4, rgba);
    }
  };
}

inline ColorMapping LayeredColors(double step = 0.3)
{
  return ColorMapping(std::vector<LayerColors>{
    { Striped(step), { 255, 0, 255, 255 }, 0.6 }, { Striped(2.0 * step), { 1, 2, 3, 255 }, 0.8 } });
}
} // namespace pixelexact::testing
