// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Locator.h"

#include "Core/Location/ElementBounds.h"
#include "Core/Location/EmbreeBvh.h"
#include "Core/Location/InversionTrees.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace pixelexact
{
namespace
{
/// A cluster of more points than this is split when it meets more candidates than the next
/// constant: a query costs about as much as testing a few hundred pairs.
constexpr std::size_t kSmallCluster = 8;
constexpr std::size_t kManyCandidates = 12;

Vec3 CentreOf(const Mesh& mesh, int element)
{
  const double* c = &mesh.centre[3 * static_cast<std::size_t>(element)];
  return { c[0], c[1], c[2] };
}

/// Padded coordinate arrays for the kernels.
class LaneArrays
{
public:
  explicit LaneArrays(std::size_t points)
    : Stride(static_cast<std::size_t>(PaddedCount(static_cast<int>(points))))
    , Storage(9 * Stride)
  {
  }
  double* operator[](int array) { return &Storage[static_cast<std::size_t>(array) * Stride]; }

private:
  std::size_t Stride;
  std::vector<double> Storage;
};
} // namespace

/// The work on one batch of points.
class Locator::Batch
{
public:
  Batch(const Locator& locator, std::span<const Vec3> points, LocationSink& sink)
    : Owner(locator)
    , TheMesh(locator.TheMesh)
    , Points(points)
    , Sink(sink)
    , Lanes(points.size())
  {
  }

  void Run()
  {
    std::vector<int> indices;
    indices.reserve(Points.size());
    for (std::size_t i = 0; i < Points.size(); ++i)
    {
      if (Owner.MeshBounds.Contains(Points[i]))
      {
        indices.push_back(static_cast<int>(i));
      }
    }
    if (!indices.empty())
    {
      Cluster(indices);
    }
    auto& counters = Owner.TheCounters;
    counters.queries += Queries;
    counters.candidates += Candidates;
    counters.careful += Careful;
    counters.unknown += Unknown;
    int most = counters.mostBoxes;
    while (most < MostBoxes && !counters.mostBoxes.compare_exchange_weak(most, MostBoxes))
    {
    }
  }

private:
  struct Doubt
  {
    int index;
    int element;
    Vec3 root; ///< where Newton converged to, outside of the shape; NaN where it did not
  };

  void Cluster(std::span<int> indices)
  {
    Box3 region{ Points[indices[0]], Points[indices[0]] };
    for (const int i : indices)
    {
      region.lower = glm::min(region.lower, Points[i]);
      region.upper = glm::max(region.upper, Points[i]);
    }
    std::vector<int> elements;
    Owner.Hierarchy->Query(region, elements);
    ++Queries;
    if (indices.size() > kSmallCluster && elements.size() > kManyCandidates)
    {
      const Vec3 extent = region.upper - region.lower;
      int axis = extent.y > extent.x ? 1 : 0;
      axis = extent.z > extent[axis] ? 2 : axis;
      if (extent[axis] > 0.0)
      {
        const auto middle = indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 2);
        std::ranges::nth_element(
          indices, middle, [&](int a, int b) { return Points[a][axis] < Points[b][axis]; });
        Cluster(indices.first(indices.size() / 2));
        Cluster(indices.subspan(indices.size() / 2));
        return;
      }
    }
    Search(indices, elements);
  }

  void Search(std::span<int> indices, std::span<const int> elements)
  {
    // Elements come in ascending order and points leave when found: so the lowest element wins.
    Remaining.assign(indices.begin(), indices.end());
    Doubtful.clear();
    for (const int element : elements)
    {
      if (Remaining.empty())
      {
        break;
      }
      Select(element);
      if (!Selected.empty())
      {
        Invert(element);
      }
    }
    Decide();
  }

  /// The remaining points that the element might hold, by box and frame.
  void Select(int element)
  {
    const auto& bounds = Owner.Elements[element];
    const Shape shape = TheMesh.ShapeOf(element);
    const Vec3 centre = CentreOf(TheMesh, element);
    const double inverseSize = 1.0 / TheMesh.size[element];
    Selected.clear();
    for (std::size_t k = 0; k < Remaining.size(); ++k)
    {
      if (bounds.MightContain(shape, centre, inverseSize, Points[Remaining[k]]))
      {
        Selected.push_back(static_cast<int>(k));
      }
    }
    Candidates += static_cast<std::int64_t>(Selected.size());
  }

  void Invert(int element)
  {
    const auto& bounds = Owner.Elements[element];
    const auto problem = MakeInverseProblem(TheMesh, element, bounds);
    const int count = static_cast<int>(Selected.size());
    for (int k = 0; k < PaddedCount(count); ++k)
    {
      const Vec3& x = Points[Remaining[Selected[std::min(k, count - 1)]]];
      for (int d = 0; d < 3; ++d)
      {
        Lanes[d][k] = x[d];
      }
    }
    const InverseResult result{ { Lanes[3], Lanes[4], Lanes[5] }, Lanes[6], Lanes[7], Lanes[8] };
    KernelsFor(problem.space).invert(problem, { { Lanes[0], Lanes[1], Lanes[2] }, count }, result);

    Found.clear();
    int inside = 0;
    for (int k = 0; k < count; ++k)
    {
      const int remaining = Selected[k];
      const int index = Remaining[remaining];
      if (result.status[k] == static_cast<double>(NewtonStatus::RootInside))
      {
        // Compact in place: `inside` never runs ahead of k.
        for (int d = 0; d < 3; ++d)
        {
          result.xi[d][inside] = result.xi[d][k];
        }
        result.residual[inside++] = result.residual[k];
        Found.push_back(index);
        Remaining[remaining] = -1;
      }
      else if (result.status[k] == static_cast<double>(NewtonStatus::NotConverged) ||
        !(result.margin[k] >= -bounds.injectiveMargin))
      {
        const bool converged = result.status[k] == static_cast<double>(NewtonStatus::RootOutside);
        Doubtful.push_back({ index, element,
          converged ? Vec3(result.xi[0][k], result.xi[1][k], result.xi[2][k])
                    : Vec3(std::numeric_limits<double>::quiet_NaN()) });
      }
    }
    if (inside > 0)
    {
      Report(element, result, inside);
      std::erase(Remaining, -1);
    }
  }

  void Report(int element, const InverseResult& result, int inside)
  {
    for (int k = inside; k < PaddedCount(inside); ++k)
    {
      for (int d = 0; d < 3; ++d)
      {
        result.xi[d][k] = result.xi[d][inside - 1];
      }
    }
    const double* const xi[3] = { result.xi[0], result.xi[1], result.xi[2] };
    Sink.Inside(element, Found, xi, result.residual);
  }

  /// The careful path, for points that no element's fast path holds. Element by element, so that
  /// what an element needs is made once.
  void Decide()
  {
    std::ranges::sort(Remaining);
    std::erase_if(Doubtful,
      [&](const Doubt& doubt) { return !std::ranges::binary_search(Remaining, doubt.index); });
    Undecided.clear();
    Found.clear();
    // Doubts were raised in ascending order of elements.
    for (std::size_t begin = 0; begin < Doubtful.size();)
    {
      const int element = Doubtful[begin].element;
      const auto careful = Owner.Trees->Of(element);
      for (; begin < Doubtful.size() && Doubtful[begin].element == element; ++begin)
      {
        if (std::ranges::find(Found, Doubtful[begin].index) == Found.end())
        {
          DecideOne(*careful, Doubtful[begin]);
        }
      }
    }
    for (const Doubt& doubt : Undecided)
    {
      if (std::ranges::find(Found, doubt.index) == Found.end())
      {
        // Further elements that could not be decided either are not told.
        Found.push_back(doubt.index);
        ++Unknown;
        Sink.Undecided(doubt.index, doubt.element);
      }
    }
  }

  void DecideOne(InversionTree& careful, const Doubt& doubt)
  {
    ++Careful;
    const Preimages result =
      careful.Find(Points[doubt.index], doubt.root, InversionTree::Wanted::First);
    MostBoxes = std::max(MostBoxes, result.boxes);
    if (result.verdict == Verdict::Inside)
    {
      const InverseRoot& root = result.roots.front();
      std::array<std::array<double, kLanePadding>, 3> xi;
      for (int d = 0; d < 3; ++d)
      {
        xi[d].fill(root.xi[d]);
      }
      const double* const lanes[3] = { xi[0].data(), xi[1].data(), xi[2].data() };
      Sink.Inside(doubt.element, std::span<const int>(&doubt.index, 1), lanes, &root.residual);
      Found.push_back(doubt.index);
    }
    else if (result.verdict == Verdict::Unknown)
    {
      Undecided.push_back(doubt);
    }
  }

  const Locator& Owner;
  const Mesh& TheMesh;
  std::span<const Vec3> Points;
  LocationSink& Sink;
  LaneArrays Lanes;
  std::vector<int> Remaining; ///< points of the cluster not yet found
  std::vector<int> Selected;  ///< positions in Remaining
  std::vector<int> Found;
  std::vector<Doubt> Doubtful;
  std::vector<Doubt> Undecided;
  std::int64_t Queries = 0;
  std::int64_t Candidates = 0;
  std::int64_t Careful = 0;
  int MostBoxes = 0;
  std::int64_t Unknown = 0;
};

