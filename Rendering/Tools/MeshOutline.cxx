// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOutline.h"

#include "Blending.h"
#include "ColorOptions.h"
#include "Command.h"
#include "Model.h"
#include "Projection.h"
#include "Report.h"
#include "Shot.h"

#include "MeshSurfaces.h"
#include "Trace/Tracer.h"
#include "VtkLook.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace pixelexact
{
namespace
{
constexpr double kUsualWidth = 1.5;
constexpr double kWidest = 100.0;
/// The cosine of 30 degrees, by which a normal turns at an edge.
const double kSharp = std::cos(std::numbers::pi / 6.0);
/// In pixels: how far behind each other surfaces are that are not one.
constexpr double kStep = 3.0;
/// Pixels up to which the boundary is traced finer than the picture.
constexpr std::int64_t kFinePixels = std::int64_t{ 1 } << 24;

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

std::array<Vec3, 8> CornersOf(const Box3& box)
{
  std::array<Vec3, 8> corners{};
  for (int k = 0; k < 8; ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      corners[static_cast<std::size_t>(k)][d] = (k >> d & 1) != 0 ? box.upper[d] : box.lower[d];
    }
  }
  return corners;
}

void DrawEdge(
  const Vec3& from, const Vec3& to, const Projection& projection, const Frame& frame, Pen& pen)
{
  const auto first = projection.Of(from);
  const auto last = projection.Of(to);
  if (!first || !last)
  {
    // It leads behind the viewer.
    return;
  }
  const double length = std::hypot(last->at[0] - first->at[0], last->at[1] - first->at[1]);
  const int steps = static_cast<int>(std::ceil(std::min(4.0 * length, 1e6))) + 1;
  for (int s = 0; s <= steps; ++s)
  {
    const auto seen = projection.Of(glm::mix(from, to, static_cast<double>(s) / steps));
    if (!seen)
    {
      continue;
    }
    const auto [x, y] = seen->at;
    const bool within = x >= 0.0 && y >= 0.0 && x < frame.width && y < frame.height;
    const double cut = within
      ? frame.centres.depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
          static_cast<std::size_t>(x)]
      : 0.0;
    // Not a number: unknown. On the surface it is seen.
    if (within && !(seen->depth > cut + projection.PixelAt(cut)))
    {
      pen.Dot(x, y);
    }
  }
}

void DrawBox(const Shot& shot, const Frame& frame, Pen& pen)
{
  const Projection projection(shot.view, frame.width, frame.height);
  const std::array<Vec3, 8> corners = CornersOf(BoxOf(*shot.input.model));
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    for (const std::size_t side : { 1U, 2U, 4U })
    {
      if ((k & side) == 0)
      {
        DrawEdge(corners[k], corners[k | side], projection, frame, pen);
      }
    }
  }
}

Scene BoundaryOf(const Shot& shot)
{
  Scene scene;
  scene.locator = shot.scene.locator;
  scene.layers.push_back({ MakeBoundary(shot.input.model, {}) });
  return scene;
}

/// Tells where lines are between the pixels of a boundary's frame.
class Steps
{
public:
  Steps(const Frame& frame, const Camera& camera, const Projection& projection)
    : Of(frame.centres)
    , Rays(camera)
    , Scale(projection)
  {
  }

  [[nodiscard]] bool Between(int i, int j, int k, int l) const
  {
    const std::size_t p = At(i, j);
    const std::size_t q = At(k, l);
    const bool hitP = Is(p, PixelVerdict::Exact);
    const bool hitQ = Is(q, PixelVerdict::Exact);
    if (Is(p, PixelVerdict::Unknown) || Is(q, PixelVerdict::Unknown) || (!hitP && !hitQ))
    {
      return false;
    }
    if (hitP != hitQ)
    {
      return true;
    }
    const Ray rayP = Rays.At(i + 0.5, j + 0.5);
    const Ray rayQ = Rays.At(k + 0.5, l + 0.5);
    const Vec3 normalP = Towards(p, rayP);
    const Vec3 normalQ = Towards(q, rayQ);
    return glm::dot(normalP, normalQ) < kSharp ||
      (Misses(p, normalP, q, rayQ) && Misses(q, normalQ, p, rayP));
  }

private:
  [[nodiscard]] std::size_t At(int i, int j) const
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(Of.width) +
      static_cast<std::size_t>(i);
  }
  [[nodiscard]] bool Is(std::size_t pixel, PixelVerdict verdict) const
  {
    return Of.verdict[pixel] == static_cast<std::uint8_t>(verdict);
  }
  [[nodiscard]] Vec3 Towards(std::size_t pixel, const Ray& ray) const
  {
    const Vec3& normal = Of.normal[pixel];
    return glm::dot(normal, ray.direction) > 0.0 ? -normal : normal;
  }
  /// Whether another ray's hit is not where the tangent plane of a pixel's hit leads it.
  [[nodiscard]] bool Misses(
    std::size_t pixel, const Vec3& normal, std::size_t other, const Ray& ray) const
  {
    const double slope = glm::dot(ray.direction, normal);
    const double depth = glm::dot(Of.position[pixel] - ray.origin, normal) / slope;
    return !(std::fabs(depth - Of.depth[other]) <= kStep * Scale.PixelAt(Of.depth[other]));
  }

  const SampleBuffers& Of;
  const Camera& Rays;
  const Projection& Scale;
};

