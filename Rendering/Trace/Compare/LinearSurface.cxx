// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/LinearSurface.h"

#include "Trace/RayKernels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace pixelexact
{
namespace
{
/// Rays that are cast together.
constexpr int kBatch = 128;
/// Rows between two calls of the progress function.
constexpr int kRows = 64;

using Row = std::array<double, kBatch>;
} // namespace

LinearSurface::LinearSurface(
  std::vector<Triangles::Triangle> triangles, std::vector<std::array<double, 3>> values)
  : Values(std::move(values))
{
  if (!triangles.empty())
  {
    Shapes = std::make_unique<const Triangles>(std::move(triangles));
  }
}

void LinearSurface::TraceRow(
  const Camera& camera, int row, double offset, std::span<double> values) const
{
  Row u;
  Row v;
  Row nearest;
  Row farthest;
  std::array<Row, 3> origin;
  std::array<Row, 3> direction;
  v.fill(camera.V(row + offset));
  nearest.fill(kNearest);
  farthest.fill(kFarthest);
  HitSlots hits;
  for (std::size_t begin = 0; begin < values.size(); begin += kBatch)
  {
    const int count = static_cast<int>(std::min<std::size_t>(kBatch, values.size() - begin));
    for (int i = 0; i < kBatch; ++i)
    {
      // Positions after the end of a row repeat the last one.
      u[static_cast<std::size_t>(i)] =
        camera.U(static_cast<double>(begin) + std::min(i, count - 1) + offset);
    }
    double* const origins[3] = { origin[0].data(), origin[1].data(), origin[2].data() };
    double* const directions[3] = { direction[0].data(), direction[1].data(), direction[2].data() };
    GetRayKernels().cast(camera.Rays(), u.data(), v.data(), count, origins, directions);
    hits.Begin(count);
    hits.MoveTo(0);
    Shapes->Meet({ { origin[0].data(), origin[1].data(), origin[2].data() },
                   { direction[0].data(), direction[1].data(), direction[2].data() },
                   nearest.data(), farthest.data(), count, true },
      hits);
    for (int i = 0; hits.Count() > 0 && i < count; ++i)
    {
      if (hits.T(0)[i] < kNoHit)
      {
        const SurfacePoint point = hits.PointOf(0, i);
        const std::array<double, 3>& at = Values[static_cast<std::size_t>(point.piece)];
        const double s = point.parameters[0];
        const double t = point.parameters[1];
        values[begin + static_cast<std::size_t>(i)] = (1.0 - s - t) * at[0] + s * at[1] + t * at[2];
      }
    }
  }
}

std::vector<double> LinearSurface::Trace(
  const Camera& camera, bool corners, const Progress& progress) const
{
  const int more = corners ? 1 : 0;
  const int width = camera.Width() + more;
  const int height = camera.Height() + more;
  const double offset = corners ? 0.0 : 0.5;
  std::vector<double> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
    std::numeric_limits<double>::quiet_NaN());
  for (int begin = 0; begin < height && Shapes != nullptr; begin += kRows)
  {
    const int end = std::min(height, begin + kRows);
    tbb::parallel_for(begin, end,
      [&](int row)
      {
        TraceRow(camera, row, offset,
          std::span(values).subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(width),
            static_cast<std::size_t>(width)));
      });
    if (progress && !progress(static_cast<double>(end) / height))
    {
      return {};
    }
  }
  return values;
}
} // namespace pixelexact
