// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeNode.h"

#include "Core/Math/Mat.h"
#include "Core/Questions/EdgeArithmetic.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pixelexact
{
using namespace edges;

namespace
{
/// The margin on either side of a box, relative to its sides.
constexpr double kMargin = 0.25;
/// The largest row sums of (I - |M J - I|)^-1 of a regular box, with xi in lengths in space.
constexpr double kMaxSolution = 10.0 / 3.0;
/// The fraction of the row sums that the Jacobians along a box's middle lines must explain to
/// determine the direction.
constexpr double kExplained = 0.125;
/// Subdivisions of a box on which the map is regular, after which bounds of the field are
/// abandoned.
constexpr int kMaxUnbounded = 12;
/// Affine bounds of the second derivatives are kept where their remainder is at most this fraction
/// of the constant bounds along straight lines.
constexpr double kSharper = 0.5;

/// The direction of eta across which the Jacobian changes most along the middle lines of a box,
/// measured by its row sums with xi in lengths, `sides`. None where no change exceeds `least`. Thin
/// elements that bend turn along their length alone, however much wider their boxes are in other
/// directions.
std::optional<int> TurningDirection(
  const EdgeFunctions& functions, const EdgeNode& node, const double (&sides)[3], double least)
{
  const Vec3 middle = 0.5 * (node.wide.lower + node.wide.upper);
  const Mat3 atMiddle = functions.ViewAt(node.centre).jacobian;
  std::optional<int> direction;
  for (int d = 0; d < 3; ++d)
  {
    for (const double end : { node.wide.lower[d], node.wide.upper[d] })
    {
      Vec3 eta = middle;
      eta[d] = end;
      const Mat3 change =
        functions.ViewAt(TensorToReference(functions.GetShape(), eta)).jacobian - atMiddle;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto& row = node.inverse[i];
        const Vec3 turned = Vec3(row[0], row[1], row[2]) * change;
        const double sum = sides[i] *
          (std::fabs(turned.x) / sides[0] + std::fabs(turned.y) / sides[1] +
            std::fabs(turned.z) / sides[2]);
        if (sum > least)
        {
          least = sum;
          direction = d;
        }
      }
    }
  }
  return direction;
}
} // namespace

std::array<EdgeNodeEnd, 6> EndsOf(Shape shape, const EtaBox& box)
{
  const auto normals = EndNormals(shape, box);
  std::array<EdgeNodeEnd, 6> ends;
  for (int k = 0; k < 6; ++k)
  {
    EdgeNodeEnd& end = ends[static_cast<std::size_t>(k)];
    std::copy_n(normals[static_cast<std::size_t>(k)], 3, end.normal);
    end.offset = DepthOf(shape, box, k, Vec3(0.0));
    end.ofElement = k % 2 == 1 ? box.upper[k / 2] == 1.0 : box.lower[k / 2] == -1.0;
  }
  return ends;
}

void EdgeNode::Describe(const EdgeFunctions& functions, const Interval& those)
{
  const Vec3 sides = box.upper - box.lower;
  const Vec3 margin = kMargin * sides;
  wide.lower = glm::max(box.lower - margin, Vec3(-1.0));
  wide.upper = glm::min(box.upper + margin, Vec3(1.0));
  values = those;
  const int wider = sides.x >= sides.y ? 0 : 1;
  direction = sides[wider] >= sides.z ? wider : 2;
  const EdgeFunctions::MapRanges map = functions.MapOver(wide);
  bounds = map.image;
  // The bounds that follow cost more.
  if (!DescribeMap(functions, map))
  {
    values = functions.NarrowedOver(wide, those);
    return;
  }
  boxEnds = EndsOf(functions.GetShape(), box);
  wideEnds = EndsOf(functions.GetShape(), wide);
  const EdgeFunctions::Derivatives derivatives = functions.DerivativesOver(wide, map);
  values = derivatives.values;
  DescribeCurves(functions, derivatives);
}

bool EdgeNode::DescribeMap(const EdgeFunctions& functions, const EdgeFunctions::MapRanges& map)
{
  const Shape shape = functions.GetShape();
  const Vec3 away = ReachOf(shape, wide);
  centre = CentreOf(shape, wide);
  origin = functions.ViewAt(centre).y;
  Mat3 middle;
  for (int c = 0; c < 3; ++c)
  {
    for (int j = 0; j < 3; ++j)
    {
      const Interval& range = map.slopes[static_cast<std::size_t>(c)][static_cast<std::size_t>(j)];
      if (!range.IsFinite())
      {
        return false;
      }
      middle[j][c] = range.Middle();
    }
  }
  const Mat3 unturned = glm::inverse(middle);
  const double sides[3] = { glm::length(middle[0]), glm::length(middle[1]),
    glm::length(middle[2]) };
  double most = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      inverse[i][j] = unturned[static_cast<int>(j)][static_cast<int>(i)];
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      Interval entry(i == j ? -1.0 : 0.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        entry += Interval(inverse[i][c]) * map.slopes[c][j];
      }
      turn[i][j] = entry.Magnitude() * kUp;
      sum += turn[i][j] * (sides[i] / sides[j]);
    }
    most = std::max(most, sum);
    reach[i] = away[static_cast<int>(i)];
  }
  straight = BoundSolution(turn, kMaxSolution, solution);
  if (straight)
  {
    return true;
  }
  flat = functions.IsFlatOver(box);
  if (!flat)
  {
    direction = TurningDirection(functions, *this, sides, kExplained * most).value_or(direction);
  }
  return BoundSolution(turn, sides, kMaxSolution, solution);
}

