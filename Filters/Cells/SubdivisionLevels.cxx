// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Subdivision.h"

#include "Cells/LevelLattice.h"
#include "Core/Location/Locator.h"

#include "vtkCellType.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Points of a lattice between which linear cells are judged: `of` each, their mean in xi.
struct Middles
{
  std::vector<Vec3> xi;
  std::vector<std::vector<int>> of;
};

Middles MakeMiddles(const ShapeLattice& lattice)
{
  Middles middles;
  const auto add = [&](std::vector<int> corners)
  {
    Vec3 sum(0.0);
    for (const int corner : corners)
    {
      sum += lattice.points[static_cast<std::size_t>(corner)];
    }
    middles.xi.push_back(sum / static_cast<double>(corners.size()));
    middles.of.push_back(std::move(corners));
  };
  for (std::size_t cell = 0; cell < lattice.Cells(); ++cell)
  {
    const std::span<const int> corners = lattice.Corners(cell);
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      add({ corners[k], corners[(k + 1) % corners.size()] });
    }
    const std::size_t base = lattice.types[cell] == VTK_PYRAMID ? 4 : corners.size();
    add({ corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(base) });
  }
  return middles;
}

const Middles& MiddlesOf(Shape shape, int level)
{
  static PerLevel<Middles> all;
  return all.Get(shape, level, [&] { return MakeMiddles(LatticeOf(shape, level)); });
}

/// How far values at middles are from the means of those of their corners, at most.
double LargestMiss(const Mesh& mesh, const Field* field, int element, int level)
{
  const Shape shape = mesh.ShapeOf(element);
  const Middles& middles = MiddlesOf(shape, level);
  const int components = field != nullptr ? field->values.components : 3;
  const auto n = static_cast<std::size_t>(components);
  const auto corners = ValuesAt(mesh, field, element, LatticeOf(shape, level).points, components);
  const auto exact = ValuesAt(mesh, field, element, middles.xi, components);
  double largest = 0.0;
  for (std::size_t m = 0; m < middles.of.size(); ++m)
  {
    for (std::size_t c = 0; c < n; ++c)
    {
      double sum = 0.0;
      for (const int corner : middles.of[m])
      {
        sum += corners[static_cast<std::size_t>(corner) * n + c];
      }
      const double miss =
        std::fabs(exact[m * n + c] - sum / static_cast<double>(middles.of[m].size()));
      // What is no number is never near enough.
      largest = miss <= largest ? largest : miss;
    }
  }
  return largest;
}

/// Of all components, over the nodes of level 1; the widest.
double RangeOf(const Mesh& mesh, const Field& field)
{
  const auto n = static_cast<std::size_t>(field.values.components);
  std::vector<double> lower(n, std::numeric_limits<double>::infinity());
  std::vector<double> upper(n, -std::numeric_limits<double>::infinity());
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const auto& points = LatticeOf(mesh.ShapeOf(e), 1).points;
    const auto values = ValuesAt(mesh, &field, e, points, field.values.components);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      lower[i % n] = std::min(lower[i % n], values[i]);
      upper[i % n] = std::max(upper[i % n], values[i]);
    }
  }
  double widest = 0.0;
  for (std::size_t c = 0; c < n; ++c)
  {
    widest = std::max(widest, upper[c] - lower[c]);
  }
  return widest;
}
} // namespace

SubdivisionLevels UniformLevels(const HighOrderModel& model, int level)
{
  return { std::vector<std::uint8_t>(static_cast<std::size_t>(model.GetMesh().Elements()),
             static_cast<std::uint8_t>(level)),
    0, false };
}

SubdivisionLevels AdaptedLevels(const HighOrderModel& model,
  const std::vector<const Field*>& fields, double tolerance, int most, const StepProgress& progress)
{
  const Mesh& mesh = model.GetMesh();
  const Box3& box = model.GetLocator().Bounds();
  const double length = tolerance * glm::length(box.upper - box.lower);
  std::vector<double> allowed(fields.size());
  std::ranges::transform(
    fields, allowed.begin(), [&](const Field* field) { return tolerance * RangeOf(mesh, *field); });
  SubdivisionLevels levels = UniformLevels(model, most);
  std::atomic<std::int64_t> coarse{ 0 };
  const auto isFine = [&](int element, int level)
  {
    if (!(LargestMiss(mesh, nullptr, element, level) <= length))
    {
      return false;
    }
    for (std::size_t f = 0; f < fields.size(); ++f)
    {
      if (!(LargestMiss(mesh, fields[f], element, level) <= allowed[f]))
      {
        return false;
      }
    }
    return true;
  };
  levels.aborted = !ParallelSteps(levels.ofElement.size(), progress,
    [&](std::size_t e)
    {
      int level = 0;
      while (level < most && !isFine(static_cast<int>(e), level))
      {
        ++level;
      }
      levels.ofElement[e] = static_cast<std::uint8_t>(level);
      if (level == most && !isFine(static_cast<int>(e), level))
      {
        ++coarse;
      }
    });
  levels.coarse = coarse;
  return levels;
}
} // namespace pixelexact
