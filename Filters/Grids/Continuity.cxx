// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/Continuity.h"

#include "Core/Location/Sample.h"

#include <tbb/parallel_for.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace pixelexact
{
namespace
{
constexpr int kMaxElements = 200000;
/// Relative to the spread of the values, and to their size.
constexpr double kLargestJump = 1e-7;
constexpr double kRounding = 1e-12;

/// Which faces of its shape a vertex lies on, one bit each.
unsigned FacesOf(Shape shape, const Vec3& v)
{
  const bool prism = shape == Shape::Prism;
  const std::array<bool, 7> onFace{ v.x == -1.0, v.y == -1.0, v.z == -1.0,
    shape == Shape::Hexahedron && v.x == 1.0, (prism || shape == Shape::Hexahedron) && v.y == 1.0,
    shape == Shape::Hexahedron
      ? v.z == 1.0
      : (shape == Shape::Tetrahedron ? v.x + v.y + v.z == -1.0 : v.x + v.z == 0.0),
    shape == Shape::Pyramid && v.y + v.z == 0.0 };
  unsigned faces = 0;
  for (std::size_t i = 0; i < onFace.size(); ++i)
  {
    faces |= onFace[i] ? 1U << i : 0U;
  }
  return faces;
}

/// Vertices, middles of edges and centroids of faces: the points of a face that are the same seen
/// from both sides, however the elements are turned.
std::vector<Vec3> MeetingPoints(Shape shape)
{
  std::vector<Vec3> points;
  std::vector<unsigned> facesOf;
  for (unsigned i = 0; i < 8; ++i)
  {
    const auto sign = [i](unsigned bit) { return (i & bit) != 0 ? 1.0 : -1.0; };
    const Vec3 vertex = TensorToReference(shape, { sign(1), sign(2), sign(4) });
    if (std::find(points.begin(), points.end(), vertex) == points.end())
    {
      points.push_back(vertex);
      facesOf.push_back(FacesOf(shape, vertex));
    }
  }
  const std::size_t vertices = points.size();
  for (std::size_t a = 0; a < vertices; ++a)
  {
    for (std::size_t b = a + 1; b < vertices; ++b)
    {
      if (std::popcount(facesOf[a] & facesOf[b]) >= 2)
      {
        points.push_back(0.5 * (points[a] + points[b]));
      }
    }
  }
  for (unsigned face = 1; face < (1U << 7); face <<= 1)
  {
    Vec3 sum(0.0);
    double count = 0.0;
    for (std::size_t a = 0; a < vertices; ++a)
    {
      if ((facesOf[a] & face) != 0)
      {
        sum += points[a];
        count += 1.0;
      }
    }
    if (count > 0.0)
    {
      points.push_back(sum / count);
    }
  }
  return points;
}

/// Points that elements put at the same place: for each point the first of them, itself if there
/// is none. Places nearer than a quarter of `cell` are the same.
std::vector<std::size_t> MatchPoints(std::span<const Vec3> points, double cell)
{
  using Key = std::array<double, 3>;
  const auto hash = [](const Key& key) { return XXH3_64bits(key.data(), sizeof(key)); };
  // The sum with 0 makes the two zeros, which are equal, one to the hash too.
  const auto keyOf = [](const Vec3& v) -> Key {
    return { std::floor(v.x) + 0.0, std::floor(v.y) + 0.0, std::floor(v.z) + 0.0 };
  };
  std::unordered_map<Key, std::size_t, decltype(hash)> firstIn(2 * points.size(), hash);
  std::vector<std::size_t> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3 scaled = points[i] / cell;
    first[i] = i;
    for (unsigned side = 0; side < 8 && first[i] == i; ++side)
    {
      const auto shift = [side](unsigned bit) { return (side & bit) != 0 ? 0.25 : -0.25; };
      const auto found = firstIn.find(keyOf(scaled + Vec3(shift(1), shift(2), shift(4))));
      if (found != firstIn.end())
      {
        const Vec3 apart = points[found->second] - points[i];
        const double distance =
          std::max({ std::abs(apart.x), std::abs(apart.y), std::abs(apart.z) });
        first[i] = distance <= cell / 4 ? found->second : i;
      }
    }
    if (first[i] == i)
    {
      firstIn.emplace(keyOf(scaled), i);
    }
  }
  return first;
}

/// How far apart the same place may be in two elements: what rounding of the file's coordinates
/// explains.
double MatchingCell(const Mesh& mesh, int elements)
{
  double cell = 0.0;
  for (std::size_t e = 0; e < static_cast<std::size_t>(elements); ++e)
  {
    cell = std::max(cell, 16.0 * mesh.uncertainty[e] + 1e-10 * mesh.size[e]);
  }
  return cell;
}

void Compare(std::span<const double> here, std::span<const double> there, Continuity& continuity)
{
  for (std::size_t c = 0; c < here.size(); ++c)
  {
    if (std::isfinite(here[c]) && std::isfinite(there[c]))
    {
      ++continuity.comparisons;
      continuity.largestJump = std::max(continuity.largestJump, std::abs(here[c] - there[c]));
      continuity.lowest = std::min({ continuity.lowest, here[c], there[c] });
      continuity.highest = std::max({ continuity.highest, here[c], there[c] });
    }
  }
}
} // namespace

bool Continuity::IsContinuous() const
{
  return largestJump <= kLargestJump * (highest - lowest) +
    kRounding * std::max({ std::abs(highest), std::abs(lowest), size });
}

std::vector<Continuity> CompareAcrossElements(const Mesh& mesh, std::span<const Field> fields)
{
  const int elements = std::min(mesh.Elements(), kMaxElements);
  std::array<std::vector<Vec3>, kShapeCount> pointsOf;
  for (int shape = 0; shape < kShapeCount; ++shape)
  {
    pointsOf[static_cast<std::size_t>(shape)] = MeetingPoints(static_cast<Shape>(shape));
  }
  const auto xiOf = [&](int e) -> const std::vector<Vec3>&
  { return pointsOf[static_cast<std::size_t>(mesh.ShapeOf(e))]; };
  std::vector<std::size_t> begin{ 0 };
  for (int e = 0; e < elements; ++e)
  {
    begin.push_back(begin.back() + xiOf(e).size());
  }

  std::vector<Vec3> points(begin.back());
  const auto of = [&begin](auto& all, int e, int components)
  {
    const auto width = static_cast<std::size_t>(components);
    const auto index = static_cast<std::size_t>(e);
    return std::span(all).subspan(width * begin[index], width * (begin[index + 1] - begin[index]));
  };
  tbb::parallel_for(0, elements, [&](int e) { MapForward(mesh, e, xiOf(e), of(points, e, 1)); });
  const std::vector<std::size_t> first = MatchPoints(points, MatchingCell(mesh, elements));

  std::vector<Continuity> result(fields.size());
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    const int components = fields[f].values.components;
    const auto width = static_cast<std::size_t>(components);
    std::vector<double> values(width * points.size());
    tbb::parallel_for(0, elements,
      [&](int e) { EvaluateAt(mesh, fields[f], e, xiOf(e), of(values, e, components), {}); });
    const auto at = [&](std::size_t i) { return std::span(values).subspan(i * width, width); };
    if (fields[f].mapping == Mapping::Identity)
    {
      for (const double c : fields[f].values.coefficients)
      {
        result[f].size = std::isfinite(c) ? std::max(result[f].size, std::abs(c)) : result[f].size;
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (first[i] != i)
      {
        Compare(at(i), at(first[i]), result[f]);
      }
    }
  }
  return result;
}
} // namespace pixelexact
