// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Sample.h"

#include "Core/Base/Error.h"
#include "Core/Element/FieldMapping.h"
#include "Core/Element/Kernels.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Points per batch of Sample: enough to share an element's data, few enough to spread over cores.
constexpr std::size_t kBatch = 1024;

/// Kernel output arrays, grown as needed.
class OutputArrays
{
public:
  double* const* Get(std::size_t arrays, std::size_t stride)
  {
    if (Storage.size() < arrays * stride)
    {
      Storage.resize(arrays * stride);
    }
    Pointers.resize(arrays);
    for (std::size_t k = 0; k < arrays; ++k)
    {
      Pointers[k] = &Storage[k * stride];
    }
    return Pointers.data();
  }

private:
  std::vector<double> Storage;
  std::vector<double*> Pointers;
};

/// Writes what the locator finds, and the field's values there.
class SamplingSink final : public LocationSink
{
public:
  SamplingSink(const Mesh& mesh, const Field* field, const SampleTarget& target)
    : TheMesh(mesh)
    , TheField(field)
    , Target(target)
  {
  }

  void Inside(int element, std::span<const int> index, const double* const xi[3],
    const double* residual) override
  {
    for (std::size_t k = 0; k < index.size(); ++k)
    {
      const auto i = static_cast<std::size_t>(index[k]);
      if (!Target.element.empty())
      {
        Target.element[i] = element;
      }
      if (!Target.xi.empty())
      {
        Target.xi[i] = { xi[0][k], xi[1][k], xi[2][k] };
      }
      if (!Target.verdict.empty())
      {
        Target.verdict[i] = Verdict::Inside;
      }
      if (!Target.residual.empty())
      {
        Target.residual[i] = residual[k];
      }
    }
    if (TheField)
    {
      EvaluateField(element, index, { { xi[0], xi[1], xi[2] }, static_cast<int>(index.size()) });
    }
  }

  void Undecided(int index, int element) override
  {
    const auto i = static_cast<std::size_t>(index);
    if (!Target.element.empty())
    {
      Target.element[i] = element;
    }
    if (!Target.verdict.empty())
    {
      Target.verdict[i] = Verdict::Unknown;
    }
  }

private:
  void EvaluateField(int element, std::span<const int> index, const LanePoints& xi)
  {
    const auto& values = TheField->values;
    const Space& space = values.SpaceOf(element);
    const auto components = static_cast<std::size_t>(values.components);
    const auto stride = static_cast<std::size_t>(PaddedCount(xi.count));
    const bool gradient = !Target.gradient.empty();
    double* const* out = Arrays.Get(components * (gradient ? 4 : 1), stride);
    const KernelSet kernels = KernelsFor(space);
    if (gradient)
    {
      kernels.gradient(
        space, values.Coefficients(element), values.components, xi, out, out + components);
    }
    else
    {
      kernels.value(space, values.Coefficients(element), values.components, xi, out);
    }
    ApplyMapping(TheMesh, element, TheField->mapping, xi, values.components, out,
      gradient ? out + components : nullptr);
    if (gradient)
    {
      Scatter(index, out + components, 3 * components, Target.gradient);
    }
    if (!Target.value.empty())
    {
      Scatter(index, out, components, Target.value);
    }
  }

  static void Scatter(
    std::span<const int> index, double* const* from, std::size_t width, std::span<double> to)
  {
    for (std::size_t c = 0; c < width; ++c)
    {
      for (std::size_t k = 0; k < index.size(); ++k)
      {
        to[static_cast<std::size_t>(index[k]) * width + c] = from[c][k];
      }
    }
  }

  const Mesh& TheMesh;
  const Field* TheField;
  const SampleTarget& Target;
  OutputArrays Arrays;
};

void RequireSizes(const Field* field, std::size_t points, const SampleTarget& target)
{
  const std::size_t components = field ? static_cast<std::size_t>(field->values.components) : 0;
  const auto fits = [](std::size_t size, std::size_t wanted)
  { return size == 0 || size == wanted; };
  if (!fits(target.element.size(), points) || !fits(target.xi.size(), points) ||
    !fits(target.verdict.size(), points) || !fits(target.residual.size(), points) ||
    !fits(target.value.size(), points * components) ||
    !fits(target.gradient.size(), 3 * points * components))
  {
    throw Error("sample arrays must be empty or hold one entry for each of the " +
      std::to_string(points) + " points.");
  }
}

/// 21 bits of each coordinate, interleaved: nearby points get nearby codes.
std::uint64_t MortonCode(const Vec3& x, const Box3& bounds)
{
  std::uint64_t code = 0;
  for (int d = 0; d < 3; ++d)
  {
    const double extent = bounds.upper[d] - bounds.lower[d];
    const double at = extent > 0.0 ? (x[d] - bounds.lower[d]) / extent : 0.0;
    // NaN compares false and becomes 0; where such a point is put does not matter.
    auto bits = at > 0.0 ? static_cast<std::uint64_t>(std::min(at, 1.0) * 2097151.0) : 0U;
    bits = (bits | bits << 32U) & 0x1f00000000ffffU;
    bits = (bits | bits << 16U) & 0x1f0000ff0000ffU;
    bits = (bits | bits << 8U) & 0x100f00f00f00f00fU;
    bits = (bits | bits << 4U) & 0x10c30c30c30c30c3U;
    bits = (bits | bits << 2U) & 0x1249249249249249U;
    code |= bits << static_cast<unsigned>(d);
  }
  return code;
}

