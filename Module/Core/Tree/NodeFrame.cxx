// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/NodeFrame.h"

#include "Core/Math/Rounding.h"
#include "Core/Tree/FrameKernels.h"
#include "Core/Tree/Regularity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

/// Whether the extent s_d that eta_d is relative to falls with xi_3.
bool IsTilted(Shape shape, int direction)
{
  return direction == 0
    ? shape != Shape::Hexahedron
    : direction == 1 && (shape == Shape::Tetrahedron || shape == Shape::Pyramid);
}

/// The outward normal in xi of the end eta_d = b of a box: of 1 + xi_d - (1 + b) s_d(xi).
Vec3 EndNormal(Shape shape, int direction, double end, double sign)
{
  Vec3 normal(0.0);
  normal[direction] = sign;
  const double tilt = sign * 0.5 * (1.0 + end);
  if (IsTilted(shape, direction))
  {
    normal.z = tilt;
    normal.y = shape == Shape::Tetrahedron && direction == 0 ? tilt : normal.y;
  }
  return normal;
}

/// The arrays of FrameTask, kept by each thread.
class FrameArrays
{
public:
  FrameArrays(const Space& space, const BoxCoefficients& phi, const NodeFrame& frame)
    : Size(phi.values.size() / 3)
    , Padded(std::max(Size, static_cast<std::size_t>(kLanePadding)))
    , Values(OfThread())
  {
    if (Values.size() < 9 * Padded)
    {
      Values.resize(9 * Padded);
    }
    MakeGrid(space.shape, space.TensorDegree(), frame);
    for (std::size_t c = 0; c < 3; ++c)
    {
      From[c] = phi.Of(c).data();
      if (Padded > Size)
      {
        std::copy_n(From[c], Size, Row(6 + c));
        Fill(Row(6 + c));
        From[c] = Row(6 + c);
      }
    }
  }

  [[nodiscard]] FrameTask Task(
    const NodeFrame& frame, const BoxCoefficients& phi, std::span<const double[3]> normal)
  {
    FrameTask task{};
    task.size = Padded;
    task.inverse = frame.inverse.data();
    task.normal = normal.empty() ? nullptr : normal.data();
    for (std::size_t c = 0; c < 3; ++c)
    {
      task.phi[c] = From[c];
      task.shift[c] = frame.origin[c] - phi.base[c];
      task.grid[c] = Row(c);
      task.deviation[c] = Row(3 + c);
    }
    return task;
  }

  /// Of each row of the deviation, the largest difference of neighbours in each direction of eta.
  [[nodiscard]] SmallMatrix Steps(const std::array<int, 3>& degree)
  {
    SmallMatrix steps{};
    std::size_t stride = Size;
    for (std::size_t direction = 0; direction < 3; ++direction)
    {
      const auto count = static_cast<std::size_t>(degree[direction]) + 1;
      stride /= count;
      for (std::size_t d = 0; d < 3; ++d)
      {
        steps[d][direction] = GetFrameKernels().largestStep(Row(3 + d), Size, count, stride);
      }
    }
    return steps;
  }

private:
  static std::vector<double>& OfThread()
  {
    thread_local std::vector<double> values;
    return values;
  }
  double* Row(std::size_t k) { return &Values[k * Padded]; }
  void Fill(double* row) const { std::fill(row + Size, row + Padded, row[Size - 1]); }

  /// xi is affine in each eta, so its coefficients are its values on the grid.
  void MakeGrid(Shape shape, const std::array<int, 3>& degree, const NodeFrame& frame)
  {
    const auto eta = [&](int d, int i)
    {
      const int n = degree[static_cast<std::size_t>(d)];
      const double part = n == 0 ? 0.5 : static_cast<double>(i) / n;
      return frame.box.lower[d] + part * (frame.box.upper[d] - frame.box.lower[d]);
    };
    std::size_t at = 0;
    for (int i = 0; i <= degree[0]; ++i)
    {
      for (int j = 0; j <= degree[1]; ++j)
      {
        // Affine along a line.
        const Vec3 first = TensorToReference(shape, { eta(0, i), eta(1, j), eta(2, 0) });
        const Vec3 last = TensorToReference(shape, { eta(0, i), eta(1, j), eta(2, degree[2]) });
        const Vec3 from = first - frame.centre;
        const Vec3 step = (last - first) / static_cast<double>(std::max(1, degree[2]));
        for (int d = 0; d < 3; ++d)
        {
          double* row = Row(static_cast<std::size_t>(d)) + at;
          for (int k = 0; k <= degree[2]; ++k)
          {
            row[k] = from[d] + k * step[d];
          }
        }
        at += static_cast<std::size_t>(degree[2]) + 1;
      }
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
      Fill(Row(d));
    }
  }

