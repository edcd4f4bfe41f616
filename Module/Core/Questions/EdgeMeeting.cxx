// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeMeeting.h"

#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/LocalCurves.h"
#include "Core/Questions/NodeModel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace pixelexact
{
using namespace edges;

namespace
{
/// Smaller nodes help where the expansion's error exceeds this fraction of the distance.
constexpr double kCoarse = 0.25;
constexpr int kRounds = 6;
constexpr int kLocalRounds = 2;
/// The rounding of points on a face, in xi.
constexpr double kBesideFace = 1e-13;
/// Newton steps towards a region's middle.
constexpr int kMiddleSteps = 2;
/// Covers the rounding of sums of about five products, relative to the sum of their magnitudes.
constexpr double kSum = 8.0 * kUnitRoundoff;

/// A xi of the box, close to the nearest one.
Vec3 MovedInto(Shape shape, const EdgeNode& node, const Vec3& xi)
{
  const EtaBox& box = node.wide;
  Vec3 moved = xi;
  for (int round = 0; round < 3; ++round)
  {
    for (const EdgeNodeEnd& end : node.wideEnds)
    {
      const double depth = end.DepthOf(moved);
      if (depth < 0.0)
      {
        const Vec3 normal(end.normal[0], end.normal[1], end.normal[2]);
        moved += normal * (depth / glm::dot(normal, normal));
      }
    }
  }
  // Clamps the remaining distance in eta. A NaN becomes some point of the box.
  return TensorToReference(
    shape, glm::clamp(ReferenceToTensor(shape, moved), box.lower, box.upper));
}

/// Applies the inverse of a node's affine map.
Vec3 ToXi(const EdgeFunctions& functions, const EdgeNode& node, const Vec3& x)
{
  const Vec3 y = functions.InUnits(x) - node.origin;
  Vec3 xi = node.centre;
  for (int k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    xi[k] += row[0] * y.x + row[1] * y.y + row[2] * y.z;
  }
  return xi;
}

/// The images in xi of a region's corners by a node's affine map, with bounds of their errors.
struct AffineImages
{
  AffineImages(const EdgeFunctions& functions, const EdgeNode& node, const WideOutline& region)
    : count(region.outline.Corners().size())
  {
    const auto corners = region.outline.Corners();
    double largest = LargestOf(node.origin);
    for (std::size_t i = 0; i < count; ++i)
    {
      largest = std::max(largest, LargestOf(functions.InUnits(corners[i])));
      images[i] = ToXi(functions, node, corners[i]);
    }
    const double inY =
      region.slack / functions.Size() + functions.ImageError() + 2.0 * kSum * largest;
    for (std::size_t k = 0; k < 3; ++k)
    {
      besides[k] = node.shift[k] + node.lean[k] * inY;
    }
  }
  [[nodiscard]] std::span<const Vec3> Places() const { return { images.data(), count }; }

  std::size_t count;
  std::array<Vec3, Outline::kMaxCorners> images;
  double besides[3];
};

/// A xi for the expansion. None is a proof that the region misses the node.
std::optional<Vec3> FindStart(
  const EdgeFunctions& functions, const EdgeNode& node, const WideOutline& region)
{
  if (!node.model)
  {
    return ToXi(functions, node, region.outline.Middle());
  }
  const AffineImages images(functions, node, region);
  return FindByModel(node, images.Places(), images.besides);
}
} // namespace

bool Misses(const EdgeFunctions& functions, const EdgeNode& node, const WideOutline& region)
{
  const auto corners = region.outline.Corners();
  const double slack = region.slack;
  for (int d = 0; d < 3; ++d)
  {
    double least = corners.front()[d];
    double most = least;
    for (const Vec3& corner : corners)
    {
      least = std::min(least, corner[d]);
      most = std::max(most, corner[d]);
    }
    if (most + slack < node.bounds.lower[d] || least - slack > node.bounds.upper[d])
    {
      return true;
    }
  }
  if (!node.regular)
  {
    return false;
  }
  // Every preimage in `wide` of a point of the region is within `off` of the hull of these images:
  // D(xi) = M (Phi(xi) - origin) - (xi - centre) changes by at most `turn`.
  const AffineImages images(functions, node, region);
  double off[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double turned = node.turn[k][0] * node.reach[0] + node.turn[k][1] * node.reach[1] +
      node.turn[k][2] * node.reach[2];
    off[k] = (turned + images.besides[k]) * kUp + 1e-13;
  }
  return KeepDeep(node, off, Outline(images.Places())).IsEmpty();
}

EdgeMeeting Meet(const EdgeFunctions& functions, const EdgeNode& node, const WideOutline& region,
  const ValueSet& wanted, const EdgeNodeEnd* face, KeptExpansion* kept)
{
  const double slack = region.slack;
  const Shape shape = functions.GetShape();
  const auto corners = region.outline.Corners();
  const std::size_t count = corners.size();
  std::array<Vec3, Outline::kMaxCorners> ends;
  std::ranges::transform(
    corners, ends.begin(), [&](const Vec3& x) { return functions.InUnits(x); });
  const auto farthest = [&](auto&& distanceOf)
  {
    double most = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      most = std::max(most, distanceOf(ends[i]));
    }
    return most;
  };
  const Vec3 middle = functions.InUnits(region.outline.Middle());
  const std::optional<Vec3> start = FindStart(functions, node, region);
  if (!start)
  {
    return {};
  }
  KeptExpansion single;
  KeptExpansion& expansion = kept != nullptr && functions.HasJet() ? *kept : single;
  const bool isKept = expansion.jet &&
    std::ranges::all_of(node.wideEnds,
      [&](const EdgeNodeEnd& end) { return end.DepthOf(expansion.view->xi) >= 0.0; });
  EdgeFunctions::View view =
    isKept ? *expansion.view : functions.ViewAt(MovedInto(shape, node, *start));
  for (int step = 0; step < kMiddleSteps && !isKept; ++step)
  {
    const double reach = farthest(
      [&](const Vec3& end)
      {
        const Vec3 half = view.inverse * (end - middle);
        return glm::dot(half, half);
      });
    const Vec3 next = MovedInto(shape, node, view.xi + view.inverse * (middle - view.y));
    const Vec3 moved = next - view.xi;
    // The comparison is written so that a NaN ends the loop.
    if (!(glm::dot(moved, moved) > reach))
    {
      break;
    }
    view = functions.ViewAt(next);
  }

  // |xi - view.xi| for the preimages in `wide` of the region's points.
  const double inY = slack / functions.Size() + functions.ImageError() +
    kSum * std::max(LargestOf(view.y), farthest(LargestOf));
  double away[3];
  double besides[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    besides[k] = node.shift[k] + node.lean[k] * inY + 1e-14;
    away[k] = farthest(
                [&](const Vec3& end)
                {
                  const Vec3 d = end - view.y;
                  return std::fabs(row[0] * d.x + row[1] * d.y + row[2] * d.z);
                }) *
        kUp +
      besides[k];
  }
  Solve(node.solution, away);
  for (std::size_t k = 0; k < 3; ++k)
  {
    // No xi of the node is farther away.
    const int d = static_cast<int>(k);
    away[k] = std::min(away[k], (node.reach[k] + std::fabs(view.xi[d] - node.centre[d])) * kUp);
  }
  std::array<Vec3, Outline::kMaxCorners> steps;
  std::ranges::transform(std::span(ends).first(count), steps.begin(),
    [&](const Vec3& end) { return view.inverse * (end - view.y); });
  // The residual of the steps' equations, in y, from the computed Jacobian and its inverse.
  const Vec3 columns =
    glm::abs(view.jacobian[0]) + glm::abs(view.jacobian[1]) + glm::abs(view.jacobian[2]);
  double left = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    left = std::max(left,
      LargestOf(ends[i] - view.y - view.jacobian * steps[i]) +
        kSum * LargestOf(columns) * LargestOf(steps[i]) +
        functions.ImageSlopeError() * SumOf(steps[i]));
  }
  double farther[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    besides[k] += node.lean[k] * left;
    farther[k] = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      farther[k] = std::max(farther[k], std::fabs(steps[i][static_cast<int>(k)]));
    }
  }
  // The preimages are within `off` of the expansion's, and therefore no farther away than this.
  double off[3];
  for (int round = 0; round < kRounds; ++round)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      off[k] = (Quadratic(node.bend[k], away) / 2.0 + besides[k]) * kUp;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      away[k] = std::min(away[k], (farther[k] + off[k]) * kUp);
    }
  }
  for (Vec3& step : steps)
  {
    step += view.xi;
  }
  if (functions.HasJet() && !isKept)
  {
    expansion.view = view;
    expansion.jet = functions.ValueAndSlopeAt(0, view.xi);
  }
  EdgeMeeting meeting;
  const auto find = [&](LocalExpansion* local)
  {
    Outline inside = KeepDeep(node, off, Outline(std::span(steps).first(count)));
    if (face)
    {
      const double most = face->Across(off) * kUp + kBesideFace;
      inside.Keep([&](const Vec3& xi) { return most - face->DepthOf(xi); });
    }
    if (inside.IsEmpty())
    {
      meeting = {};
      return;
    }
    const auto [linear, slope] = functions.LinearValues(
      view.xi, inside.Corners(), node.slopeError, expansion.jet ? &*expansion.jet : nullptr);
    double curved = Quadratic(node.curve, away) / 2.0;
    if (local)
    {
      curved = std::min(curved, local->Curved(away, slope, node.slopeError));
    }
    // The part that is no polynomial, minus its own linear expansion.
    double loose = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      loose += 2.0 * node.beside[k] * away[k];
    }
    curved += loose;
    const bool isWide = curved > kCoarse * (linear.upper - linear.lower);
    // Smaller nodes lower this part of an expression's bounds.
    const double lowered = std::min(curved, Quadratic(node.rough, away) / 2.0 + loose);
    double most = curved + 2.0 * node.valueError;
    meeting = {};
    bool isLarger = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      most += node.slope[k] * besides[k];
      isLarger = isLarger || node.reach[k] > 2.0 * away[k];
      meeting.bends = meeting.bends || off[k] > kCoarse * away[k] + 2.0 * besides[k];
    }
    if (functions.HasJet())
    {
      // Without that part, the values may be excluded.
      const double least = most - lowered;
      const bool isLoose = isLarger && !wanted.Meets(linear.lower - least, linear.upper + least);
      meeting.bends = meeting.bends || isLoose;
      meeting.curves = isLoose;
    }
    else
    {
      meeting.curves = isWide && isLarger;
    }
    most = most * kUp + kRoundoffs * (std::fabs(linear.lower) + std::fabs(linear.upper));
    meeting.values =
      Interval(rounding::Below(linear.lower - most), rounding::Above(linear.upper + most));
  };
  find(nullptr);
  if (!node.slopes || !meeting.values ||
    !wanted.Meets(meeting.values->lower, meeting.values->upper))
  {
    return meeting;
  }
  LocalExpansion local(node, view, functions.ImageSlopeError());
  for (int round = 0; round < kLocalRounds && local.IsKnown(); ++round)
  {
    double own[3];
    local.Off(away, own);
    for (std::size_t k = 0; k < 3; ++k)
    {
      off[k] = std::min(off[k], (own[k] + besides[k]) * kUp);
      away[k] = std::min(away[k], (farther[k] + off[k]) * kUp);
    }
  }
  if (local.IsKnown())
  {
    find(&local);
  }
  return meeting;
}
} // namespace pixelexact
