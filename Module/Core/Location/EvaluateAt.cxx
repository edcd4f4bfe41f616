// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Location/SamplingSink.h"

#include <cmath>
#include <numeric>

namespace pixelexact
{
namespace
{
/// Tells a sink of points at given xi of one element, in their order.
void ReportInside(LocationSink& sink, int element, std::span<const Vec3> xi)
{
  if (xi.empty())
  {
    return;
  }
  std::vector<int> index(xi.size());
  std::iota(index.begin(), index.end(), 0);
  const LaneBuffer lanes(xi);
  const std::vector<double> residual(xi.size());
  sink.Inside(element, index, lanes.View().x, residual.data());
}
} // namespace

void EvaluateAt(const Mesh& mesh, const Field& field, int element, std::span<const Vec3> xi,
  std::span<double> value, std::span<double> gradient, const PlacesOfXi& places)
{
  SampleTarget target;
  target.value = value;
  target.gradient = gradient;
  target.normals = places.normals;
  RequireSizes(&field, xi.size(), target);
  if (!places.x.empty() && places.x.size() != xi.size())
  {
    throw Error("there are " + std::to_string(places.x.size()) + " world points for " +
      std::to_string(xi.size()) + " reference points.");
  }
  const LaneBuffer lanes(field.function != nullptr ? places.x : std::span<const Vec3>());
  SamplingSink sink(mesh, &field, lanes.View(), target);
  ReportInside(sink, element, xi);
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
  const LaneBuffer lanes(x);
  SamplingSink sink(mesh, &field, lanes.View(), target);
  ReportInside(sink, element, xi);
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
