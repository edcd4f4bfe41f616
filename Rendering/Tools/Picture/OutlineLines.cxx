// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/OutlineLines.h"

#include "Base/Command.h"
#include "Base/Report.h"
#include "Scene/Model.h"
#include "Scene/Shot.h"

#include "Surfaces/MeshSurfaces.h"
#include "Trace/Projection.h"
#include "Trace/Tracer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>

namespace pixelexact
{
namespace
{
/// The cosine of 30 degrees, by which a normal turns at an edge.
const double kSharp = std::cos(std::numbers::pi / 6.0);
/// Least distance in depth, in pixels, of different surfaces.
constexpr double kDepthStep = 3.0;
/// Pixels up to which the boundary is traced finer than the picture.
constexpr std::int64_t kFinePixels = std::int64_t{ 1 } << 24;

using Path = std::vector<CanvasPoint>;

void AddEdge(const Vec3& from, const Vec3& to, const Projection& projection, const Frame& frame,
  std::vector<Path>& paths)
{
  const auto first = projection.Of(from);
  const auto last = projection.Of(to);
  if (!first || !last)
  {
    // The edge leads behind the viewer.
    return;
  }
  const double length = std::hypot(last->at[0] - first->at[0], last->at[1] - first->at[1]);
  const int steps = static_cast<int>(std::ceil(std::min(4.0 * length, 1e6))) + 1;
  Path path;
  const auto end = [&]
  {
    if (!path.empty())
    {
      paths.push_back(std::move(path));
      path = {};
    }
  };
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
    // The depth is NaN where the pixel is unknown. Points on the surface are visible.
    if (within && !(seen->depth > cut + projection.PixelAt(cut)))
    {
      path.push_back(seen->at);
    }
    else
    {
      end();
    }
  }
  end();
}

/// Finds the lines between the pixels of a boundary's frame.
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
    return !(std::fabs(depth - Of.depth[other]) <= kDepthStep * Scale.PixelAt(Of.depth[other]));
  }

  const SampleBuffers& Of;
  const Camera& Rays;
  const Projection& Scale;
};

} // namespace

Scene BoundaryOf(const Shot& shot, bool undeformed)
{
  if (undeformed && shot.input.undeformed == nullptr)
  {
    throw UsageError("--mesh-outline=undeformed needs --warp");
  }
  const std::shared_ptr<HighOrderModel> model =
    undeformed ? HighOrderModel::From(shot.input.undeformed) : shot.input.model;
  Scene scene;
  scene.locator = &model->GetLocator();
  scene.layers.push_back({ MakeBoundary(model, {}) }); // which keeps the model
  return scene;
}

std::vector<std::vector<CanvasPoint>> SeenEdgesOfBox(const Shot& shot, const Frame& frame)
{
  const Projection projection(shot.view, frame.width, frame.height);
  const std::array<Vec3, 8> corners = CornersOfBox(shot);
  std::vector<Path> paths;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    for (const std::size_t side : { 1U, 2U, 4U })
    {
      if ((k & side) == 0)
      {
        AddEdge(corners[k], corners[k | side], projection, frame, paths);
      }
    }
  }
  return paths;
}

BoundaryLines LinesOfBoundary(
  const Shot& shot, bool undeformed, int pictureWidth, int pictureHeight)
{
  const std::int64_t pixels = std::int64_t{ pictureWidth } * pictureHeight;
  const int fine = 4 * pixels <= kFinePixels ? 2 : 1;
  const int width = fine * pictureWidth;
  const int height = fine * pictureHeight;
  const Camera camera(shot.view, width, height);
  ProgressLine line("outlining");
  const Frame boundary = Trace(BoundaryOf(shot, undeformed), camera, {},
    { .centres = Buffer::Verdict | Buffer::Normal | Buffer::Depth | Buffer::Position },
    std::ref(line));
  const Projection projection(shot.view, width, height);
  const Steps steps(boundary, camera, projection);
  BoundaryLines lines{ {}, static_cast<double>(fine) };
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      if (i + 1 < width && steps.Between(i, j, i + 1, j))
      {
        lines.steps.push_back(PixelStep::Right(i, j));
      }
      if (j + 1 < height && steps.Between(i, j, i, j + 1))
      {
        lines.steps.push_back(PixelStep::Up(i, j));
      }
    }
  }
  return lines;
}
} // namespace pixelexact