void EdgeNode::DescribeCurves(
  const EdgeFunctions& functions, const EdgeFunctions::Derivatives& derivatives)
{
  const auto& ranges = derivatives.map;
  const auto& components = derivatives.components;
  // The norm over all components: the Euclidean norm of bounds bounds that of vectors.
  const auto norm = [&components](auto&& of)
  {
    double sum = 0.0;
    for (const auto& one : components)
    {
      const double magnitude = of(one).Magnitude();
      sum += magnitude * magnitude;
    }
    return components.size() == 1 ? of(components.front()).Magnitude() : std::sqrt(sum) * kUp;
  };
  double bends[6][3];
  for (std::size_t p = 0; p < 6; ++p)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      Interval entry(0.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        entry += Interval(inverse[k][c]) * ranges[c].second[p];
      }
      bends[p][k] = entry.Magnitude();
    }
    Solve(solution, bends[p]);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    slope[k] = norm([k](const HessianFunction::XiRanges& one) { return one.first[k]; });
    lean[k] = 0.0;
    shift[k] = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      lean[k] += std::fabs(inverse[k][c]);
      shift[k] += std::fabs(inverse[k][c]) * kMaxMiss * functions.Uncertainty()[c];
    }
  }
  std::ranges::copy(derivatives.beside, beside);
  Solve(solution, lean);
  Solve(solution, shift);
  bool finite = true;
  for (std::size_t p = 0; p < 6; ++p)
  {
    const double twice = kRows[p] == kColumns[p] ? 1.0 : 2.0;
    curve[p] = norm([p](const HessianFunction::XiRanges& one) { return one.second[p]; });
    for (std::size_t k = 0; k < 3; ++k)
    {
      bend[k][p] = twice * bends[p][k];
      curve[p] += slope[k] * bends[p][k];
    }
    curve[p] *= twice * kUp;
    finite = finite && std::isfinite(curve[p]);
  }
  for (std::size_t f = 0; f < 3; ++f)
  {
    second[f] = ranges[f].second;
  }
  for (std::size_t p = 0; p < 6; ++p)
  {
    const double most = norm([p](const HessianFunction::XiRanges& one) { return one.second[p]; });
    second[3][p] = components.size() == 1 ? components.front().second[p] : Interval(-most, most);
  }
  std::ranges::copy(curve, rough);
  if (derivatives.curves)
  {
    DescribeSlopes(*derivatives.curves);
  }
  DescribeModel(functions, ranges);
  const auto [ofValues, ofSlopes] = functions.ErrorsWith(derivatives);
  valueError = ofValues;
  slopeError = ofSlopes;
  regular = finite && std::isfinite(valueError) && std::isfinite(slopeError) &&
    std::isfinite(beside[0] + beside[1] + beside[2]);
  straight = straight && regular;
  // An expression that is still not bounded has a pole, or is not smooth.
  flat = flat || (functions.HasJet() && !regular && subdivisions >= kMaxUnbounded);
}

void EdgeNode::DescribeSlopes(const EdgePolynomials::Curves& curves)
{
  auto made = std::make_unique<Slopes>();
  for (std::size_t p = 0; p < 6; ++p)
  {
    const double twice = kRows[p] == kColumns[p] ? 1.0 : 2.0;
    const auto add = [](double factor, const AffineBound& bound, AffineBound& sum)
    {
      const double size = std::fabs(factor);
      sum.value += factor * bound.value;
      double largest = std::fabs(bound.value);
      for (std::size_t k = 0; k < 3; ++k)
      {
        sum.slope[k] += factor * bound.slope[k];
        largest += std::fabs(bound.slope[k]);
      }
      // Covers the rounding of xi - centre, which is at most 2.
      sum.radius += size * (bound.radius + 2.0 * kRoundoffs * largest) * kUp;
    };
    add(twice, curves.functions.front()[p], made->curve[p]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        add(twice * inverse[k][c], curves.map[c][p], made->bend[k][p]);
      }
    }
  }
  double before = 0.0;
  double after = 0.0;
  for (std::size_t p = 0; p < 6; ++p)
  {
    before += curve[p];
    after += made->curve[p].radius;
    for (std::size_t k = 0; k < 3; ++k)
    {
      after += slope[k] * made->bend[k][p].radius;
    }
  }
  if (after <= kSharper * before)
  {
    slopes = std::move(made);
    for (std::size_t p = 0; p < 6; ++p)
    {
      rough[p] = slopes->curve[p].radius;
      for (std::size_t k = 0; k < 3; ++k)
      {
        rough[p] += slope[k] * slopes->bend[k][p].radius;
      }
    }
  }
}
} // namespace pixelexact
