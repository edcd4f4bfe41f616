// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/NodeModel.h"

#include "Core/Math/Mat.h"
#include "Core/Questions/EdgeArithmetic.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace pixelexact
{
using namespace edges;

namespace
{
/// Limits relative to a node's size. The model is useful where the map differs from the affine one
/// by more than kTurned, and where its remainder is below kLeft of that difference plus kLeftOfSize
/// of the size.
constexpr double kTurned = 0.05;
constexpr double kLeft = 0.25;
constexpr double kLeftOfSize = 0.005;
/// Limits of Newton's iteration.
constexpr int kModelSteps = 2;
constexpr int kModelRounds = 3;

/// Bounds D(xi) = M (Phi(xi) - origin) - (xi - centre).
double TurnedIn(const EdgeNode& node, std::size_t k)
{
  const double(&turn)[3] = node.turn[k];
  return turn[0] * node.reach[0] + turn[1] * node.reach[1] + turn[2] * node.reach[2];
}

/// The model without its remainder, and its slopes.
struct AtPoint
{
  AtPoint(const EdgeNode::MapModel& model, const Vec3& d)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int row = static_cast<int>(k);
      const double(&f)[6] = model.bend[k];
      const Vec3 straight(model.linear[k][0], model.linear[k][1], model.linear[k][2]);
      const Vec3 bent(f[0] * d.x + 0.5 * (f[1] * d.y + f[2] * d.z),
        f[3] * d.y + 0.5 * (f[1] * d.x + f[4] * d.z), f[5] * d.z + 0.5 * (f[2] * d.x + f[4] * d.y));
      value[row] = glm::dot(straight + 0.5 * bent, d);
      for (int j = 0; j < 3; ++j)
      {
        slope[j][row] = straight[j] + bent[j];
      }
    }
    inverse = glm::inverse(slope);
  }

  Vec3 value;
  Mat3 slope; ///< by columns
  Mat3 inverse;
};

double SizeOf(const Mat3& a)
{
  return LargestOf(a[0]) + LargestOf(a[1]) + LargestOf(a[2]);
}
} // namespace

Outline KeepDeep(const EdgeNode& node, const double (&off)[3], Outline outline)
{
  for (const EdgeNodeEnd& end : node.boxEnds)
  {
    if (outline.IsEmpty())
    {
      break;
    }
    const double wider = end.Across(off);
    outline.Keep([&](const Vec3& xi) { return end.DepthOf(xi) + wider; });
  }
  return outline;
}

std::optional<Vec3> FindByModel(
  const EdgeNode& node, std::span<const Vec3> images, const double (&besides)[3])
{
  const EdgeNode::MapModel& model = *node.model;
  const Vec3 reach(node.reach[0], node.reach[1], node.reach[2]);
  Vec3 middle(0.0);
  for (const Vec3& image : images)
  {
    middle += image - node.centre;
  }
  middle /= static_cast<double>(images.size());
  Vec3 at = glm::clamp(middle, -reach, reach);
  AtPoint about(model, at);
  for (int step = 0; step < kModelSteps; ++step)
  {
    at = glm::clamp(at + about.inverse * (middle - about.value), -reach, reach);
    about = AtPoint(model, at);
  }

  // Bounds |xi - at| for the preimages: their distance from the affine map's is at most D.
  std::array<Vec3, Outline::kMaxCorners> places;
  double away[3] = {};
  double farther[3] = {};
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    const Vec3 image = images[i] - node.centre;
    const Vec3 step = about.inverse * (image - about.value);
    places[i] = node.centre + at + step;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int d = static_cast<int>(k);
      away[k] = std::max(away[k], std::fabs(image[d] - at[d]));
      farther[k] = std::max(farther[k], std::fabs(step[d]));
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double most = node.reach[k] + std::fabs(at[static_cast<int>(k)]);
    away[k] = std::min(away[k] + TurnedIn(node, k) + besides[k] + 1e-13, most) * kUp;
  }
  const double rounding = kRoundoffs * (1.0 + SizeOf(about.inverse) * SizeOf(about.slope)) *
    (std::max({ away[0], away[1], away[2] }) + std::max({ farther[0], farther[1], farther[2] }));
  double off[3];
  for (int round = 0; round < kModelRounds; ++round)
  {
    double left[3];
    double there[3]; // |xi - centre|
    for (std::size_t k = 0; k < 3; ++k)
    {
      there[k] = std::min(node.reach[k], (std::fabs(at[static_cast<int>(k)]) + away[k]) * kUp);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      double bent = 0.0;
      for (std::size_t p = 0; p < 6; ++p)
      {
        bent += std::fabs(model.bend[k][p]) * away[kRows[p]] * away[kColumns[p]];
      }
      left[k] = 0.5 * (bent + Quadratic(model.radius[k], there)) + besides[k] + model.error[k];
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int d = static_cast<int>(k);
      off[k] =
        (std::fabs(about.inverse[0][d]) * left[0] + std::fabs(about.inverse[1][d]) * left[1] +
          std::fabs(about.inverse[2][d]) * left[2] + rounding) *
          kUp +
        1e-13;
      away[k] = std::min(away[k], (farther[k] + off[k]) * kUp);
    }
  }
  if (KeepDeep(node, off, Outline(std::span(places).first(images.size()))).IsEmpty())
  {
    return std::nullopt;
  }
  return node.centre + at;
}

void EdgeNode::DescribeModel(
  const EdgeFunctions& functions, const std::array<HessianFunction::XiRanges, 3>& ranges)
{
  const Mat3 jacobian = functions.ViewAt(centre).jacobian;
  const double unsure =
    functions.ImageError() + functions.ImageSlopeError() * (reach[0] + reach[1] + reach[2]);
  auto made = std::make_unique<MapModel>();
  bool isTurned = false;
  bool isKnown = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    double terms = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      made->linear[k][j] = 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double product = inverse[k][c] * jacobian[static_cast<int>(j)][static_cast<int>(c)];
        made->linear[k][j] += product;
        terms += std::fabs(product) * reach[j];
      }
    }
    for (std::size_t p = 0; p < 6; ++p)
    {
      const double twice = kRows[p] == kColumns[p] ? 1.0 : 2.0;
      Interval entry(0.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        entry += Interval(inverse[k][c]) * ranges[c].second[p];
      }
      const double middle = entry.Middle();
      made->bend[k][p] = twice * middle;
      made->radius[k][p] = twice * entry.RadiusAround(middle);
      terms += std::fabs(made->bend[k][p]) * reach[kRows[p]] * reach[kColumns[p]];
    }
    // Includes the rounding of the model's evaluation.
    made->error[k] = (lean[k] * unsure + kRoundoffs * terms) * kUp;
    const double turned = TurnedIn(*this, k);
    isTurned = isTurned || turned > kTurned * reach[k];
    // The comparison is written so that a NaN is not known.
    isKnown =
      isKnown && 0.5 * Quadratic(made->radius[k], reach) <= kLeft * turned + kLeftOfSize * reach[k];
  }
  if (isTurned && isKnown)
  {
    model = std::move(made);
  }
}
} // namespace pixelexact
