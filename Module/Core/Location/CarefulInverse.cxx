// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/CarefulInverse.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Boxes looked at before the point is called unknown.
constexpr int kBudget = 4000;
/// A box halved this often in a direction is smaller than what rounding leaves to decide.
constexpr int kMaxDepth = 45;
/// Newton is tried once per halving in all three directions: excluding a box is cheaper.
constexpr int kLevelsPerNewton = 3;

bool Excludes(const Hull& hull, double slack)
{
  return hull.lower > slack || hull.upper < -slack;
}
} // namespace

CarefulInverse::CarefulInverse(const Mesh& mesh, int element, const ElementBounds& bounds)
  : Problem(MakeInverseProblem(mesh, element, bounds))
  , Kernels(KernelsFor(Problem.space))
  , TheForm(BernsteinForm::Of(Problem.space))
  , Size(static_cast<std::size_t>(TheForm.Size()))
{
  // A frame of zero slope lets the kernel's iteration begin where we want it.
  std::fill_n(Problem.inverse, 9, 0.0);
  Problem.affine = false;
  const auto modes = static_cast<std::size_t>(Problem.space.Modes());
  std::vector<double> map(3 * Size);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double* component = Problem.coefficients + c * modes;
    const auto coefficients = std::span(map).subspan(c * Size, Size);
    TheForm.Convert(component, coefficients);
    MapError[c] = TheForm.ErrorBound(component);
    const Hull hull = HullOf(coefficients);
    Largest[c] = std::max(std::fabs(hull.lower), std::fabs(hull.upper));
  }
  MakeOctants(std::move(map));
}

void CarefulInverse::MakeOctants(std::vector<double> map)
{
  Octants.push_back({ Box{}, std::move(map), {} });
  for (int direction = 0; direction < 3; ++direction)
  {
    for (std::size_t k = 0, count = Octants.size(); k < count; ++k)
    {
      Octant upper = Octants[k];
      Octant& lower = Octants[k];
      for (std::size_t c = 0; c < 3; ++c)
      {
        pixelexact::Halve(TheForm.Degree(), direction, std::span(lower.map).subspan(c * Size, Size),
          std::span(upper.map).subspan(c * Size, Size));
      }
      Halve(lower.box, upper.box, direction);
      Octants.push_back(std::move(upper));
    }
  }
  for (Octant& octant : Octants)
  {
    octant.frame = MakeFrame(octant.map);
  }
}

void CarefulInverse::SetSlack(const std::array<double, 3>& y)
{
  // Conversion, subtraction, and the halvings of kMaxDepth levels in three directions.
  const int halvings = 3 * kMaxDepth * Problem.space.MaxOrder();
  for (std::size_t c = 0; c < 3; ++c)
  {
    Slack[c] = MapError[c] + Problem.uncertainty[c] +
      Gamma(halvings + 4) * (Largest[c] + 2.0 * std::fabs(y[c]));
  }
}

CarefulResult CarefulInverse::Decide(const Vec3& x)
{
  std::array<double, 3> y;
  for (int c = 0; c < 3; ++c)
  {
    y[static_cast<std::size_t>(c)] = (x[c] - Problem.centre[c]) * Problem.inverseSize;
  }
  SetSlack(y);
  bool undecided = false;
  int budget = kBudget;
  for (const Octant& octant : Octants)
  {
    if (!Excludes(octant, y))
    {
      CarefulResult found;
      const Verdict verdict = Search(octant, x, y, budget, found);
      if (verdict == Verdict::Inside)
      {
        return found;
      }
      undecided = undecided || verdict == Verdict::Unknown;
    }
  }
  return { undecided ? Verdict::Unknown : Verdict::Outside, Vec3(0.0), 0.0 };
}

bool CarefulInverse::Excludes(const Octant& octant, const std::array<double, 3>& y) const
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& row = octant.frame.row[i];
    double at = 0.0;
    double magnitude = octant.frame.magnitude[i];
    double slack = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      at += row[c] * y[c];
      magnitude += std::fabs(row[c] * y[c]);
      slack += std::fabs(row[c]) * Slack[c];
    }
    slack = (slack + Gamma(8) * magnitude) * (1.0 + Gamma(16));
    const Hull& hull = octant.frame.hull[i];
    if (pixelexact::Excludes({ hull.lower - at, hull.upper - at }, slack))
    {
      return true;
    }
  }
  return false;
}

Verdict CarefulInverse::Search(const Octant& octant, const Vec3& x, const std::array<double, 3>& y,
  int& budget, CarefulResult& found)
{
  Boxes.assign(1, octant.box);
  Residuals.resize(std::max(Residuals.size(), 3 * Size));
  for (std::size_t at = 0; at < 3 * Size; ++at)
  {
    Residuals[at] = octant.map[at] - y[at / Size];
  }
  bool undecided = false;
  while (!Boxes.empty())
  {
    if (budget-- <= 0)
    {
      return Verdict::Unknown;
    }
    if (IsExcluded(Slot(Boxes.size() - 1)))
    {
      Boxes.pop_back();
      continue;
    }
    if (Boxes.back().Level() % kLevelsPerNewton == 0 && FindRoot(Boxes.back(), x, found))
    {
      return Verdict::Inside;
    }
    if (!SplitTop())
    {
      Boxes.pop_back();
      undecided = true;
    }
  }
  return undecided ? Verdict::Unknown : Verdict::Outside;
}

