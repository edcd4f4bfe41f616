// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/CutTriangles.h"

#include "Core/Base/Counted.h"
#include "Grids/FilterWork.h"

#include "vtkMarchingCubesTriangleCases.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
namespace
{
/// Cubes along the longest side of the coarsest level.
constexpr int kMaxAtOnce = 64;
/// Cubes whose corners are evaluated in one call. The first number is for functions that only the
/// calling thread may evaluate and whose calls have overhead, the second for all others.
constexpr std::size_t kCubesAtOnce = 2048;
constexpr std::size_t kCubesPerTask = 64;

template <class T>
std::span<T> Part(std::vector<T>& all, std::size_t begin, std::size_t end)
{
  return std::span(all).subspan(begin, end - begin);
}

struct Place
{
  int x[3];
};

/// Corners of a cube, in the order of VTK's cases.
constexpr int kCorners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
/// Edges of a cube: lower corner and axis.
constexpr int kEdges[12][2] = { { 0, 0 }, { 1, 1 }, { 3, 0 }, { 0, 1 }, { 4, 0 }, { 5, 1 },
  { 7, 0 }, { 4, 1 }, { 0, 2 }, { 1, 2 }, { 3, 2 }, { 2, 2 } };

/// Cubes of one size.
struct CubeGrid
{
  Vec3 origin;
  double side;

  [[nodiscard]] Vec3 At(const Place& p) const
  {
    return origin + side * Vec3(p.x[0], p.x[1], p.x[2]);
  }
};

class Marcher
{
public:
  Marcher(const CutFunction& cut, const Box3& box, int resolution)
    : Cut(cut)
  {
    int coarse = resolution;
    while (coarse > kMaxAtOnce)
    {
      coarse = (coarse + 1) / 2;
      ++Subdivisions;
    }
    const Vec3 sides = box.upper - box.lower;
    const double side = std::max({ sides.x, sides.y, sides.z }) / coarse;
    Cells = { box.lower, side };
    int n[3];
    for (int d = 0; d < 3; ++d)
    {
      n[d] = std::max(1, static_cast<int>(std::ceil(sides[d] / side - 1e-9)));
      Nodes[d] = (std::int64_t{ n[d] } << Subdivisions) + 1;
    }
    for (int k = 0; k < n[2]; ++k)
    {
      for (int j = 0; j < n[1]; ++j)
      {
        for (int i = 0; i < n[0]; ++i)
        {
          Active.push_back({ { i, j, k } });
        }
      }
    }
    if (const ImplicitPolynomial* form = cut.Polynomial(); form != nullptr && form->Degree() <= 2)
    {
      IsQuadric = true;
      for (const double q : form->a.q)
      {
        Bend += std::fabs(q);
      }
    }
  }

  CutTriangles March(double bytesPerPoint, const StepProgress& progress)
  {
    CutTriangles result;
    for (int h = 0; h <= Subdivisions; ++h)
    {
      const StepProgress part = [&](double done)
      { return !progress || progress((h + done) / (Subdivisions + 2)); };
      // A surface crosses about 4 times as many cubes at each further level.
      const double later = std::pow(4.0, Subdivisions - h);
      if (!Keep(part))
      {
        result.aborted = true;
        return result;
      }
      const double cubes = later * static_cast<double>(Active.size());
      RequireMemory(cubes * (sizeof(Place) + sizeof(Triangle) + bytesPerPoint),
        Counted(static_cast<std::int64_t>(cubes), "cube") + " about the surface",
        "lower the resolution");
      if (h < Subdivisions)
      {
        Subdivide();
      }
    }
    Fill(result, progress);
    return result;
  }

private:
  /// The keys of its corners. A key holds the lower node and the axis of an edge.
  using Triangle = std::array<std::int64_t, 3>;

  /// Calls work(begin, end) for ranges of `count` items.
  template <class Work>
  bool ForAll(std::size_t count, const StepProgress& progress, const Work& work) const
  {
    const bool alone = Cut.NeedsCallingThread();
    return BatchedSteps(count, alone ? kCubesAtOnce : kCubesPerTask, alone, progress, work);
  }

  /// Marks the cubes that may contain the surface.
  void MayHold(std::span<const Place> cubes, std::span<std::uint8_t> held) const
  {
    std::vector<Vec3> centres(cubes.size());
    std::ranges::transform(
      cubes, centres.begin(), [this](const Place& p) { return Cells.At(p) + 0.5 * Cells.side; });
    std::vector<double> values(cubes.size());
    std::vector<Vec3> gradients(cubes.size());
    Cut.Values(centres, values);
    Cut.Gradients(centres, gradients);
    const double reach = 0.5 * std::sqrt(3.0) * Cells.side;
    std::vector<std::size_t> far;
    std::vector<Place> farCubes;
    for (std::size_t i = 0; i < cubes.size(); ++i)
    {
      const double most =
        reach * (glm::length(gradients[i]) * (IsQuadric ? 1.0 : 3.0) + reach * Bend);
      // The factor covers rounding. A cube with NaN stays marked.
      held[i] = std::fabs(values[i]) > 1.000001 * most ? 0 : 1;
      if (held[i] == 0 && !IsQuadric)
      {
        far.push_back(i);
        farCubes.push_back(cubes[i]);
      }
    }
    std::vector<std::uint8_t> cases(far.size());
    CasesOf(farCubes, cases);
    for (std::size_t k = 0; k < far.size(); ++k)
    {
      held[far[k]] = cases[k] % 255 != 0 ? 1 : 0;
    }
  }

