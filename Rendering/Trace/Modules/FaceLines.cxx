// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/FaceLines.h"

#include "Core/Element/Kernels.h"
#include "Core/Faces/FacePlane.h"
#include "Core/Math/Mat.h"
#include "Trace/Modules/FaceKernels.h"
#include "Trace/Modules/FaceSearch.h"
#include "Trace/TileVisit.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace pixelexact
{
void FacePixels::Begin(std::size_t most)
{
  Size = 0;
  Stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(most)));
  if (Storage.size() < kColumns * Stride)
  {
    Storage.resize(kColumns * Stride);
  }
}

void FacePixels::Add(double u, double v, const Vec3& xi, const Vec3& position, const Vec3& normal)
{
  double* to = Storage.data() + Size;
  const auto put = [&to, this](double value)
  {
    *to = value;
    to += Stride;
  };
  put(u);
  put(v);
  for (const Vec3* const one : { &xi, &position, &normal })
  {
    put(one->x);
    put(one->y);
    put(one->z);
  }
  ++Size;
}

namespace
{
/// Largest distance in xi of a point that lies on a face.
constexpr double kOnFace = 1e-6;
/// Exceeds the rounding of lanes; the exact test follows.
constexpr double kWider = 1.0 + 1e-9;

/// Movement of the surface's point as the ray moves by a pixel across and up, times `facing`.
struct Spread
{
  Vec3 across;
  Vec3 up;
  double facing; ///< normal times direction
};

Spread SpreadAt(const Camera& camera, const ImagePosition& at, const Vec3& x, const Vec3& normal)
{
  const auto& [origin, direction] = camera.Rays();
  const double u = camera.U(at[0]);
  const double v = camera.V(at[1]);
  const Vec3 from = origin.constant + origin.u * u + origin.v * v;
  const Vec3 along = direction.constant + direction.u * u + direction.v * v;
  const double t = glm::dot(x - from, along) / glm::dot(along, along);
  const double facing = glm::dot(normal, along);
  const auto onPlane = [&](const Vec3& moved) -> Vec3
  { return moved * facing - along * glm::dot(normal, moved); };
  return { onPlane((origin.u + t * direction.u) * (2.0 / camera.Width())),
    onPlane((origin.v + t * direction.v) * (2.0 / camera.Height())), facing };
}

/// All faces are farther than `reach` pixels, to first order. Avoids divisions, because this holds
/// for most pixels. False if a number is not finite.
bool AreFar(std::span<const FacePlane> faces, const Vec3& xi, const Mat3& jacobian, double size,
  const Spread& spread, double reach)
{
  // Rows of the inverse, times the determinant.
  const Vec3 row0 = glm::cross(jacobian[1], jacobian[2]);
  const Vec3 row1 = glm::cross(jacobian[2], jacobian[0]);
  const Vec3 row2 = glm::cross(jacobian[0], jacobian[1]);
  const auto times = [&](const Vec3& v) -> Vec3 {
    return { glm::dot(row0, v), glm::dot(row1, v), glm::dot(row2, v) };
  };
  const Vec3 across = times(spread.across);
  const Vec3 up = times(spread.up);
  const double unit = std::fabs(glm::dot(jacobian[0], row0) * size * spread.facing);
  for (const FacePlane& face : faces)
  {
    const double far = face.Distance(xi) * unit;
    const double x = reach * glm::dot(face.gradient, across);
    const double y = reach * glm::dot(face.gradient, up);
    if (!(far > 0.0 && far * far >= x * x + y * y))
    {
      return false;
    }
  }
  return true;
}

bool LiesOn(const FacePlane& face, const Mat3& inverse, const Vec3& normal)
{
  const Vec3 gradient = glm::transpose(inverse) * face.gradient;
  const Vec3 across = glm::cross(gradient, normal);
  const double bound = FaceLines::kLyingOn * FaceLines::kLyingOn;
  return !(glm::dot(across, across) > bound * glm::dot(gradient, gradient));
}

/// The face on which the surface lies; -1: on none.
int FaceUnder(
  std::span<const FacePlane> faces, const Vec3& xi, const Mat3& inverse, const Vec3& normal)
{
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (std::fabs(faces[f].Distance(xi)) < kOnFace && LiesOn(faces[f], inverse, normal))
    {
      return static_cast<int>(f);
    }
  }
  return -1;
}

} // namespace

std::span<const FaceLine> FaceLines::Find(TileVisit& tile, double reach)
{
  Searches.clear();
  Found.clear();
  GatherRuns(tile);
  for (std::size_t begin = 0, end = 0; begin < Runs.size(); begin = end)
  {
    while (end < Runs.size() && Runs[end].element == Runs[begin].element)
    {
      ++end;
    }
    Begin(tile, std::span(Runs).subspan(begin, end - begin), reach);
  }
  Follow(Searches, tile, reach);
  for (const FaceSearch& search : Searches)
  {
    if (search.found && search.line.distance < reach)
    {
      Found.push_back(search.line);
    }
  }
  return Found;
}