std::span<double> CarefulInverse::Slot(std::size_t slot)
{
  return std::span(Residuals).subspan(3 * slot * Size, 3 * Size);
}

bool CarefulInverse::IsExcluded(std::span<const double> residual) const
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (pixelexact::Excludes(HullOf(residual.subspan(c * Size, Size)), Slack[c]))
    {
      return true;
    }
  }
  // M r = 0 exactly where r = 0, and M r is nearly the identity, so that boxes beside the root are
  // excluded too.
  const Frame frame = MakeFrame(residual);
  for (std::size_t i = 0; i < 3; ++i)
  {
    double slack = Gamma(8) * frame.magnitude[i];
    for (std::size_t c = 0; c < 3; ++c)
    {
      slack += std::fabs(frame.row[i][c]) * Slack[c];
    }
    if (pixelexact::Excludes(frame.hull[i], slack * (1.0 + Gamma(8))))
    {
      return true;
    }
  }
  return false;
}

CarefulInverse::Frame CarefulInverse::MakeFrame(std::span<const double> coefficients) const
{
  // The mean Jacobian, up to factors: differences of the coefficients of opposite faces.
  const auto [P, Q, R] = TheForm.Degree();
  double mean[3][3] = {};
  const double* b = coefficients.data();
  for (auto& row : mean)
  {
    for (int i = 0; i <= P; ++i)
    {
      for (int j = 0; j <= Q; ++j, b += R + 1)
      {
        double line = 0.0;
        for (int k = 0; k <= R; ++k)
        {
          line += b[k];
        }
        row[0] += i == P ? line : (i == 0 ? -line : 0.0);
        row[1] += j == Q ? line : (j == 0 ? -line : 0.0);
        row[2] += b[R] - b[0];
      }
    }
  }
  // Rows of the adjugate: the factor 1 / det does not matter to a test against zero.
  Frame frame;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double* m1 = mean[(c + 1) % 3];
      const double* m2 = mean[(c + 2) % 3];
      frame.row[i][c] = m1[(i + 1) % 3] * m2[(i + 2) % 3] - m1[(i + 2) % 3] * m2[(i + 1) % 3];
    }
    const auto& row = frame.row[i];
    Hull hull{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
    double largest = 0.0;
    for (std::size_t at = 0; at < Size; ++at)
    {
      const double u = row[0] * coefficients[at];
      const double v = row[1] * coefficients[Size + at];
      const double w = row[2] * coefficients[2 * Size + at];
      const double sum = u + v + w;
      hull.lower = std::min(hull.lower, sum);
      hull.upper = std::max(hull.upper, sum);
      largest = std::max(largest, std::fabs(u) + std::fabs(v) + std::fabs(w));
    }
    frame.hull[i] = hull;
    frame.magnitude[i] = largest;
  }
  return frame;
}

/// Newton from the box's centre. A root in the shape decides, wherever the iteration took it.
bool CarefulInverse::FindRoot(const Box& box, const Vec3& x, CarefulResult& found) const
{
  const Vec3 start = TensorToReference(Problem.space.shape, box.centre);
  InverseProblem problem = Problem;
  double lanes[9][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    problem.start[d] = start[d];
    std::fill_n(lanes[d], kLanePadding, x[d]);
  }
  const InverseResult result{ { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], lanes[8] };
  Kernels.invert(problem, { { lanes[0], lanes[1], lanes[2] }, 1 }, result);
  if (lanes[6][0] != static_cast<double>(NewtonStatus::RootInside))
  {
    return false;
  }
  found = { Verdict::Inside, { lanes[3][0], lanes[4][0], lanes[5][0] }, lanes[8][0] };
  return true;
}

/// Halves the box on top of the stack in its widest direction; false where it is too small.
bool CarefulInverse::SplitTop()
{
  int direction = -1;
  double widest = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    if (Boxes.back().depth[static_cast<std::size_t>(d)] < kMaxDepth &&
      Boxes.back().halfWidth[d] > widest)
    {
      widest = Boxes.back().halfWidth[d];
      direction = d;
    }
  }
  if (direction < 0)
  {
    return false;
  }
  const std::size_t slot = Boxes.size() - 1;
  Residuals.resize(std::max(Residuals.size(), 3 * Size * (slot + 2)));
  for (std::size_t c = 0; c < 3; ++c)
  {
    pixelexact::Halve(TheForm.Degree(), direction, Slot(slot).subspan(c * Size, Size),
      Slot(slot + 1).subspan(c * Size, Size));
  }
  Box upper = Boxes.back();
  Halve(Boxes.back(), upper, direction);
  Boxes.push_back(upper);
  return true;
}

/// Makes two copies of a box its halves.
void CarefulInverse::Halve(Box& lower, Box& upper, int direction)
{
  for (Box* box : { &lower, &upper })
  {
    ++box->depth[static_cast<std::size_t>(direction)];
    box->halfWidth[direction] *= 0.5;
  }
  lower.centre[direction] -= lower.halfWidth[direction];
  upper.centre[direction] += upper.halfWidth[direction];
}
} // namespace pixelexact
