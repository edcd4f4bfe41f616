// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/InversionNode.h"

#include "Core/Bernstein/BernsteinForm.h"
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

/// s_d: the extent of the shape that eta_d is relative to.
template <class Number>
Number Extent(Shape shape, int direction, const std::array<Number, 3>& xi)
{
  const Number one(1.0);
  const Number half(0.5);
  if (shape == Shape::Tetrahedron && direction == 0)
  {
    return half * (-xi[1] - xi[2]);
  }
  const bool collapses = direction == 0
    ? shape != Shape::Hexahedron
    : direction == 1 && (shape == Shape::Tetrahedron || shape == Shape::Pyramid);
  return collapses ? half * (one - xi[2]) : one;
}

/// 1 + xi_d - (1 + b) s_d: positive beyond the end eta_d = b.
template <class Number>
Number Beyond(Shape shape, int direction, double end, const std::array<Number, 3>& xi)
{
  return Number(1.0) + xi[static_cast<std::size_t>(direction)] -
    (Number(1.0) + Number(end)) * Extent(shape, direction, xi);
}

/// Whether eta_d = 1 is a collapsed edge or vertex.
bool CollapsesAt(Shape shape, int direction)
{
  return shape != Shape::Hexahedron &&
    (direction == 2 || (shape == Shape::Tetrahedron && direction == 1));
}

Interval HullOfFinite(std::span<const double> coefficients, double error)
{
  double least = kInfinity;
  double most = -kInfinity;
  bool sound = error < kInfinity;
  for (const double b : coefficients)
  {
    least = std::min(least, b);
    most = std::max(most, b);
    sound = sound && std::fabs(b) < kInfinity;
  }
  return sound ? rounding::Outward(least - error, most + error) : Interval::Everything();
}

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
      const auto count = static_cast<std::size_t>(Degree[direction] + 1);
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
            t += inverse[c] * (Phi.values[c * Size + at] - Node.origin[c]);
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

bool InversionNode::MightHold(Shape shape, const std::array<double, 3>& y) const
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (!hull[c].Contains(y[c]))
    {
      return false;
    }
  }
  if (!framed)
  {
    return true;
  }
  // The rounding of these products is within the deviation.
  std::array<Interval, 3> xi;
  for (std::size_t d = 0; d < 3; ++d)
  {
    double start = centre[static_cast<int>(d)];
    for (std::size_t c = 0; c < 3; ++c)
    {
      start += inverse[3 * d + c] * (y[c] - origin[c]);
    }
    xi[d] = Interval(start) - deviation[d];
  }
  for (int d = 0; d < 3; ++d)
  {
    if (Beyond(shape, d, box.upper[d], xi).lower > 0.0 ||
      Beyond(shape, d, box.lower[d], xi).upper < 0.0)
    {
      return false;
    }
  }
  return true;
}

Vec3 InversionNode::Guess(const std::array<double, 3>& y) const
{
  Vec3 xi = centre;
  for (std::size_t d = 0; framed && d < 3; ++d)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      xi[static_cast<int>(d)] += inverse[3 * d + c] * (y[c] - origin[c]);
    }
  }
  return glm::clamp(xi, Vec3(-1.0), Vec3(1.0));
}

bool InversionNode::IsNearlyAffine() const
{
  double largest = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    largest = std::max(largest, deviation[d].Magnitude());
  }
  return framed &&
    largest <=
    std::max({ box.upper.x - box.lower.x, box.upper.y - box.lower.y, box.upper.z - box.lower.z });
}

void MakeFrame(const Space& space, const double* modes, const ElementBounds& bounds,
  const BoxCoefficients& phi, InversionNode& node)
{
  const std::size_t size = phi.values.size() / 3;
  std::array<double, 3> magnitude{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto component = std::span(phi.values).subspan(c * size, size);
    node.hull[c] =
      HullOfFinite(component, rounding::Above(phi.error[c] + 2.0 * bounds.uncertainty[c]));
    magnitude[c] = node.hull[c].Magnitude();
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
      // here and in MightHold, where y lies in the hull.
      double slack = Gamma(32) * 4.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        slack += std::fabs(node.inverse[3 * d + c]) *
          (phi.error[c] + 2.0 * bounds.uncertainty[c] +
            Gamma(32) * (2.0 * magnitude[c] + 2.0 * std::fabs(node.origin[c])));
      }
      const DeviationRow row = maker.Make(d, slack * (1.0 + Gamma(64)));
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

double ReachOf(const std::array<int, 3>& degree)
{
  return 1.0 / (4.0 * std::max(1, degree[0] + degree[1] + degree[2]));
}

bool IsRegular(const std::array<int, 3>& degree, const BoxCoefficients& slopes)
{
  const std::size_t size = slopes.values.size() / 9;
  // Bernstein polynomials beyond the box sum in magnitude to less than (1 + 2 reach)^degrees; and
  // a root that is taken to lie in the box may be beyond it by a tolerance of 1e-12.
  const double growth =
    std::pow(1.0 + 2.0 * ReachOf(degree), degree[0] + degree[1] + degree[2]) * (1.0 + 1e-6);
  std::array<std::array<Interval, 3>, 3> jacobian;
  SmallMatrix middle{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t at = 3 * c + j;
      const Interval hull =
        HullOfFinite(std::span(slopes.values).subspan(at * size, size), slopes.error[at]);
      if (!hull.IsFinite())
      {
        return false;
      }
      middle[c][j] = hull.Middle();
      jacobian[c][j] =
        Interval::Around(middle[c][j], rounding::Above(hull.RadiusAround(middle[c][j]) * growth));
    }
  }
  const auto inverse = Inverse(3, middle);
  if (!inverse)
  {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    double diagonal = 0.0;
    Interval others(0.0);
    for (std::size_t j = 0; j < 3; ++j)
    {
      Interval entry(0.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        entry += Interval((*inverse)[i][c]) * jacobian[c][j];
      }
      if (i == j)
      {
        diagonal = entry.lower;
      }
      else
      {
        others += Abs(entry);
      }
    }
    if (!(diagonal > others.upper + 1e-6))
    {
      return false;
    }
  }
  return true;
}

bool Reaches(Shape shape, const EtaBox& box, double reach, const Vec3& xi, double tolerance)
{
  const std::array<double, 3> at{ xi.x, xi.y, xi.z };
  for (int d = 0; d < 3; ++d)
  {
    const double margin = reach * (box.upper[d] - box.lower[d]);
    const double lower = box.lower[d] - margin;
    const double upper =
      CollapsesAt(shape, d) ? std::min(1.0, box.upper[d] + margin) : box.upper[d] + margin;
    if (!(Beyond(shape, d, upper, at) <= tolerance) || !(Beyond(shape, d, lower, at) >= -tolerance))
    {
      return false;
    }
  }
  return true;
}
} // namespace pixelexact