/// Copies entries of a batch, in its own order, to the places of its points.
template <class T>
void ScatterBatch(std::span<const std::size_t> place, std::span<const T> from, std::span<T> to)
{
  const std::size_t width = place.empty() ? 0 : from.size() / place.size();
  for (std::size_t k = 0; k < place.size(); ++k)
  {
    std::copy_n(&from[k * width], width, &to[place[k] * width]);
  }
}

/// One batch of Sample: gathered points, their results, and the way back.
struct SampleBatch
{
  std::vector<Vec3> points;
  std::vector<std::int32_t> element;
  std::vector<Vec3> xi;
  std::vector<Verdict> verdict;
  std::vector<double> residual;
  std::vector<double> value;
  std::vector<double> gradient;

  void Run(const Locator& locator, const Field* field, std::span<const Vec3> all,
    std::span<const std::size_t> place, const SampleTarget& target)
  {
    const std::size_t count = place.size();
    points.resize(count);
    for (std::size_t k = 0; k < count; ++k)
    {
      points[k] = all[place[k]];
    }
    const std::size_t components = field ? static_cast<std::size_t>(field->values.components) : 0;
    element.resize(target.element.empty() ? 0 : count);
    xi.resize(target.xi.empty() ? 0 : count);
    verdict.resize(target.verdict.empty() ? 0 : count);
    residual.resize(target.residual.empty() ? 0 : count);
    value.resize(target.value.empty() ? 0 : count * components);
    gradient.resize(target.gradient.empty() ? 0 : 3 * count * components);
    SampleTile(locator, field, points, { element, xi, verdict, residual, value, gradient });
    Return(place, target);
  }

private:
  void Return(std::span<const std::size_t> place, const SampleTarget& target) const
  {
    const auto back = [&]<class T>(const std::vector<T>& from, std::span<T> to)
    {
      if (!to.empty())
      {
        ScatterBatch<T>(place, from, to);
      }
    };
    back(element, target.element);
    back(xi, target.xi);
    back(verdict, target.verdict);
    back(residual, target.residual);
    back(value, target.value);
    back(gradient, target.gradient);
  }
};
} // namespace

void SampleTarget::Clear() const
{
  std::ranges::fill(element, -1);
  std::ranges::fill(xi, Vec3(kNan));
  std::ranges::fill(verdict, Verdict::Outside);
  std::ranges::fill(residual, kNan);
  std::ranges::fill(value, kNan);
  std::ranges::fill(gradient, kNan);
}

void SampleTile(const Locator& locator, const Field* field, std::span<const Vec3> points,
  const SampleTarget& target)
{
  RequireSizes(field, points.size(), target);
  target.Clear();
  SamplingSink sink(locator.GetMesh(), field, target);
  locator.Locate(points, sink);
}

void Sample(const Locator& locator, const Field* field, std::span<const Vec3> points,
  const SampleTarget& target)
{
  RequireSizes(field, points.size(), target);
  struct Keyed
  {
    std::uint64_t code;
    std::size_t place;
  };
  std::vector<Keyed> order(points.size());
  tbb::parallel_for(std::size_t{ 0 }, points.size(),
    [&](std::size_t i) {
      order[i] = { MortonCode(points[i], locator.Bounds()), i };
    });
  // Ties are broken by place, so that batches are the same for any number of threads.
  tbb::parallel_sort(order.begin(), order.end(),
    [](const Keyed& a, const Keyed& b)
    { return a.code != b.code ? a.code < b.code : a.place < b.place; });
  const std::size_t batches = (points.size() + kBatch - 1) / kBatch;
  tbb::parallel_for(std::size_t{ 0 }, batches,
    [&](std::size_t b)
    {
      const std::size_t begin = b * kBatch;
      std::vector<std::size_t> place(std::min(kBatch, points.size() - begin));
      for (std::size_t k = 0; k < place.size(); ++k)
      {
        place[k] = order[begin + k].place;
      }
      SampleBatch batch;
      batch.Run(locator, field, points, place, target);
    });
}

void EvaluateAt(const Mesh& mesh, const Field& field, int element, std::span<const Vec3> xi,
  std::span<double> value, std::span<double> gradient)
{
  SampleTarget target;
  target.value = value;
  target.gradient = gradient;
  RequireSizes(&field, xi.size(), target);
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
  SamplingSink sink(mesh, &field, target);
  sink.Inside(element, index, pointers, &lanes[3 * stride]);
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
