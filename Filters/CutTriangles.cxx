// SPDX-License-Identifier: BSD-3-Clause
#include "CutTriangles.h"

#include "Core/Base/Counted.h"
#include "FreeMemory.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr int kCoarse = 32;
constexpr const char* kRemedy = "lower the resolution";
/// Of three numbers each, two to a point.
constexpr double kBytesOfTriangles = 48.0;

double Longest(const Vec3& sides)
{
  return std::max({ sides.x, sides.y, sides.z });
}

/// Where a plane crosses the edges of a box.
std::vector<Vec3> CrossingsOf(const Vec3& point, const Vec3& normal, const Box3& box)
{
  std::vector<Vec3> crossings;
  const auto corner = [&box](int c)
  {
    return Vec3((c & 1) != 0 ? box.upper.x : box.lower.x, (c & 2) != 0 ? box.upper.y : box.lower.y,
      (c & 4) != 0 ? box.upper.z : box.lower.z);
  };
  for (int a = 0; a < 8; ++a)
  {
    for (int side = 1; side < 8; side *= 2)
    {
      const Vec3 p = corner(a);
      const Vec3 q = corner(a | side);
      const double atP = glm::dot(normal, p - point);
      const double atQ = glm::dot(normal, q - point);
      if ((a & side) == 0 && (atP <= 0.0) != (atQ <= 0.0))
      {
        crossings.push_back(p + (q - p) * (atP / (atP - atQ)));
      }
    }
  }
  return crossings;
}

CutTriangles PlaneGrid(
  const QuadricForm& form, const Box3& box, int resolution, double bytesPerPoint)
{
  const double length = glm::length(form.g);
  const Vec3 normal = form.g / length;
  const Vec3 point = form.origin - normal * (form.c / length);
  // The axis that is most nearly in the plane leads one way.
  const Vec3 slant = glm::abs(normal);
  const int axis = slant.x <= slant.y && slant.x <= slant.z ? 0 : (slant.y <= slant.z ? 1 : 2);
  Vec3 along(0.0);
  along[axis] = 1.0;
  const Vec3 u = glm::normalize(along - normal * normal[axis]);
  const Vec3 v = glm::cross(normal, u);

  CutTriangles cut;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double lower[2] = { kInfinity, kInfinity };
  double upper[2] = { -kInfinity, -kInfinity };
  for (const Vec3& x : CrossingsOf(point, normal, box))
  {
    const double at[2] = { glm::dot(u, x - point), glm::dot(v, x - point) };
    for (int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], at[d]);
      upper[d] = std::max(upper[d], at[d]);
    }
  }
  const double sides[2] = { upper[0] - lower[0], upper[1] - lower[1] };
  const double longest = std::max(sides[0], sides[1]);
  if (!(longest > 0.0))
  {
    return cut;
  }
  std::int64_t n[2];
  for (int d = 0; d < 2; ++d)
  {
    n[d] = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::ceil(resolution * (sides[d] / longest) - 1e-9)));
  }
  const double points = static_cast<double>(n[0] + 1) * static_cast<double>(n[1] + 1);
  RequireMemory(points * (sizeof(Vec3) + kBytesOfTriangles + bytesPerPoint),
    Counted(n[0] * n[1], "square") + " on the plane", kRemedy);
  cut.points.reserve(static_cast<std::size_t>(points));
  for (std::int64_t j = 0; j <= n[1]; ++j)
  {
    for (std::int64_t i = 0; i <= n[0]; ++i)
    {
      const double s = lower[0] + sides[0] * static_cast<double>(i) / static_cast<double>(n[0]);
      const double t = lower[1] + sides[1] * static_cast<double>(j) / static_cast<double>(n[1]);
      cut.points.push_back(point + u * s + v * t);
    }
  }
  cut.triangles.reserve(static_cast<std::size_t>(2 * n[0] * n[1]));
  for (std::int64_t j = 0; j < n[1]; ++j)
  {
    for (std::int64_t i = 0; i < n[0]; ++i)
    {
      const std::int64_t a = j * (n[0] + 1) + i;
      const std::int64_t b = a + n[0] + 1;
      cut.triangles.push_back({ a, a + 1, b + 1 });
      cut.triangles.push_back({ a, b + 1, b });
    }
  }
  return cut;
}

/// A box cut into cubes.
struct Cubes
{
  Vec3 origin;
  double side;
  int n[3]; ///< nodes each way

  Cubes(const Box3& box, double newSide)
    : origin(box.lower)
    , side(newSide)
    , n{}
  {
    for (int d = 0; d < 3; ++d)
    {
      n[d] = 2 + static_cast<int>((box.upper[d] - box.lower[d]) / side);
    }
  }
  [[nodiscard]] std::size_t Nodes() const
  {
    return static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
      static_cast<std::size_t>(n[2]);
  }
  [[nodiscard]] Vec3 At(const Vec3& place) const { return origin + side * place; }
};

