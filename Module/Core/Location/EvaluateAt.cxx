// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Core/Location/SamplingSink.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Tells a sink of points at given xi of one element, in their order.
void TellInside(LocationSink& sink, int element, std::span<const Vec3> xi)
{
  if (xi.empty())
  {
    return;
  }
  std::vector<int> index(xi.size());
  std::vector<double> lanes(4 * static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size()))));
  const std::size_t stride = lanes.size() / 4;
  for (std::size_t k = 0; k < stride; ++k)
  {
    const std::size_t from = std::min(k, xi.size() - 1);
    for (int d = 0; d < 3; ++d)
    {
      lanes[static_cast<std::size_t>(d) * stride + k] = xi[from][d];
    }
    index[from] = static_cast<int>(from);
  }
  const double* const pointers[3] = { &lanes[0], &lanes[stride], &lanes[2 * stride] };
  sink.Inside(element, index, pointers, &lanes[3 * stride]);
}
} // namespace

void EvaluateAt(const Mesh& mesh, const Field& field, int element, std::span<const Vec3> xi,
  std::span<double> value, std::span<double> gradient)
{
  SampleTarget target;
  target.value = value;
  target.gradient = gradient;
  RequireSizes(&field, xi.size(), target);
  SamplingSink sink(mesh, &field, {}, target);
  TellInside(sink, element, xi);
}

void EncloseAt(const Mesh& mesh, const Field& field, int element, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<double> lower, std::span<double> upper)
{
  SampleTarget target;
  target.valueLower = lower;
  target.valueUpper = upper;
  RequireSizes(&field, xi.size(), target);
  if (x.size() != xi.size())
  {
    throw Error("enclosures need a world point for each of the " + std::to_string(xi.size()) +
      " reference points.");
  }
  SamplingSink sink(mesh, &field, x, target);
  TellInside(sink, element, xi);
}

void MapForward(const Mesh& mesh, int element, std::span<const Vec3> xi, std::span<Vec3> x)
{
  std::vector<double> y(3 * xi.size());
  const Field map{ "Phi", mesh.map };
  EvaluateAt(mesh, map, element, xi, y, {});
  const double* centre = &mesh.centre[3 * static_cast<std::size_t>(element)];
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      x[k][d] = std::fma(mesh.size[element], y[3 * k + d], centre[d]);
    }
  }
}
} // namespace pixelexact
