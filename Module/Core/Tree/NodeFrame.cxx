// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/NodeFrame.h"

#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Bernstein/Krawczyk.h"
#include "Core/Element/Kernels.h"
#include "Core/Math/Rounding.h"
#include "Core/Tree/FrameMeasure.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{

struct MapAt
{
  std::array<double, 3> value{};
  SmallMatrix jacobian{};
};

/// Phi and its Jacobian at up to kLanePadding points, in plain arithmetic.
void EvaluateAt(
  const Space& space, const double* modes, std::span<const Vec3> xi, std::span<MapAt> result)
{
  double lanes[15][kLanePadding];
  for (std::size_t k = 0; k < kLanePadding; ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      lanes[d][k] = xi[std::min(k, xi.size() - 1)][d];
    }
  }
  double* out[3] = { lanes[3], lanes[4], lanes[5] };
  double* gradient[9];
  for (int k = 0; k < 9; ++k)
  {
    gradient[k] = lanes[6 + k];
  }
  KernelsFor(space).gradient(space, modes, 3,
    { { lanes[0], lanes[1], lanes[2] }, static_cast<int>(xi.size()) }, out, gradient);
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      result[k].value[c] = out[c][k];
      for (std::size_t d = 0; d < 3; ++d)
      {
        result[k].jacobian[c][d] = gradient[3 * c + d][k];
      }
    }
  }
}

} // namespace

void MakeFrame(const Space& space, const double* modes, const ElementBounds& bounds,
  const BoxCoefficients& phi, NodeFrame& frame)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double slack = bounds.uncertainty[c];
    frame.hull[c] = phi.HullOf(c) + Interval(phi.base[c]) + Interval(-slack, slack);
  }
  const auto middles = MiddlesOf(space.shape, frame.box);
  std::array<MapAt, 7> at;
  EvaluateAt(space, modes, middles, at);
  frame.centre = middles[6];
  frame.origin = at[6].value;
  const auto inverse = Inverse(3, at[6].jacobian);
  frame.framed = inverse.has_value();
  std::array<double, 3> variation{};
  const Vec3 width = frame.box.upper - frame.box.lower;
  const double longest = std::max({ width.x, width.y, width.z });
  if (frame.framed)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      std::ranges::copy((*inverse)[d], &frame.inverse[3 * d]);
    }
    FrameMeasure measure(space, bounds, phi, frame);
    variation = measure.Measure();
    const auto& deviation = frame.deviation;
    frame.bending =
      std::max({ deviation[0].Magnitude(), deviation[1].Magnitude(), deviation[2].Magnitude() }) /
      longest;
    // A box that bends by more than this holds no point for certain, so that tilted planes lose
    // nothing.
    constexpr double kBentMuch = 0.45;
    if (frame.bending > kBentMuch && frame.bending < kInfinity)
    {
      std::array<SmallMatrix, 6> ends;
      std::ranges::transform(std::span(at).first(6), ends.begin(), &MapAt::jacobian);
      measure.TiltPlanes(ends);
    }
  }
  // A pyramid is a cone: near its apex, directions differ only at the point's own distance. A
  // straight box that is partly too close to the apex for Newton's iteration is divided there.
  const double apexRegion = 1.0 - kApexRegion;
  const bool straddles = frame.box.lower.z < apexRegion && apexRegion < frame.box.upper.z;
  if (space.shape == Shape::Pyramid &&
    (frame.box.upper.z == 1.0 || (straddles && frame.IsAffine())))
  {
    frame.widest = 2;
    return;
  }
  // Where the deviation has no information, or only rounding, the longest side decides.
  const double largest = std::max({ variation[0], variation[1], variation[2] });
  double best = -1.0;
  for (int d = 0; d < 3; ++d)
  {
    const double share = largest > 0.0 && std::isfinite(largest)
      ? variation[static_cast<std::size_t>(d)] / largest
      : 0.0;
    const double score = share + 0.1 * width[d] / longest;
    if (score > best)
    {
      best = score;
      frame.widest = d;
    }
  }
}

Vec3 NodeFrame::Step(const Vec3& d) const
{
  Vec3 step(0.0);
  for (std::size_t k = 0; framed && k < 9; ++k)
  {
    step[static_cast<int>(k / 3)] += inverse[k] * d[static_cast<int>(k % 3)];
  }
  return step;
}

Vec3 NodeFrame::Root(const Vec3& y) const
{
  return centre + Step({ y[0] - origin[0], y[1] - origin[1], y[2] - origin[2] });
}

Vec3 NodeFrame::Guess(const Vec3& y) const
{
  return glm::clamp(Root(y), Vec3(-1.0), Vec3(1.0));
}

bool NodeFrame::IsAffine() const
{
  bool affine = framed;
  for (std::size_t d = 0; d < 3; ++d)
  {
    affine = affine && deviation[d].Width() <= 2.25 * slack[d];
  }
  return affine;
}

Vec3 StepOfMap(const Space& space, const double* modes, const Vec3& xi, const Vec3& y)
{
  MapAt at;
  EvaluateAt(space, modes, std::span(&xi, 1), std::span(&at, 1));
  const auto inverse = Inverse(3, at.jacobian);
  Vec3 step(0.0);
  for (std::size_t d = 0; inverse && d < 3; ++d)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      step[static_cast<int>(d)] += (*inverse)[d][c] * (y[static_cast<int>(c)] - at.value[c]);
    }
  }
  return step;
}
} // namespace pixelexact
