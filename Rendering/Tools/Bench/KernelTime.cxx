// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/KernelTime.h"

#include "Core/Element/Kernels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <random>
#include <vector>

namespace pixelexact
{
namespace
{
// The number of samples in a tile of the tracer.
constexpr int kBatch = 1024;

int UsualElement(const Expansion& field)
{
  std::vector<int> count(field.spaces.size(), 0);
  for (const std::int32_t space : field.spaceOf)
  {
    ++count[static_cast<std::size_t>(space)];
  }
  const auto usual = std::max_element(count.begin(), count.end()) - count.begin();
  return static_cast<int>(
    std::find(field.spaceOf.begin(), field.spaceOf.end(), usual) - field.spaceOf.begin());
}

/// Points of the shape, coordinate by coordinate.
std::array<std::vector<double>, 3> RandomPoints(Shape shape)
{
  std::mt19937_64 random(2026);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::array<std::vector<double>, 3> xi;
  for (int i = 0; i < kBatch; ++i)
  {
    const Vec3 eta(uniform(random), uniform(random), uniform(random));
    const Vec3 point = TensorToReference(shape, eta);
    for (int d = 0; d < 3; ++d)
    {
      xi[static_cast<std::size_t>(d)].push_back(point[d]);
    }
  }
  return xi;
}
} // namespace

double KernelSeconds(const Expansion& field, std::int64_t points)
{
  if (field.Elements() == 0 || points <= 0)
  {
    return 0.0;
  }
  const int element = UsualElement(field);
  const Space& space = field.SpaceOf(element);
  const KernelSet kernels = KernelsFor(space);
  const auto xi = RandomPoints(space.shape);

  const auto begin = std::chrono::steady_clock::now();
  const std::int64_t batches = (points + kBatch - 1) / kBatch;
  tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, batches),
    [&](const tbb::blocked_range<std::int64_t>& range)
    {
      std::vector<double> values(static_cast<std::size_t>(field.components) * kBatch);
      std::vector<double*> out;
      out.reserve(static_cast<std::size_t>(field.components));
      for (int c = 0; c < field.components; ++c)
      {
        out.push_back(&values[static_cast<std::size_t>(c) * kBatch]);
      }
      for (std::int64_t batch = range.begin(); batch < range.end(); ++batch)
      {
        const auto count =
          static_cast<int>(std::min<std::int64_t>(kBatch, points - batch * kBatch));
        kernels.value(space, field.Coefficients(element), field.components,
          { { xi[0].data(), xi[1].data(), xi[2].data() }, count }, out.data());
      }
    });
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
} // namespace pixelexact