/// At the nodes, in VTK's order; empty where it was aborted.
vtkSmartPointer<vtkDoubleArray> Sample(
  const CutFunction& cut, const Cubes& cubes, const StepProgress& progress)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName("S");
  values->SetNumberOfValues(static_cast<vtkIdType>(cubes.Nodes()));
  double* value = values->GetPointer(0);
  const auto row = [&](std::size_t r)
  {
    const auto across = static_cast<std::size_t>(cubes.n[0]);
    const auto j = static_cast<double>(r % static_cast<std::size_t>(cubes.n[1]));
    const auto k = static_cast<double>(r / static_cast<std::size_t>(cubes.n[1]));
    for (std::size_t i = 0; i < across; ++i)
    {
      value[r * across + i] = cut.Value(cubes.At({ static_cast<double>(i), j, k }));
    }
  };
  const std::size_t rows =
    static_cast<std::size_t>(cubes.n[1]) * static_cast<std::size_t>(cubes.n[2]);
  const bool done = cut.NeedsCallingThread() ? SerialSteps(rows, progress, row)
                                             : ParallelSteps(rows, progress, row);
  return done ? values : nullptr;
}

/// About the cubes through which the surface goes, as far as their corners tell.
Box3 SeenIn(const Cubes& cubes, const vtkDoubleArray* values, const Box3& all)
{
  const auto at = [&](int i, int j, int k)
  {
    return values->GetValue(
      (static_cast<vtkIdType>(k) * cubes.n[1] + j) * static_cast<vtkIdType>(cubes.n[0]) + i);
  };
  Box3 seen{ all.upper, all.lower };
  for (int k = 0; k + 1 < cubes.n[2]; ++k)
  {
    for (int j = 0; j + 1 < cubes.n[1]; ++j)
    {
      for (int i = 0; i + 1 < cubes.n[0]; ++i)
      {
        int below = 0;
        for (int c = 0; c < 8; ++c)
        {
          below += at(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2)) <= 0.0 ? 1 : 0;
        }
        if (below != 0 && below != 8)
        {
          const Vec3 p(i, j, k);
          seen.lower = glm::min(seen.lower, cubes.At(p - 1.0));
          seen.upper = glm::max(seen.upper, cubes.At(p + 2.0));
        }
      }
    }
  }
  if (seen.lower.x > seen.upper.x)
  {
    return all;
  }
  return { glm::max(seen.lower, all.lower), glm::min(seen.upper, all.upper) };
}

CutTriangles Marched(const CutFunction& cut, const Box3& box, int resolution, double bytesPerPoint,
  const StepProgress& progress)
{
  CutTriangles result;
  const double side = Longest(box.upper - box.lower) / resolution;
  Box3 part = box;
  if (resolution > kCoarse)
  {
    const Cubes coarse(box, Longest(box.upper - box.lower) / kCoarse);
    const auto values = Sample(cut, coarse, {});
    part = SeenIn(coarse, values, box);
  }
  const Cubes cubes(part, side);
  const auto nodes = static_cast<double>(cubes.Nodes());
  RequireMemory(nodes * 9.0, Counted(cubes.Nodes(), "sample") + " of the cut function", kRemedy);
  const auto values = Sample(cut, cubes, progress);
  if (values == nullptr)
  {
    result.aborted = true;
    return result;
  }
  // In units of the cubes: marching leaves floats.
  vtkNew<vtkImageData> image;
  image->SetDimensions(cubes.n);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> marching;
  marching->SetInputData(image);
  marching->SetValue(0, 0.0);
  marching->ComputeNormalsOff();
  marching->ComputeScalarsOff();
  marching->Update();
  vtkPolyData* output = marching->GetOutput();
  const auto count = static_cast<std::size_t>(output->GetNumberOfPoints());
  RequireMemory(static_cast<double>(count) * (sizeof(Vec3) + kBytesOfTriangles + bytesPerPoint),
    Counted(output->GetNumberOfPolys(), "triangle"), kRemedy);
  result.points.resize(count);
  std::atomic<std::int64_t> off{ 0 };
  const auto project = [&](std::size_t i)
  {
    Vec3 place;
    // The points' array, which reading from several threads does not touch.
    output->GetPoints()->GetData()->GetTuple(static_cast<vtkIdType>(i), glm::value_ptr(place));
    Vec3& x = result.points[i];
    x = cubes.At(place);
    if (!BringOntoSurface(cut, 2.0 * side, x))
    {
      ++off;
    }
  };
  result.aborted = !(
    cut.NeedsCallingThread() ? SerialSteps(count, {}, project) : ParallelSteps(count, {}, project));
  result.offSurface = off;
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(output->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(corners, ids);
    result.triangles.push_back({ ids[0], ids[1], ids[2] });
  }
  return result;
}
} // namespace

bool BringOntoSurface(const CutFunction& cut, double reach, Vec3& x)
{
  constexpr int kMostSteps = 50;
  Vec3 at = x;
  for (int i = 0; i < kMostSteps; ++i)
  {
    const double value = cut.Value(at);
    const Vec3 gradient = cut.Gradient(at);
    const Vec3 step = gradient * (value / glm::dot(gradient, gradient));
    if (value == 0.0 || glm::length(step) <= 1e-15 * reach)
    {
      break;
    }
    at -= step;
    if (!(glm::distance(at, x) <= reach))
    {
      return false;
    }
    // Rounding of far coordinates lets steps become no smaller than this.
    if (glm::length(step) <= 4e-16 * Longest(glm::abs(at)))
    {
      break;
    }
  }
  x = at;
  return true;
}

CutTriangles TriangulateCut(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress)
{
  if (!(box.lower.x <= box.upper.x) || !(Longest(box.upper - box.lower) > 0.0))
  {
    return {};
  }
  const QuadricForm* form = cut.Quadric();
  return form != nullptr && form->IsPlane()
    ? PlaneGrid(*form, box, resolution, bytesPerPoint)
    : Marched(cut, box, resolution, bytesPerPoint, progress);
}
} // namespace pixelexact