  bool Keep(const StepProgress& progress)
  {
    std::vector<std::uint8_t> kept(Active.size());
    if (!ForAll(Active.size(), progress,
          [&](std::size_t begin, std::size_t end)
          { MayHold(Part(Active, begin, end), Part(kept, begin, end)); }))
    {
      return false;
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < Active.size(); ++i)
    {
      if (kept[i] != 0)
      {
        Active[next++] = Active[i];
      }
    }
    Active.resize(next);
    return true;
  }

  void Subdivide()
  {
    std::vector<Place> children;
    children.reserve(8 * Active.size());
    for (const Place& p : Active)
    {
      for (const auto& corner : kCorners)
      {
        children.push_back(
          { { 2 * p.x[0] + corner[0], 2 * p.x[1] + corner[1], 2 * p.x[2] + corner[2] } });
      }
    }
    Active = std::move(children);
    Cells.side /= 2.0;
  }

  /// Computes each cube's case: one bit per corner on the positive side.
  void CasesOf(std::span<const Place> cubes, std::span<std::uint8_t> cases) const
  {
    std::vector<Vec3> corners;
    corners.reserve(8 * cubes.size());
    for (const Place& p : cubes)
    {
      for (const auto& corner : kCorners)
      {
        corners.push_back(
          Cells.At({ { p.x[0] + corner[0], p.x[1] + corner[1], p.x[2] + corner[2] } }));
      }
    }
    std::vector<double> values(corners.size());
    Cut.Values(corners, values);
    for (std::size_t i = 0; i < cubes.size(); ++i)
    {
      int index = 0;
      for (std::size_t c = 0; c < 8; ++c)
      {
        index |= values[8 * i + c] >= 0.0 ? 1 << c : 0;
      }
      cases[i] = static_cast<std::uint8_t>(index);
    }
  }

  [[nodiscard]] std::int64_t KeyOf(const Place& p, int edge) const
  {
    const auto& corner = kCorners[kEdges[edge][0]];
    const std::int64_t node =
      ((std::int64_t{ p.x[2] } + corner[2]) * Nodes[1] + p.x[1] + corner[1]) * Nodes[0] + p.x[0] +
      corner[0];
    return 3 * node + kEdges[edge][1];
  }

  /// Computes the points on the edges of `keys` where linear interpolation is 0.
  void PointsOf(std::span<const std::int64_t> keys, std::span<Vec3> points) const
  {
    std::vector<Vec3> ends;
    ends.reserve(2 * keys.size());
    for (const std::int64_t key : keys)
    {
      const std::int64_t node = key / 3;
      Place p{ { static_cast<int>(node % Nodes[0]), static_cast<int>(node / Nodes[0] % Nodes[1]),
        static_cast<int>(node / Nodes[0] / Nodes[1]) } };
      ends.push_back(Cells.At(p));
      ++p.x[key % 3];
      ends.push_back(Cells.At(p));
    }
    std::vector<double> values(ends.size());
    Cut.Values(ends, values);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      const Vec3& a = ends[2 * i];
      const double part = values[2 * i] / (values[2 * i] - values[2 * i + 1]);
      points[i] = a + (part >= 0.0 && part <= 1.0 ? part : 0.5) * (ends[2 * i + 1] - a);
    }
  }

  void Fill(CutTriangles& result, const StepProgress& progress)
  {
    std::vector<std::uint8_t> cases(Active.size());
    const StepProgress part = [&](double done)
    { return !progress || progress((Subdivisions + 1 + done) / (Subdivisions + 2)); };
    result.aborted = !ForAll(Active.size(), part,
      [&](std::size_t begin, std::size_t end)
      { CasesOf(Part(Active, begin, end), Part(cases, begin, end)); });
    if (result.aborted)
    {
      return;
    }
    const vtkMarchingCubesTriangleCases* table = vtkMarchingCubesTriangleCases::GetCases();
    std::vector<std::int64_t> keys;
    for (std::size_t i = 0; i < Active.size(); ++i)
    {
      for (const int* edge = table[cases[i]].edges; edge[0] >= 0; edge += 3)
      {
        result.triangles.push_back(
          { KeyOf(Active[i], edge[0]), KeyOf(Active[i], edge[1]), KeyOf(Active[i], edge[2]) });
        keys.insert(keys.end(), result.triangles.back().begin(), result.triangles.back().end());
      }
    }
    tbb::parallel_sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    result.points.resize(keys.size());
    std::atomic<std::int64_t> off{ 0 };
    result.aborted = !ForAll(keys.size(), {},
      [&](std::size_t begin, std::size_t end)
      {
        const auto points = Part(result.points, begin, end);
        PointsOf(Part(keys, begin, end), points);
        const std::vector<double> reach(points.size(), 2.0 * Cells.side);
        off += BringOntoSurface(Cut, reach, points);
      });
    result.offSurface = off;
    for (Triangle& triangle : result.triangles)
    {
      for (std::int64_t& corner : triangle)
      {
        corner = std::lower_bound(keys.begin(), keys.end(), corner) - keys.begin();
      }
    }
  }

  const CutFunction& Cut;
  CubeGrid Cells;
  int Subdivisions = 0;
  std::int64_t Nodes[3] = { 0, 0, 0 }; ///< of the smallest cubes
  std::vector<Place> Active;
  bool IsQuadric = false;
  double Bend = 0.0; ///< of a quadric: the second-order part is at most this times a square
};
} // namespace

CutTriangles MarchCubes(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress)
{
  return Marcher(cut, box, resolution).March(bytesPerPoint, progress);
}
} // namespace pixelexact