Locator::Locator(const Mesh& mesh)
  : TheMesh(mesh)
  , Elements(mesh.Elements())
{
  tbb::parallel_for(
    0, mesh.Elements(), [&](int e) { Elements[e] = MakeElementBounds(TheMesh, e); });
  Trees = std::make_unique<InversionTrees>(TheMesh, Elements);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  MeshBounds = { Vec3(kInfinity), Vec3(-kInfinity) };
  std::vector<Box3> boxes;
  boxes.reserve(Elements.size());
  for (const auto& bounds : Elements)
  {
    boxes.push_back(bounds.box);
    MeshBounds.lower = glm::min(MeshBounds.lower, bounds.box.lower);
    MeshBounds.upper = glm::max(MeshBounds.upper, bounds.box.upper);
  }
  if (!boxes.empty())
  {
    Hierarchy = std::make_unique<Bvh>(boxes, MeshBounds);
  }
}

Locator::~Locator() = default;

void Locator::Locate(std::span<const Vec3> points, LocationSink& sink) const
{
  Batch(*this, points, sink).Run();
}

const Box3& Locator::ElementBox(int element) const
{
  return Elements[element].box;
}

std::size_t Locator::MemoryUsage() const
{
  return Elements.capacity() * sizeof(ElementBounds) + (Hierarchy ? Hierarchy->MemoryUsage() : 0) +
    Trees->MemoryUsage();
}
} // namespace pixelexact