void FaceLines::GatherRuns(TileVisit& tile)
{
  Runs.clear();
  const SampleBuffers& samples = tile.GetFrame().centres;
  const TileArea& area = tile.Area();
  for (int y = area.y0; y < area.y1; ++y)
  {
    bool open = false;
    for (int x = area.x0; x < area.x1; ++x)
    {
      const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.width) +
        static_cast<std::size_t>(x);
      if (samples.verdict[pixel] != static_cast<std::uint8_t>(PixelVerdict::Exact))
      {
        open = false;
        continue;
      }
      const auto element = static_cast<int>(samples.element[pixel]);
      const int layer = samples.layer[pixel];
      if (open && Runs.back().element == element && Runs.back().layer == layer)
      {
        ++Runs.back().count;
        continue;
      }
      Runs.push_back({ element, layer, pixel, x, y, 1 });
      open = true;
    }
  }
  std::ranges::stable_sort(Runs, {}, &Run::element);
}

void FaceLines::Begin(TileVisit& tile, std::span<const Run> runs, double reach)
{
  const SampleBuffers& samples = tile.GetFrame().centres;
  const Mesh& mesh = tile.GetScene().locator->GetMesh();
  const int element = runs.front().element;
  const double size = mesh.size[static_cast<std::size_t>(element)];
  const auto faces = FacePlanesOf(mesh.ShapeOf(element));
  const Camera& camera = tile.GetCamera();
  Xi.clear();
  Pixels.Begin(
    static_cast<std::size_t>(tile.Area().Width()) * static_cast<std::size_t>(tile.Area().Height()));
  for (const Run& run : runs)
  {
    const Vec3* const first = &samples.xi[run.pixel];
    Xi.insert(Xi.end(), first, first + run.count);
    const double v = camera.V(run.y + 0.5);
    for (int k = 0; k < run.count; ++k)
    {
      const std::size_t pixel = run.pixel + static_cast<std::size_t>(k);
      Pixels.Add(camera.U(run.x + k + 0.5), v, samples.xi[pixel], samples.position[pixel],
        samples.normal[pixel]);
    }
  }
  const MappedPoints mapped(mesh, element, Xi, true);
  // Most pixels are far from all faces.
  Near.resize(Xi.size());
  GetFaceKernels().findNear(camera.Rays(),
    { faces, size, 2.0 / camera.Width(), 2.0 / camera.Height(),
      kWider * FaceSearch::kSlack * reach },
    Pixels, mapped.Jacobians(), Near.data());
  std::size_t at = 0;
  for (const Run& run : runs)
  {
    for (int k = 0; k < run.count; ++k, ++at)
    {
      if (Near[at] == 0)
      {
        continue;
      }
      const std::size_t pixel = run.pixel + static_cast<std::size_t>(k);
      const Vec3& normal = samples.normal[pixel];
      const ImagePosition from{ run.x + k + 0.5, run.y + 0.5 };
      const Spread spread = SpreadAt(camera, from, samples.position[pixel], normal);
      const Mat3 jacobian = mapped.Jacobian(at);
      if (AreFar(faces, Xi[at], jacobian, size, spread, FaceSearch::kSlack * reach))
      {
        continue;
      }
      const Mat3 inverse = glm::inverse(jacobian);
      const Vec3 across = inverse * spread.across / (size * spread.facing);
      const Vec3 up = inverse * spread.up / (size * spread.facing);
      for (std::size_t f = 0; f < faces.size(); ++f)
      {
        const FacePlane& face = faces[f];
        const glm::dvec2 gradient{ glm::dot(face.gradient, across), glm::dot(face.gradient, up) };
        const double slope = glm::length(gradient);
        const double distance = face.Distance(Xi[at]);
        // Numbers are not finite where the map collapses.
        if (!(distance < FaceSearch::kSlack * reach * slope) || !std::isfinite(slope) ||
          LiesOn(face, inverse, normal))
        {
          continue;
        }
        FaceSearch& search = Searches.emplace_back();
        search.line = { .pixel = pixel,
          .element = element,
          .face = static_cast<int>(f),
          .towards = -gradient / slope,
          // Across the shape the distance goes from 0 to 2.
          .elementSize = 2.0 / slope,
          .lyingOn = FaceUnder(faces, Xi[at], inverse, normal) };
        search.layer = run.layer;
        search.from = from;
        search.position = samples.position[pixel];
        search.step = (search.line.towards.x * spread.across + search.line.towards.y * spread.up) /
          spread.facing;
        search.xi = Xi[at];
        search.mapped = mapped.At(at);
        search.inverse = inverse;
        search.atPixel = distance;
        search.atReached = distance;
        search.slope = slope;
        search.root = distance / slope;
        search.tried = search.root;
      }
    }
  }
}
} // namespace pixelexact
