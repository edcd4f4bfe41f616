// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FigureAxes.h"

#include "Drawing/Canvas.h"
#include "Drawing/Ticks.h"
#include "Scene/Shot.h"

#include "Trace/Projection.h"
#include "Trace/Surfaces/Surface.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
constexpr double kParallel = 1.0 - 1e-9;

/// A coordinate axis along a side of the picture.
struct SideAxis
{
  int axis;
  double sign;
};

std::optional<SideAxis> AxisAlong(const Vec3& direction)
{
  for (int d = 0; d < 3; ++d)
  {
    if (std::fabs(direction[d]) > kParallel)
    {
      return SideAxis{ d, direction[d] > 0.0 ? 1.0 : -1.0 };
    }
  }
  return std::nullopt;
}

/// Whether coordinates have few digits: their distances are not much smaller than they are.
bool HasShortNumbers(const Shot& shot, int right, int up)
{
  const Box3 box = BoxOf(*shot.input.model);
  double size = 0.0;
  double extent = 0.0;
  for (const int d : { right, up })
  {
    size = std::max({ size, std::fabs(box.lower[d]), std::fabs(box.upper[d]) });
    extent = std::max(extent, box.upper[d] - box.lower[d]);
  }
  // Numbers with an exponent have room for fewer digits.
  const double most = size >= 1e-3 && size < 1e6 ? 1000.0 : 10.0;
  return size <= most * extent;
}
} // namespace

bool HasOneScale(const Shot& shot)
{
  if (shot.view.parallel)
  {
    return true;
  }
  const Surface& surface = *shot.scene.layers.front().surface;
  return shot.scene.layers.size() == 1 && !shot.volume && surface.IsFlat() &&
    std::fabs(glm::dot(surface.Normal({ shot.view.focalPoint }), AxesOf(shot.view).forward)) >
    kParallel;
}

bool HasCoordinates(const Shot& shot)
{
  const CameraAxes axes = AxesOf(shot.view);
  const auto right = AxisAlong(axes.right);
  const auto up = AxisAlong(axes.up);
  return HasOneScale(shot) && right && up && HasShortNumbers(shot, right->axis, up->axis);
}

double LengthOfPixel(const Shot& shot)
{
  const CameraView& view = shot.view;
  if (!HasOneScale(shot))
  {
    return 0.0;
  }
  if (view.parallel)
  {
    return 2.0 * view.parallelScale / shot.size.height;
  }
  const auto hits = HitsOf(*shot.scene.layers.front().surface,
    shot.MakeCamera().At(0.5 * shot.size.width, 0.5 * shot.size.height));
  return hits.empty() ? 0.0
                      : 2.0 * glm::distance(hits.front().position, view.position) *
      std::tan(0.5 * glm::radians(view.viewAngle)) / shot.size.height;
}

double AspectOfBox(const Shot& shot)
{
  const CameraAxes axes = AxesOf(shot.view);
  const std::array<Vec3, 8> corners = CornersOfBox(shot);
  const auto extent = [&corners](const Vec3& along)
  {
    std::array<double, 8> at{};
    std::ranges::transform(
      corners, at.begin(), [&along](const Vec3& corner) { return glm::dot(corner, along); });
    const auto [low, high] = std::ranges::minmax(at);
    return high - low;
  };
  const double width = extent(axes.right);
  const double height = extent(axes.up);
  return std::clamp(
    height > 0.0 ? width / height : kMaxBoxAspect, 1.0 / kMaxBoxAspect, kMaxBoxAspect);
}

void DrawCoordinates(Canvas& canvas, const FigureLayout& layout, const Shot& shot,
  const std::string& unit, const Rgba& ink)
{
  const double pixel = LengthOfPixel(shot);
  if (!(pixel > 0.0) || !std::isfinite(pixel))
  {
    return;
  }
  const CameraAxes axes = AxesOf(shot.view);
  const double font = layout.font;
  const double pen = std::max(1.0, font / 20.0);
  const std::array<int, 2> sides{ layout.picture.width, layout.picture.height };
  canvas.Frame(layout.corner[0], layout.corner[1], sides[0], sides[1], ink);
  for (const std::size_t side : { 0U, 1U })
  {
    const SideAxis along = *AxisAlong(side == 0 ? axes.right : axes.up);
    const double length = sides[side];
    const double middle = shot.view.position[along.axis];
    const double half = 0.5 * length * pixel;
    const int most = std::max(2, static_cast<int>(length / ((side == 0 ? 6.0 : 4.0) * font)));
    const double begin = layout.corner[side];
    double widest = 0.0;
    for (const Tick& tick : RoundTicks({ middle - half, middle + half }, most))
    {
      const double at =
        std::floor(begin + 0.5 * length + along.sign * (tick.value - middle) / pixel) + 0.5;
      if (side == 0)
      {
        const double y = layout.corner[1];
        canvas.Line({ at, y - 1.0 }, { at, y - 0.4 * font }, pen, ink);
        canvas.Write(tick.text, at, y - 1.2 * font, TextAnchor::Centre, ink);
      }
      else
      {
        const double x = layout.corner[0];
        canvas.Line({ x - 1.0, at }, { x - 0.4 * font, at }, pen, ink);
        canvas.Write(tick.text, x - 0.7 * font, at, TextAnchor::Right, ink);
        widest = std::max(widest, canvas.WidthOf(tick.text));
      }
    }
    std::string name(1, "xyz"[along.axis]);
    name.append(unit.empty() ? "" : " [" + unit + "]");
    const double across = begin + 0.5 * length;
    if (side == 0)
    {
      canvas.WriteWithin(
        name, across, layout.corner[1] - 2.7 * font, TextAnchor::Centre, length, ink);
    }
    else
    {
      const double left = layout.corner[0] - 1.7 * font - widest;
      const double small = std::min(1.0, length / std::max(canvas.WidthOf(name), 1.0));
      canvas.WriteTurned(name, { std::max(left, 0.7 * font), across }, 90.0,
        std::max(1, static_cast<int>(small * font)), ink);
    }
  }
}
} // namespace pixelexact