  std::size_t Size;
  std::size_t Padded;
  std::vector<double>& Values; ///< three rows each: grid, deviation, coefficients where padded
  std::array<const double*, 3> From{};
};

/// s_d at a xi.
double ExtentAt(Shape shape, int direction, const Vec3& xi)
{
  if (shape == Shape::Tetrahedron && direction == 0)
  {
    return 0.5 * (-xi.y - xi.z);
  }
  return IsTilted(shape, direction) ? 0.5 * (1.0 - xi.z) : 1.0;
}

/// A bound, over a hexahedron's box and its reach, of the sums over j of |d T_d / d xi_j|: of the
/// derivatives' coefficients, which are differences of neighbours times the degree.
double SlopeOf(const std::array<int, 3>& degree, const SmallMatrix& steps, const NodeFrame& frame)
{
  double largest = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      const auto axis = static_cast<int>(j);
      sum += (steps[d][j] + 2.0 * frame.slack[d]) * degree[j] /
        (frame.box.upper[axis] - frame.box.lower[axis]);
    }
    largest = std::max(largest, sum);
  }
  return largest * GrowthInReach(degree) * (1.0 + Gamma(16));
}

/// The outward normals in xi of a box's ends.
std::array<double[3], 6> EndNormals(Shape shape, const EtaBox& box)
{
  std::array<double[3], 6> normal{};
  for (int k = 0; k < 6; ++k)
  {
    const Vec3& end = k % 2 == 1 ? box.upper : box.lower;
    const Vec3 n = EndNormal(shape, k / 2, end[k / 2], k % 2 == 1 ? 1.0 : -1.0);
    for (int d = 0; d < 3; ++d)
    {
      normal[static_cast<std::size_t>(k)][d] = n[d];
    }
  }
  return normal;
}

/// What rounding and uncertainty add to the products of a row with Phi - origin: the coefficients'
/// errors, the uncertainty of Phi and y, and the rounding of the products here and in Judge
/// (TreeKernels.h), where y lies in the hull; sums are below 2 and these products.
class Slack
{
public:
  Slack(const ElementBounds& bounds, const BoxCoefficients& phi, const NodeFrame& frame)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      Around[c] = phi.error[c] + bounds.uncertainty[c] +
        Gamma(32) * frame.hull[c].RadiusAround(frame.origin[c]);
    }
  }

  double Of(const double* row) const
  {
    double slack = Gamma(64);
    for (std::size_t c = 0; c < 3; ++c)
    {
      slack += std::fabs(row[c]) * Around[c];
    }
    return slack * (1.0 + Gamma(64));
  }

private:
  std::array<double, 3> Around{};
};

void SetOuter(double most, const ElementBounds& bounds, ImagePlane& plane)
{
  double wider = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    wider += std::fabs(plane.normal[c]) * bounds.uncertainty[c];
  }
  plane.outer = NextUp(most);
  plane.wider = NextUp(plane.outer + 2.0 * wider);
}

/// Deviation and planes; returns along which directions of eta the deviation varies how much.
std::array<double, 3> Measure(const Space& space, const ElementBounds& bounds, const Slack& slackOf,
  FrameArrays& arrays, const BoxCoefficients& phi, NodeFrame& frame)
{
  const auto normal = EndNormals(space.shape, frame.box);
  const bool cube = space.shape == Shape::Hexahedron;
  const FrameTask task =
    arrays.Task(frame, phi, cube ? std::span<const double[3]>() : std::span(normal));
  const FrameSums sums = GetFrameKernels().measure(task);
  for (std::size_t d = 0; d < 3; ++d)
  {
    const double slack = slackOf.Of(&frame.inverse[3 * d]);
    frame.slack[d] = slack;
    frame.deviation[d] = sums.all == 0.0 && slack < kInfinity
      ? rounding::Outward(sums.least[d] - slack, sums.most[d] + slack)
      : Interval::Everything();
  }
  for (std::size_t k = 0; k < 6; ++k)
  {
    ImagePlane& plane = frame.plane[k];
    // Of the products with the rows, which may cancel in the normal.
    double rounding = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        const double part = normal[k][d] * frame.inverse[3 * d + c];
        plane.normal[c] += part;
        rounding += std::fabs(part) * Gamma(32) * frame.hull[c].RadiusAround(frame.origin[c]);
      }
    }
    const double slack = (slackOf.Of(plane.normal.data()) + rounding) * (1.0 + Gamma(64));
    if (sums.all != 0.0 || !(slack < kInfinity))
    {
      continue;
    }
    const auto direction = static_cast<int>(k / 2);
    const double sign = k % 2 == 1 ? 1.0 : -1.0;
    const double end = (k % 2 == 1 ? frame.box.upper : frame.box.lower)[direction];
    // How far the centre is from the end, along the normal.
    const double depth = -sign *
      (1.0 + frame.centre[direction] -
        (1.0 + end) * ExtentAt(space.shape, direction, frame.centre));
    SetOuter(sums.outer[k] + slack, bounds, plane);
    plane.inner = NextDown(depth + sums.inner[k] - slack);
  }
  const auto degree = space.TensorDegree();
  const SmallMatrix steps = arrays.Steps(degree);
  if (space.shape == Shape::Hexahedron && sums.all == 0.0)
  {
    frame.slope = SlopeOf(degree, steps, frame);
  }
  std::array<double, 3> variation{};
  for (std::size_t j = 0; j < 3; ++j)
  {
    variation[j] = std::max({ steps[0][j], steps[1][j], steps[2][j] }) * degree[j];
  }
  return variation;
}

