// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/GroupNewton.h"

namespace pixelexact
{
std::int64_t NewtonCost(const Space& space, int points)
{
  // Nanoseconds of a pack, and of it per mode; more where coefficients are more than the second
  // cache holds.
  constexpr std::int64_t kOfPack = 2000;
  constexpr std::int64_t kOfMode = 20;
  constexpr std::int64_t kManyModes = 16384;
  constexpr std::int64_t kOfManyModes = 50;
  const std::int64_t modes = space.Modes();
  return (kOfPack + (modes > kManyModes ? kOfManyModes : kOfMode) * modes) *
    (PaddedCount(points) / kLanePadding);
}

Bits RunNewton(const InverseProblem& problem, RootChecker& checker, const NodeFrame& frame,
  const PointGroup& group, Bits bits, FoundRoots& roots)
{
  std::array<std::array<double, kGroupPoints>, 12> lanes;
  std::array<std::size_t, kGroupPoints> which{};
  std::size_t count = 0;
  ForEachBit(bits,
    [&](std::size_t i)
    {
      const Vec3 guess = frame.Guess(group.YOf(i));
      for (int d = 0; d < 3; ++d)
      {
        lanes[static_cast<std::size_t>(d)][count] = group.points[i].x[d];
        lanes[3 + static_cast<std::size_t>(d)][count] = guess[d];
      }
      which[count++] = i;
    });
  const int asked = static_cast<int>(count);
  for (std::size_t k = count; k < static_cast<std::size_t>(PaddedCount(asked)); ++k)
  {
    for (std::size_t d = 0; d < 6; ++d)
    {
      lanes[d][k] = lanes[d][k - 1];
    }
  }
  InverseProblem fromGuesses = problem;
  fromGuesses.affine = false;
  fromGuesses.from = { lanes[3].data(), lanes[4].data(), lanes[5].data() };
  const InverseResult result{ { lanes[6].data(), lanes[7].data(), lanes[8].data() },
    lanes[9].data(), lanes[10].data(), lanes[11].data() };
  KernelsFor(problem.space)
    .invert(fromGuesses, { { lanes[0].data(), lanes[1].data(), lanes[2].data() }, asked }, result);
  const auto isInside = [&](std::size_t k)
  { return result.status[k] == static_cast<double>(NewtonStatus::RootInside); };

  Bits found = 0;
  std::array<Vec3, kGroupPoints> xi;
  std::array<Vec3, kGroupPoints> y;
  std::array<std::size_t, kGroupPoints> from{};
  std::size_t converged = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vec3 root(result.xi[0][k], result.xi[1][k], result.xi[2][k]);
    // Beyond a pyramid's apex lies another cone, whose roots do not belong to this one.
    if (result.status[k] != static_cast<double>(NewtonStatus::NotConverged) &&
      (isInside(k) || problem.space.shape != Shape::Pyramid || root.z <= 1.0))
    {
      found |= BitOf(which[k]);
      from[converged] = k;
      y[converged] = group.YOf(which[k]);
      xi[converged++] = root;
    }
  }
  if (converged == 0)
  {
    return 0;
  }
  std::array<RootCheck, kGroupPoints> checks;
  checker.Run(std::span(xi).first(converged), std::span(y).first(converged), checks);
  for (std::size_t i = 0; i < converged; ++i)
  {
    const std::size_t k = from[i];
    const bool inside = isInside(k);
    const bool onFace = inside && checks[i].IsOnFace(problem.space.shape, xi[i]);
    roots.Add(which[k], { xi[i], result.residual[k], inside, onFace }, checks[i]);
  }
  return found;
}
} // namespace pixelexact
