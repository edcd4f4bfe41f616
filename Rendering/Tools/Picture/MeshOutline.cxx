// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/MeshOutline.h"

#include "Drawing/Blending.h"
#include "Picture/OutlineLines.h"
#include "Scene/ColorOptions.h"
#include "Scene/Shot.h"

#include "Views/VtkLook.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Distance of a stepped line from the true one, in pixels of the grid in which the boundary is
/// traced.
constexpr double kStairs = 0.55;

/// Places where a line is, and how much of each pixel it covers.
class Pen
{
public:
  Pen(int width, int height, double thickness)
    : Width(width)
    , Height(height)
    , Half(0.5 * thickness)
    , Covered(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
  {
  }

  void Dot(double x, double y)
  {
    const double reach = Half + 0.5;
    for (int j = std::max(0, static_cast<int>(std::floor(y - reach)));
         j <= std::min(Height - 1, static_cast<int>(std::floor(y + reach))); ++j)
    {
      for (int i = std::max(0, static_cast<int>(std::floor(x - reach)));
           i <= std::min(Width - 1, static_cast<int>(std::floor(x + reach))); ++i)
      {
        const double away = std::hypot(i + 0.5 - x, j + 0.5 - y);
        float& part = Covered[static_cast<std::size_t>(j) * static_cast<std::size_t>(Width) +
          static_cast<std::size_t>(i)];
        part = std::max(part, static_cast<float>(std::clamp(reach - away, 0.0, 1.0)));
      }
    }
  }

  void Paint(const Rgba& color, std::vector<std::uint8_t>& rgba) const
  {
    for (std::size_t i = 0; i < Covered.size(); ++i)
    {
      if (Covered[i] > 0.0F)
      {
        BlendOver(color, Covered[i], &rgba[4 * i]);
      }
    }
  }

private:
  int Width;
  int Height;
  double Half;
  std::vector<float> Covered;
};

} // namespace

void MeshOutline::AddTo(CLI::App& command)
{
  Bind(command, "--mesh-outline",
    [this](const std::string& text)
    {
      if (text != "boundary" && text != "box" && text != "undeformed")
      {
        Refuse("--mesh-outline", text, "boundary, box or undeformed");
      }
      Kind = text == "box" ? Of::Box : text == "undeformed" ? Of::Undeformed : Of::Boundary;
    });
  Bind(command, "--mesh-outline-width", Width);
  Bind(command, "--mesh-outline-color", Color);
}

Buffer MeshOutline::Needs() const
{
  return Kind == Of::Box ? Buffer::Depth : Buffer::None;
}

std::vector<Vec3> MeshOutline::Points(const Shot& shot) const
{
  if (Kind == Of::Box)
  {
    const auto corners = CornersOfBox(shot);
    return { corners.begin(), corners.end() };
  }
  return IsAsked() ? SeenPoints(BoundaryOf(shot, Kind == Of::Undeformed), shot.view, shot.size)
                   : std::vector<Vec3>();
}

Rgba MeshOutline::LineColor() const
{
  return ToRgba(Color.data());
}

void MeshOutline::Draw(const Shot& shot, Frame& frame) const
{
  Pen pen(frame.width, frame.height, LineWidth());
  if (Kind == Of::Box)
  {
    for (const std::vector<CanvasPoint>& path : SeenEdgesOfBox(shot, frame))
    {
      std::ranges::for_each(path, [&pen](const CanvasPoint& at) { pen.Dot(at[0], at[1]); });
    }
  }
  else
  {
    const BoundaryLines lines =
      LinesOfBoundary(shot, Kind == Of::Undeformed, frame.width, frame.height);
    for (const PixelStep& step : lines.steps)
    {
      pen.Dot(step.at[0] / lines.fine, step.at[1] / lines.fine);
    }
  }
  pen.Paint(LineColor(), frame.color.empty() ? frame.centres.color : frame.color);
}

std::vector<std::vector<CanvasPoint>> MeshOutline::Paths(const Shot& shot, const Frame& frame) const
{
  if (Kind == Of::Box)
  {
    std::vector<std::vector<CanvasPoint>> paths = SeenEdgesOfBox(shot, frame);
    for (std::vector<CanvasPoint>& path : paths)
    {
      // The path is straight.
      path = { path.front(), path.back() };
    }
    return paths;
  }
  const BoundaryLines lines =
    LinesOfBoundary(shot, Kind == Of::Undeformed, frame.width, frame.height);
  std::vector<std::vector<CanvasPoint>> paths = PathsOf(lines.steps, kStairs);
  for (std::vector<CanvasPoint>& path : paths)
  {
    for (CanvasPoint& at : path)
    {
      at = { at[0] / lines.fine, at[1] / lines.fine };
    }
  }
  return paths;
}
} // namespace pixelexact
