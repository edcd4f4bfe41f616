// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/CompiledGraph.h"

#include "Core/Base/Error.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Faces/BehindFace.h"
#include "Core/Location/Sample.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
void RequireCurvature(const Field& field)
{
  if (field.mapping != Mapping::Identity)
  {
    throw Unsupported("second derivatives of '" + field.name +
      "' are not available: it is a field of H(curl), H(div) or a density");
  }
}

/// Empty where there are no arrays.
std::vector<Vec3> GatherPoints(const double* const* arrays, int count)
{
  std::vector<Vec3> points(arrays != nullptr ? static_cast<std::size_t>(count) : 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = { arrays[0][i], arrays[1][i], arrays[2][i] };
  }
  return points;
}

/// Arrays of kTogether numbers.
class ArraysOfPoints
{
public:
  explicit ArraysOfPoints(std::size_t arrays)
    : Storage(arrays * PointLeaves::kTogether)
  {
    for (std::size_t k = 0; k < arrays; ++k)
    {
      Arrays.push_back(&Storage[k * PointLeaves::kTogether]);
    }
  }
  [[nodiscard]] std::span<double* const> Get() const { return Arrays; }

private:
  std::vector<double> Storage;
  std::vector<double*> Arrays;
};

/// The points whose neighbour is one element.
struct PointsOfNeighbour
{
  int element = -1;
  std::vector<std::size_t> index;
};

std::vector<PointsOfNeighbour> GroupByElement(std::span<const BehindFace> behind)
{
  std::vector<PointsOfNeighbour> groups;
  for (std::size_t i = 0; i < behind.size(); ++i)
  {
    if (behind[i].verdict != Verdict::Inside)
    {
      continue;
    }
    auto group = std::ranges::find(groups, behind[i].element, &PointsOfNeighbour::element);
    if (group == groups.end())
    {
      group = groups.insert(groups.end(), { behind[i].element, {} });
    }
    group->index.push_back(i);
  }
  return groups;
}

template <class PointAt>
LaneBuffer LanesOf(const std::vector<std::size_t>& index, const PointAt& pointAt)
{
  std::vector<Vec3> points;
  std::ranges::transform(index, std::back_inserter(points), pointAt);
  return LaneBuffer(points);
}
} // namespace

CompiledGraph::CompiledGraph(const Graph& graph, std::vector<int> outputs,
  std::span<const Field* const> fields, std::span<const std::int64_t> numbers,
  const LocatorSource& locator)
  : Code(graph, std::move(outputs))
  , Leaves(Code.Leaves(), fields, numbers)
{
  std::vector<int> behind;
  for (const Graph::Node& leaf : Code.Leaves())
  {
    if (leaf.operation == Operation::Curvature)
    {
      RequireCurvature(*fields[static_cast<std::size_t>(leaf.field)]);
    }
    else if (leaf.operation == Operation::Behind)
    {
      behind.push_back(leaf.a);
    }
  }
  if (behind.empty())
  {
    return;
  }
  if (!locator)
  {
    throw Unsupported("jumps need the mesh of the fields, to find elements' neighbours");
  }
  Behind = std::make_unique<CompiledGraph>(graph, std::move(behind), fields, numbers, locator);
  Places = &locator();
}

void CompiledGraph::Evaluate(
  const Mesh& mesh, int element, const FunctionPoints& points, std::span<double* const> out) const
{
  thread_local PointLeaves::Scratch leaves;
  thread_local std::vector<double> registers;
  const ArraysOfPoints behind(Behind != nullptr ? Behind->Code.OutputCount() : 0);
  std::vector<double*> some(out.size());
  std::array<const double*, 3> x{};
  std::array<const double*, 3> normal{};
  for (int begin = 0; begin < points.xi.count; begin += PointLeaves::kTogether)
  {
    const auto from = [begin](const double* const* arrays, std::array<const double*, 3>& part)
    {
      for (std::size_t d = 0; arrays != nullptr && d < 3; ++d)
      {
        part[d] = arrays[d] + begin;
      }
      return arrays != nullptr ? part.data() : nullptr;
    };
    const double* const* xi = points.xi.x;
    const FunctionPoints part{ { { xi[0] + begin, xi[1] + begin, xi[2] + begin },
                                 std::min(PointLeaves::kTogether, points.xi.count - begin) },
      from(points.x, x), from(points.normal, normal) };
    std::ranges::transform(out, some.begin(), [begin](double* array) { return array + begin; });
    // First: it uses the same scratch memory.
    EvaluateBehind(mesh, element, part, behind.Get());
    Code.Run(Leaves.Evaluate(mesh, element, part, behind.Get().data(), leaves), part.xi.count,
      some.data(), registers);
  }
}

/// NaN where no element is behind a face.
void CompiledGraph::EvaluateBehind(
  const Mesh& mesh, int element, const FunctionPoints& points, std::span<double* const> out) const
{
  if (Behind == nullptr)
  {
    return;
  }
  for (double* const array : out)
  {
    std::fill_n(array, points.xi.count, std::numeric_limits<double>::quiet_NaN());
  }
  const std::vector<Vec3> xi = GatherPoints(points.xi.x, points.xi.count);
  const std::vector<Vec3> normals = GatherPoints(points.normal, points.xi.count);
  std::vector<Vec3> x = GatherPoints(points.x, points.xi.count);
  if (x.empty())
  {
    x.resize(xi.size());
    MapForward(mesh, element, xi, x);
  }
  std::vector<BehindFace> behind(xi.size());
  FindBehindPoints(*Places, element, xi, x, behind);
  const ArraysOfPoints values(out.size());
  for (const PointsOfNeighbour& group : GroupByElement(behind))
  {
    const LaneBuffer xiThere = LanesOf(group.index, [&](std::size_t i) { return behind[i].xi; });
    const LaneBuffer xThere = LanesOf(group.index, [&](std::size_t i) { return x[i]; });
    const LaneBuffer normalsThere =
      LanesOf(group.index, [&](std::size_t i) { return normals.empty() ? Vec3(0.0) : normals[i]; });
    const LanePoints places = xThere.View();
    const LanePoints directions = normalsThere.View();
    Behind->Evaluate(mesh, group.element,
      { xiThere.View(), places.x, normals.empty() ? nullptr : directions.x }, values.Get());
    for (std::size_t k = 0; k < out.size(); ++k)
    {
      for (std::size_t i = 0; i < group.index.size(); ++i)
      {
        out[k][group.index[i]] = values.Get()[k][i];
      }
    }
  }
}
} // namespace pixelexact
