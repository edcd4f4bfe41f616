// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/InversionNode.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The value and the Jacobian of Phi at a point, in plain arithmetic.
void EvaluateAt(const Space& space, const double* modes, const Vec3& xi,
  std::array<double, 3>& value, SmallMatrix& jacobian)
{
  double lanes[15][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(lanes[d], kLanePadding, xi[d]);
  }
  double* out[3] = { lanes[3], lanes[4], lanes[5] };
  double* gradient[9];
  for (int k = 0; k < 9; ++k)
  {
    gradient[k] = lanes[6 + k];
  }
  KernelsFor(space).gradient(
    space, modes, 3, { { lanes[0], lanes[1], lanes[2] }, 1 }, out, gradient);
  for (std::size_t c = 0; c < 3; ++c)
  {
    value[c] = out[c][0];
    for (std::size_t d = 0; d < 3; ++d)
    {
      jacobian[c][d] = gradient[3 * c + d][0];
    }
  }
}

/// The deviation's coefficients of one row, and what is made of them.
struct DeviationRow
{
  Interval hull;
  std::array<double, 3> variation{}; ///< largest difference of neighbours, times the degree
};

class FrameMaker
{
public:
  FrameMaker(const Space& space, const BoxCoefficients& phi, InversionNode& node)
    : TheShape(space.shape)
    , Degree(space.TensorDegree())
    , Phi(phi)
    , Node(node)
    , Size(phi.values.size() / 3)
    , Row(Size)
  {
  }

  DeviationRow Make(std::size_t d, double slack)
  {
    Fill(d);
    DeviationRow result;
    const auto [low, high] = std::ranges::minmax_element(Row);
    const bool sound = std::ranges::all_of(Row, [](double v) { return std::isfinite(v); });
    result.hull = sound && slack < kInfinity ? rounding::Outward(*low - slack, *high + slack)
                                             : Interval::Everything();
    std::size_t stride = Size;
    for (std::size_t direction = 0; direction < 3; ++direction)
    {
      const auto count = static_cast<std::size_t>(Degree[direction]) + 1;
      stride /= count;
      double largest = 0.0;
      for (std::size_t at = 0; at < Size; ++at)
      {
        if (at / stride % count + 1 < count)
        {
          largest = std::max(largest, std::fabs(Row[at + stride] - Row[at]));
        }
      }
      result.variation[direction] = largest * static_cast<double>(count - 1);
    }
    return result;
  }

private:
  void Fill(std::size_t d)
  {
    const double* inverse = &Node.inverse[3 * d];
    std::size_t at = 0;
    for (int i = 0; i <= Degree[0]; ++i)
    {
      for (int j = 0; j <= Degree[1]; ++j)
      {
        for (int k = 0; k <= Degree[2]; ++k, ++at)
        {
          // xi is affine in each eta, so its coefficients are its values on the grid.
          const Vec3 xi = TensorToReference(TheShape, GridPoint(i, j, k));
          double t = Node.centre[static_cast<int>(d)] - xi[static_cast<int>(d)];
          for (std::size_t c = 0; c < 3; ++c)
          {
            t += inverse[c] * (Phi.values[c * Size + at] - (Node.origin[c] - Phi.base[c]));
          }
          Row[at] = t;
        }
      }
    }
  }

  [[nodiscard]] Vec3 GridPoint(int i, int j, int k) const
  {
    const std::array<int, 3> index{ i, j, k };
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      const auto at = static_cast<std::size_t>(d);
      const double part = Degree[at] == 0 ? 0.5 : static_cast<double>(index[at]) / Degree[at];
      eta[d] = Node.box.lower[d] + part * (Node.box.upper[d] - Node.box.lower[d]);
    }
    return eta;
  }

  Shape TheShape;
  std::array<int, 3> Degree;
  const BoxCoefficients& Phi;
  const InversionNode& Node;
  std::size_t Size;
  std::vector<double> Row;
};
} // namespace

void MakeFrame(const Space& space, const double* modes, const ElementBounds& bounds,
  const BoxCoefficients& phi, InversionNode& node)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double slack = bounds.uncertainty[c];
    node.hull[c] = phi.HullOf(c) + Interval(phi.base[c]) + Interval(-slack, slack);
  }
  const Vec3 eta = 0.5 * (node.box.lower + node.box.upper);
  node.centre = TensorToReference(space.shape, eta);
  SmallMatrix jacobian;
  EvaluateAt(space, modes, node.centre, node.origin, jacobian);
  const auto inverse = Inverse(3, jacobian);
  node.framed = inverse.has_value();
  std::array<double, 3> variation{};
  if (node.framed)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      std::ranges::copy((*inverse)[d], &node.inverse[3 * d]);
    }
    FrameMaker maker(space, phi, node);
    for (std::size_t d = 0; d < 3; ++d)
    {
      // The coefficients' errors, the uncertainty of Phi and y, and the rounding of the products
      // here and in MightHold, where y lies in the hull; sums are below 2 and these products.
      double slack = Gamma(32);
      for (std::size_t c = 0; c < 3; ++c)
      {
        slack += std::fabs(node.inverse[3 * d + c]) *
          (phi.error[c] + bounds.uncertainty[c] +
            Gamma(32) * node.hull[c].RadiusAround(node.origin[c]));
      }
      slack *= 1.0 + Gamma(64);
      node.slack[d] = slack;
      const DeviationRow row = maker.Make(d, slack);
      node.deviation[d] = row.hull;
      for (std::size_t direction = 0; direction < 3; ++direction)
      {
        variation[direction] = std::max(variation[direction], row.variation[direction]);
      }
    }
  }
  if (space.shape == Shape::Pyramid && node.box.upper.z == 1.0)
  {
    // A cone: seen from the apex, directions can only be told apart at the point's own distance.
    node.widest = 2;
    return;
  }
  // Where the deviation says nothing, or no more than rounding, the longest side.
  const Vec3 width = node.box.upper - node.box.lower;
  const double largest = std::max({ variation[0], variation[1], variation[2] });
  const double longest = std::max({ width.x, width.y, width.z });
  double best = -1.0;
  for (int d = 0; d < 3; ++d)
  {
    const double share = largest > 0.0 && std::isfinite(largest)
      ? variation[static_cast<std::size_t>(d)] / largest
      : 0.0;
    const double telling = share + 0.1 * width[d] / longest;
    if (telling > best)
    {
      best = telling;
      node.widest = d;
    }
  }
}

std::array<double, 3> EvaluateMap(const Space& space, const double* modes, const Vec3& xi)
{
  std::array<double, 3> value;
  SmallMatrix jacobian;
  EvaluateAt(space, modes, xi, value, jacobian);
  return value;
}

std::optional<SmallMatrix> InverseJacobian(const Space& space, const double* modes, const Vec3& xi)
{
  std::array<double, 3> value;
  SmallMatrix jacobian;
  EvaluateAt(space, modes, xi, value, jacobian);
  return Inverse(3, jacobian);
}
} // namespace pixelexact
