// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/FrameMeasure.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{

std::vector<double>& ArraysOfThread()
{
  thread_local std::vector<double> values;
  return values;
}

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
} // namespace

FrameMeasure::FrameMeasure(
  const Space& space, const ElementBounds& bounds, const BoxCoefficients& phi, NodeFrame& frame)
  : space_(space)
  , Bounds(bounds)
  , Phi(phi)
  , Frame(frame)
  , Size(phi.values.size() / 3)
  , Padded(std::max(Size, static_cast<std::size_t>(kLanePadding)))
  , Values(ArraysOfThread())
{
  if (Values.size() < 9 * Padded)
  {
    Values.resize(9 * Padded);
  }
  MakeGrid(space.TensorDegree());
  for (std::size_t c = 0; c < 3; ++c)
  {
    From[c] = Phi.Of(c).data();
    if (Padded > Size)
    {
      std::copy_n(From[c], Size, Row(6 + c));
      Fill(Row(6 + c));
      From[c] = Row(6 + c);
    }
    // Covers the coefficients' errors, the uncertainty of Phi and y, and the rounding of the
    // products here and in Classify (TreeKernels.h), where y lies in the hull; sums are below 2 and
    // these products.
    Around[c] = Phi.error[c] + Bounds.uncertainty[c] +
      Gamma(32) * Frame.hull[c].RadiusAround(Frame.origin[c]);
  }
}

void FrameMeasure::Fill(double* row) const
{
  std::fill(row + Size, row + Padded, row[Size - 1]);
}

FrameTask FrameMeasure::Task(std::span<const double[3]> normal)
{
  FrameTask task{};
  task.size = Padded;
  task.inverse = Frame.inverse.data();
  task.normal = normal.empty() ? nullptr : normal.data();
  for (std::size_t c = 0; c < 3; ++c)
  {
    task.phi[c] = From[c];
    task.shift[c] = Frame.origin[c] - Phi.base[c];
    task.grid[c] = Row(c);
    task.deviation[c] = Row(3 + c);
  }
  return task;
}

DeviationSteps FrameMeasure::Steps(const std::array<int, 3>& degree)
{
  DeviationSteps steps{};
  std::size_t stride = Size;
  for (std::size_t direction = 0; direction < 3; ++direction)
  {
    const auto count = static_cast<std::size_t>(degree[direction]) + 1;
    stride /= count;
    for (std::size_t d = 0; d < 3; ++d)
    {
      steps[d][direction] = GetFrameKernels().steps(Row(3 + d), Size, count, stride);
    }
  }
  return steps;
}

/// xi is affine in each eta, so its coefficients are its values on the grid.
void FrameMeasure::MakeGrid(const std::array<int, 3>& degree)
{
  const auto eta = [&](int d, int i)
  {
    const int n = degree[static_cast<std::size_t>(d)];
    const double part = n == 0 ? 0.5 : static_cast<double>(i) / n;
    return Frame.box.lower[d] + part * (Frame.box.upper[d] - Frame.box.lower[d]);
  };
  const FrameKernels& kernels = GetFrameKernels();
  std::size_t at = 0;
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      // xi is affine along a line.
      const Vec3 first = TensorToReference(space_.shape, { eta(0, i), eta(1, j), eta(2, 0) });
      const Vec3 last =
        TensorToReference(space_.shape, { eta(0, i), eta(1, j), eta(2, degree[2]) });
      const Vec3 from = first - Frame.centre;
      const Vec3 step = (last - first) / static_cast<double>(std::max(1, degree[2]));
      const double begin[3] = { from.x, from.y, from.z };
      const double by[3] = { step.x, step.y, step.z };
      double* const to[3] = { Row(0) + at, Row(1) + at, Row(2) + at };
      kernels.fillLine(begin, by, static_cast<std::size_t>(degree[2]) + 1, to);
      at += static_cast<std::size_t>(degree[2]) + 1;
    }
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    Fill(Row(d));
  }
}

double FrameMeasure::SlackOf(const double* row) const
{
  double slack = Gamma(64);
  for (std::size_t c = 0; c < 3; ++c)
  {
    slack += std::fabs(row[c]) * Around[c];
  }
  return slack * (1.0 + Gamma(64));
}

std::array<double, 3> FrameMeasure::Measure()
{
  const auto normal = EndNormals(space_.shape, Frame.box);
  const bool cube = space_.shape == Shape::Hexahedron;
  const FrameTask task = Task(cube ? std::span<const double[3]>() : std::span(normal));
  const FrameSums sums = GetFrameKernels().measure(task);
  for (std::size_t d = 0; d < 3; ++d)
  {
    const double slack = SlackOf(&Frame.inverse[3 * d]);
    Frame.slack[d] = slack;
    Frame.deviation[d] = sums.all == 0.0 && slack < kInfinity
      ? rounding::Outward(sums.least[d] - slack, sums.most[d] + slack)
      : Interval::Everything();
  }
  for (std::size_t k = 0; k < 6; ++k)
  {
    ImagePlane& plane = Frame.plane[k];
    // The rounding of the products with the rows, which may cancel in the normal.
    double rounding = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        const double part = normal[k][d] * Frame.inverse[3 * d + c];
        plane.normal[c] += part;
        rounding += std::fabs(part) * Gamma(32) * Frame.hull[c].RadiusAround(Frame.origin[c]);
      }
    }
    const double slack = (SlackOf(plane.normal.data()) + rounding) * (1.0 + Gamma(64));
    if (sums.all != 0.0 || !(slack < kInfinity))
    {
      continue;
    }
    SetOuter(sums.outer[k] + slack, Bounds, plane);
    plane.inner = NextDown(
      DepthOf(space_.shape, Frame.box, static_cast<int>(k), Frame.centre) + sums.inner[k] - slack);
  }
  const auto degree = space_.TensorDegree();
  const DeviationSteps steps = Steps(degree);
  if (space_.shape == Shape::Hexahedron && sums.all == 0.0)
  {
    Frame.injective = IsInjective(degree, steps, Frame, Size > kMaxWithSlopes);
  }
  std::array<double, 3> variation{};
  for (std::size_t j = 0; j < 3; ++j)
  {
    variation[j] =
      std::max({ LargestStep(steps[0][j]), LargestStep(steps[1][j]), LargestStep(steps[2][j]) }) *
      degree[j];
  }
  return variation;
}

void FrameMeasure::TiltPlanes(std::span<const SmallMatrix, 6> jacobian)
{
  const auto inXi = EndNormals(space_.shape, Frame.box);
  std::array<double[3], 6> normal{};
  std::array<bool, 6> known{};
  for (std::size_t k = 0; k < 6; ++k)
  {
    const auto inverse = Inverse(3, jacobian[k]);
    known[k] = inverse.has_value();
    for (std::size_t c = 0; inverse && c < 3; ++c)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        normal[k][c] += inXi[k][d] * (*inverse)[d][c];
      }
      // Keeps normals far from where products overflow.
      known[k] = known[k] && std::fabs(normal[k][c]) < 1e100;
    }
  }
  double outer[6];
  GetFrameKernels().outermost(Task({}), normal.data(), outer);
  for (std::size_t k = 0; k < 6; ++k)
  {
    const double most = outer[k] + SlackOf(normal[k]);
    if (known[k] && most < kInfinity)
    {
      ImagePlane& plane = Frame.plane[k];
      std::copy_n(normal[k], 3, plane.normal.begin());
      SetOuter(most, Bounds, plane);
      plane.inner = -kInfinity;
    }
  }
}
} // namespace pixelexact