/// Where a frame looks at the map: at the box's middle and in the middle of each end.
std::array<Vec3, 7> MiddlesOf(Shape shape, const EtaBox& box)
{
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  std::array<Vec3, 7> xi;
  xi.fill(TensorToReference(shape, middle));
  for (int k = 0; k < 6; ++k)
  {
    Vec3 eta = middle;
    eta[k / 2] = (k % 2 == 1 ? box.upper : box.lower)[k / 2];
    xi[static_cast<std::size_t>(k)] = TensorToReference(shape, eta);
  }
  return xi;
}

/// Of a box that bends so much that its centre's Jacobian says little of its ends: planes with each
/// end's own, as seen from its middle. Where a face is collapsed to an edge, boxes at the edge bend
/// as much however small they are, and these planes meet in it.
void TiltPlanes(Shape shape, std::span<const MapAt> ends, const ElementBounds& bounds,
  const Slack& slackOf, FrameArrays& arrays, const BoxCoefficients& phi, NodeFrame& frame)
{
  const auto inXi = EndNormals(shape, frame.box);
  std::array<double[3], 6> normal{};
  std::array<bool, 6> known{};
  for (std::size_t k = 0; k < 6; ++k)
  {
    const auto inverse = Inverse(3, ends[k].jacobian);
    known[k] = inverse.has_value();
    for (std::size_t c = 0; inverse && c < 3; ++c)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        normal[k][c] += inXi[k][d] * (*inverse)[d][c];
      }
      // Far from where products overflow.
      known[k] = known[k] && std::fabs(normal[k][c]) < 1e100;
    }
  }
  double outer[6];
  GetFrameKernels().outermost(arrays.Task(frame, phi, {}), normal.data(), outer);
  for (std::size_t k = 0; k < 6; ++k)
  {
    const double most = outer[k] + slackOf.Of(normal[k]);
    if (known[k] && most < kInfinity)
    {
      ImagePlane& plane = frame.plane[k];
      std::copy_n(normal[k], 3, plane.normal.begin());
      SetOuter(most, bounds, plane);
      plane.inner = -kInfinity;
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
    const Slack slackOf(bounds, phi, frame);
    FrameArrays arrays(space, phi, frame);
    variation = Measure(space, bounds, slackOf, arrays, phi, frame);
    const auto& deviation = frame.deviation;
    frame.bending =
      std::max({ deviation[0].Magnitude(), deviation[1].Magnitude(), deviation[2].Magnitude() }) /
      longest;
    // Such a box holds no point for certain either.
    constexpr double kBentMuch = 0.45;
    if (frame.bending > kBentMuch && frame.bending < kInfinity)
    {
      TiltPlanes(space.shape, at, bounds, slackOf, arrays, phi, frame);
    }
  }
  if (space.shape == Shape::Pyramid && frame.box.upper.z == 1.0)
  {
    // A cone: seen from the apex, directions can only be told apart at the point's own distance.
    frame.widest = 2;
    return;
  }
  // Where the deviation says nothing, or no more than rounding, the longest side.
  const double largest = std::max({ variation[0], variation[1], variation[2] });
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
      frame.widest = d;
    }
  }
}

Box3 HullInXi(Shape shape, const EtaBox& box)
{
  Box3 hull{ Vec3(INFINITY), Vec3(-INFINITY) };
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Vec3 xi = TensorToReference(shape,
      { (corner & 1U) != 0U ? box.upper.x : box.lower.x,
        (corner & 2U) != 0U ? box.upper.y : box.lower.y,
        (corner & 4U) != 0U ? box.upper.z : box.lower.z });
    hull.lower = glm::min(hull.lower, xi);
    hull.upper = glm::max(hull.upper, xi);
  }
  return hull;
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
