// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Element/RangeIngredients.h"
#include "Core/Math/Rounding.h"
#include "Core/Shape/ShapeFace.h"
#include "Trace/Surfaces/Curved/FaceModes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
Box3 FaceBox(const Mesh& mesh, const CurvedPart& part, const FaceModes* modes)
{
  const auto e = static_cast<std::size_t>(part.element);
  const Box3 anywhere{ Vec3(-INFINITY), Vec3(INFINITY) };
  const ScaledModes map = modes != nullptr
    ? ScaledModes(modes->space, modes->coefficients.data(), 3)
    : ScaledModes(mesh.map.SpaceOf(part.element), mesh.map.Coefficients(part.element), 3);
  if (!map.finite)
  {
    return anywhere;
  }
  const ShapeFace& face = FacesOf(mesh.ShapeOf(part.element))[static_cast<std::size_t>(part.face)];
  const FaceChart chart = ChartOf(mesh.ShapeOf(part.element), part.face);
  const Box3 all{ Vec3(-1.0), Vec3(1.0) };
  const int level =
    LevelFor({ { &map, 0, Part::Value }, { &map, 1, Part::Value }, { &map, 2, Part::Value } });
  const int count = 1 << level;
  const double uncertainty = rounding::Above(
    rounding::Above(mesh.uncertainty[e] / mesh.size[e]) + (modes != nullptr ? modes->error : 0.0));
  const double scale = std::ldexp(1.0, map.exponent);
  Box3 box{ Vec3(INFINITY), Vec3(-INFINITY) };
  for (int i = 0; i < count * count; ++i)
  {
    const int row = i / count;
    const int column = i % count;
    Vec3 middle;
    middle[face.direction] = face.upper ? 1.0 - 1.0 / count : 1.0 / count - 1.0;
    middle[(face.direction + 1) % 3] = (2.0 * row + 1.0) / count - 1.0;
    middle[(face.direction + 2) % 3] = (2.0 * column + 1.0) / count - 1.0;
    const auto piece = PieceAt({ middle, middle }, level);
    for (int c = 0; c < 3; ++c)
    {
      const RangeIngredient value{ &map, c, Part::Value };
      const BoxPolynomial over = modes != nullptr
        ? OverFace(chart, value, level, piece)
        : value.Over(level, piece, all).AtEnd(face.direction, face.upper);
      const Interval y = over.Hull() * Interval(scale) + Interval(-uncertainty, uncertainty);
      const Interval x =
        Interval(mesh.centre[3 * e + static_cast<std::size_t>(c)]) + y * Interval(mesh.size[e]);
      if (!std::isfinite(x.Width()))
      {
        return anywhere;
      }
      box.lower[c] = std::min(box.lower[c], x.lower);
      box.upper[c] = std::max(box.upper[c], x.upper);
    }
  }
  return box;
}

void FaceNormals(const FaceMap& map, std::span<const Vec3> xi, std::span<Vec3> normals)
{
  const auto count = static_cast<int>(xi.size());
  const auto stride = static_cast<std::size_t>(PaddedCount(count));
  std::vector<double> lanes(13 * stride);
  const auto lane = [&](std::size_t k) { return lanes.data() + k * stride; };
  const LaneBuffer points(xi);
  double* const value[3] = { lane(0), lane(1), lane(2) };
  double* slope[7];
  for (std::size_t k = 0; k < 7; ++k)
  {
    slope[k] = lane(3 + k);
  }
  map.Evaluate(points.View(), value, slope);
  double* const normal[3] = { lane(10), lane(11), lane(12) };
  GetFaceNormalKernels().make(map.OutwardSign(), slope, count, normal);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    normals[i] = { normal[0][i], normal[1][i], normal[2][i] };
  }
}
} // namespace pixelexact
