// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Sample.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Location/SamplingSink.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <mutex>

namespace pixelexact
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Points per batch of Sample: enough to share an element's data, few enough to spread over cores.
constexpr std::size_t kBatch = 1024;

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
  std::vector<double> valueLower;
  std::vector<double> valueUpper;
  PrecisionCheck check;

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
    valueLower.resize(target.valueLower.empty() ? 0 : count * components);
    valueUpper.resize(valueLower.size());
    SampleTarget tile{ element, xi, verdict, residual, value, gradient, valueLower, valueUpper };
    tile.precision = target.precision;
    tile.check = target.check != nullptr ? &check : nullptr;
    SampleTile(locator, field, points, tile);
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
    back(valueLower, target.valueLower);
    back(valueUpper, target.valueUpper);
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
  std::ranges::fill(valueLower, kNan);
  std::ranges::fill(valueUpper, kNan);
}

void SampleTile(const Locator& locator, const Field* field, std::span<const Vec3> points,
  const SampleTarget& target)
{
  const LaneBuffer lanes(points);
  SampleTile(locator, field, lanes.View(), target);
}

void SampleTile(
  const Locator& locator, const Field* field, const LanePoints& points, const SampleTarget& target)
{
  RequireSizes(field, static_cast<std::size_t>(points.count), target);
  target.Clear();
  SamplingSink sink(locator.GetMesh(), field, points, target);
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
  std::mutex checking;
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
      if (target.check != nullptr)
      {
        const std::scoped_lock lock(checking);
        target.check->Add(batch.check);
      }
    });
}
} // namespace pixelexact
