// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Locator.h"
#include "Core/Location/PointBudget.h"
#include "Core/Location/PointKernels.h"
#include "Core/Location/RootCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// The result of Newton's iteration for a point in an element whose map is injective.
struct FastAnswer
{
  bool decided = false;
  bool inside = false;
  Vec3 xi{ std::numeric_limits<double>::quiet_NaN() }; ///< the root, where the iteration converged
};

/// Whether some xi of the shape might map to x. False is a proof that none does.
bool MightContain(const InverseProblem& problem, const ElementBounds& bounds, const Vec3& x)
{
  double lanes[3][kLanePadding];
  double selected[3][2 * kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(lanes[d], kLanePadding, x[d]);
  }
  double* const to[3] = { selected[0], selected[1], selected[2] };
  int index[kLanePadding];
  return GetPointKernels().select(bounds, problem, { { lanes[0], lanes[1], lanes[2] }, 1 },
           { 0, 1, 1, { x, x } }, false, to, index) != 0;
}

FastAnswer AskNewton(const InverseProblem& problem, const ElementBounds& bounds, const Vec3& x)
{
  double lanes[9][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(lanes[d], kLanePadding, x[d]);
  }
  const InverseResult result{ { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], lanes[8] };
  KernelsFor(problem.space).invert(problem, { { lanes[0], lanes[1], lanes[2] }, 1 }, result);
  FastAnswer answer;
  if (lanes[6][0] == static_cast<double>(NewtonStatus::NotConverged))
  {
    return answer;
  }
  answer.xi = { lanes[3][0], lanes[4][0], lanes[5][0] };
  answer.inside = lanes[6][0] == static_cast<double>(NewtonStatus::RootInside);
  // The map is injective in this region, so the root is the only one.
  answer.decided = bounds.injectiveMargin > 0.0 && lanes[7][0] >= -bounds.injectiveMargin;
  return answer;
}

/// Whether a xi of the shape belongs to the mesh: beneath a surface in space there is nothing.
bool IsOfMesh(const Mesh& mesh, const InverseProblem& problem, const Vec3& xi)
{
  return !mesh.isShell || IsOnShell(problem, xi);
}
} // namespace

void Locator::LocateAll(std::span<const Vec3> points, PreimageSink& sink) const
{
  struct Doubt
  {
    int element;
    Vec3 known;
  };
  std::vector<int> candidates;
  std::vector<Doubt> doubts;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3& x = points[i];
    const int index = static_cast<int>(i);
    if (!Bounds().Contains(x))
    {
      continue;
    }
    doubts.clear();
    index_.FindNear({ x, x }, candidates);
    for (const int element : candidates)
    {
      const ElementBounds& bounds = index_.BoundsOf(element);
      const InverseProblem problem = MakeInverseProblem(GetMesh(), element, bounds);
      if (!MightContain(problem, bounds, x))
      {
        continue;
      }
      const FastAnswer fast = AskNewton(problem, bounds, x);
      if (!fast.decided)
      {
        doubts.push_back(
          { element, fast.inside ? Vec3(std::numeric_limits<double>::quiet_NaN()) : fast.xi });
      }
      else if (fast.inside && IsOfMesh(GetMesh(), problem, fast.xi))
      {
        sink.Found(index, { element, fast.xi, IsOnFace(problem, fast.xi) });
      }
    }
    PointBudget budget(static_cast<int>(doubts.size()));
    PointBudget* const itsBudget = &budget;
    for (const auto& [element, known] : doubts)
    {
      SoughtPoint sought{ x, known };
      Preimages all;
      FindWithin(*index_.TreeOf(element), std::span(&sought, 1), std::span(&itsBudget, 1),
        Wanted::All, std::span(&all, 1));
      const InverseProblem problem =
        MakeInverseProblem(GetMesh(), element, index_.BoundsOf(element));
      for (const InverseRoot& root : all.roots)
      {
        if (IsOfMesh(GetMesh(), problem, root.xi))
        {
          sink.Found(index, { element, root.xi, root.onFace });
        }
      }
      if (!all.complete)
      {
        sink.Undecided(index, element);
      }
    }
  }
}
} // namespace pixelexact