void DrawBoundary(const Shot& shot, const Frame& frame, Pen& pen)
{
  const std::int64_t pixels = std::int64_t{ frame.width } * frame.height;
  const int fine = 4 * pixels <= kFinePixels ? 2 : 1;
  const int width = fine * frame.width;
  const int height = fine * frame.height;
  const Camera camera(shot.view, width, height);
  ProgressLine line("outlining");
  const Frame boundary = Trace(BoundaryOf(shot), camera, {},
    { .centres = Buffer::Verdict | Buffer::Normal | Buffer::Depth | Buffer::Position },
    std::ref(line));
  const Projection projection(shot.view, width, height);
  const Steps steps(boundary, camera, projection);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      if (i + 1 < width && steps.Between(i, j, i + 1, j))
      {
        pen.Dot((i + 1.0) / fine, (j + 0.5) / fine);
      }
      if (j + 1 < height && steps.Between(i, j, i, j + 1))
      {
        pen.Dot((i + 0.5) / fine, (j + 1.0) / fine);
      }
    }
  }
}
} // namespace

void MeshOutline::AddTo(CLI::App& command)
{
  const char* group = "Figure";
  const AddedOption outlined = AddRead(
    command, "--mesh-outline",
    [this](const std::string& text)
    {
      if (text != "boundary" && text != "box")
      {
        Refuse("--mesh-outline", text, "boundary or box");
      }
      Kind = text == "box" ? Of::Box : Of::Boundary;
    },
    "[=boundary|box]",
    "Draw where the mesh is: outlines and sharp edges of its boundary, or the edges of its box")
                                 .Group(group);
  AddNumber(command, "--mesh-outline-width", Width, "PIXELS",
    fmt::format("The width of these lines (default: {})", kUsualWidth))
    .Needs(outlined)
    .Group(group);
  AddNumbers(command, "--mesh-outline-color", Color, 3, "r,g,b",
    "Their colour, 0 to 1 each (default: 0,0,0)")
    .Needs(outlined)
    .Group(group);
}

void MeshOutline::Check() const
{
  CheckColor("--mesh-outline-color", Color);
  if (Width && !(*Width > 0.0 && *Width <= kWidest))
  {
    throw UsageError(
      fmt::format("--mesh-outline-width: expected pixels above 0 and up to {}", kWidest));
  }
}

Buffer MeshOutline::Needs() const
{
  return Kind == Of::Box ? Buffer::Depth : Buffer::None;
}

std::vector<Vec3> MeshOutline::Points(const Shot& shot) const
{
  if (Kind == Of::Box)
  {
    const auto corners = CornersOf(BoxOf(*shot.input.model));
    return { corners.begin(), corners.end() };
  }
  return Kind == Of::Boundary ? SeenPoints(BoundaryOf(shot), shot.view, shot.size)
                              : std::vector<Vec3>();
}

void MeshOutline::Draw(const Shot& shot, Frame& frame) const
{
  Pen pen(frame.width, frame.height, Width.value_or(kUsualWidth));
  if (Kind == Of::Box)
  {
    DrawBox(shot, frame, pen);
  }
  else
  {
    DrawBoundary(shot, frame, pen);
  }
  pen.Paint(ToRgba(Color.data()), frame.color.empty() ? frame.centres.color : frame.color);
}
} // namespace pixelexact
