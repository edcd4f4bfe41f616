// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Subdivision.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// A box halved this often in a direction is smaller than what rounding leaves to decide.
constexpr int kMaxDepth = 45;
/// Newton is tried once per halving in all three directions: excluding a box is cheaper.
constexpr int kLevelsPerNewton = 3;

bool Excludes(const Hull& hull, double slack)
{
  return hull.lower > slack || hull.upper < -slack;
}
} // namespace

Subdivision::Subdivision(const Mesh& mesh, int element, const ElementBounds& bounds, BoxSpace space)
  : Problem(MakeInverseProblem(mesh, element, bounds))
  , Kernels(KernelsFor(Problem.space))
  , Boxed(Problem.space, Problem.coefficients, space)
  , Degree(Boxed.degree)
  , Size(Boxed.map.size() / 3)
  , MapError(Boxed.error)
{
  // A frame of zero slope lets the kernel's iteration begin where we want it.
  std::fill_n(Problem.inverse, 9, 0.0);
  Problem.affine = false;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const Hull hull = HullOf(std::span(Boxed.map).subspan(c * Size, Size));
    Largest[c] = std::max(std::fabs(hull.lower), std::fabs(hull.upper));
  }
  MakeOctants(Boxed.map);
}

void Subdivision::MakeOctants(std::vector<double> map)
{
  Octants.push_back({ Box{}, std::move(map), {}, {} });
  for (int direction = 0; direction < 3; ++direction)
  {
    for (std::size_t k = 0, count = Octants.size(); k < count; ++k)
    {
      Octant upper = Octants[k];
      Octant& lower = Octants[k];
      for (std::size_t c = 0; c < 3; ++c)
      {
        pixelexact::Halve(Degree, direction, std::span(lower.map).subspan(c * Size, Size),
          std::span(upper.map).subspan(c * Size, Size));
      }
      Halve(lower.box, upper.box, direction);
      Octants.push_back(std::move(upper));
    }
  }
  std::erase_if(Octants,
    [&](const Octant& octant)
    { return !Boxed.MeetsShape(Problem.space.shape, octant.box.centre - octant.box.halfWidth); });
  for (Octant& octant : Octants)
  {
    octant.frame = MakeFrame(octant.map);
  }
}

void Subdivision::SetSlack(const std::array<double, 3>& y)
{
  // Conversion, the three halvings to an octant, subtraction. The same for all points in the
  // element's box, |y| <= 2, so that what is kept per octant holds for all.
  const int halvings = Degree[0] + Degree[1] + Degree[2];
  for (std::size_t c = 0; c < 3; ++c)
  {
    Slack[c] = MapError[c] + Problem.uncertainty[c] +
      Gamma(halvings + 4) * (Largest[c] + 2.0 * std::max(2.0, std::fabs(y[c])));
  }
}

SubdivisionResult Subdivision::Decide(const Vec3& x, const Vec3& knownRoot, int budget)
{
  std::array<double, 3> y;
  for (int c = 0; c < 3; ++c)
  {
    y[static_cast<std::size_t>(c)] = (x[c] - Problem.centre[c]) * Problem.inverseSize;
  }
  SetSlack(y);
  bool undecided = false;
  for (Octant& octant : Octants)
  {
    if (!Excludes(octant, y) && !IsSettled(octant, knownRoot))
    {
      SubdivisionResult found;
      const Verdict verdict = Search(octant, x, y, knownRoot, budget, found);
      if (verdict == Verdict::Inside)
      {
        return found;
      }
      undecided = undecided || verdict == Verdict::Unknown;
    }
  }
  return { undecided ? Verdict::Unknown : Verdict::Outside, Vec3(0.0), 0.0 };
}

bool Subdivision::Excludes(const Octant& octant, const std::array<double, 3>& y) const
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

/// Whether the octant's only root is the known one, outside of the shape.
bool Subdivision::IsSettled(Octant& octant, const Vec3& knownRoot) const
{
  if (!Boxed.inReferenceSpace || !octant.box.NearlyContains(knownRoot))
  {
    return false;
  }
  if (!octant.injective)
  {
    octant.injective = IsInjective(octant.box, octant.map);
  }
  return *octant.injective;
}

bool Subdivision::HoldsOnly(
  const Box& box, const Vec3& root, std::span<const double> coefficients) const
{
  return Boxed.inReferenceSpace && box.NearlyContains(root) && IsInjective(box, coefficients);
}

Verdict Subdivision::Search(const Octant& octant, const Vec3& x, const std::array<double, 3>& y,
  const Vec3& knownRoot, int& budget, SubdivisionResult& found)
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
    const Box& box = Boxes.back();
    const auto residual = Slot(Boxes.size() - 1);
    if (IsExcluded(box, residual) || HoldsOnly(box, knownRoot, residual))
    {
      Boxes.pop_back();
      continue;
    }
    if (box.Level() % kLevelsPerNewton == 0)
    {
      const NewtonStatus status = FindRoot(box, x, found);
      if (status == NewtonStatus::RootInside)
      {
        return Verdict::Inside;
      }
      if (status == NewtonStatus::RootOutside && HoldsOnly(box, found.xi, residual))
      {
        Boxes.pop_back();
        continue;
      }
    }
    if (!SplitTop())
    {
      Boxes.pop_back();
      undecided = true;
    }
  }
  return undecided ? Verdict::Unknown : Verdict::Outside;
}

std::span<double> Subdivision::Slot(std::size_t slot)
{
  return std::span(Residuals).subspan(3 * slot * Size, 3 * Size);
}

bool Subdivision::IsExcluded(const Box& box, std::span<const double> residual) const
{
  if (!Boxed.MeetsShape(Problem.space.shape, box.centre - box.halfWidth))
  {
    return true;
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (pixelexact::Excludes(HullOf(residual.subspan(c * Size, Size)), Slack[c] + box.error[c]))
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
      slack += std::fabs(frame.row[i][c]) * (Slack[c] + box.error[c]);
    }
    if (pixelexact::Excludes(frame.hull[i], slack * (1.0 + Gamma(8))))
    {
      return true;
    }
  }
  return false;
}

Subdivision::Frame Subdivision::MakeFrame(std::span<const double> coefficients) const
{
  // The mean Jacobian, up to factors: differences of the coefficients of opposite faces.
  const auto [P, Q, R] = Degree;
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

/// Whether the map has at most one root on the box, longer by 1e-6 of itself at all ends: M r, with
/// M the inverse of the mean Jacobian, has a strictly diagonally dominant Jacobian there. For G = M
/// r and a, b in the box, i the direction in which they differ most, |G_i(b) - G_i(a)| >= (min d_i
/// G_i - sum max |d_j G_i|) |b_i - a_i| > 0. Derivatives are enclosed by differences of
/// neighbouring coefficients; continued by 1e-6 of the box they change by less than 1e-4 of their
/// range, at degrees up to kMaxOrder.
bool Subdivision::IsInjective(const Box& box, std::span<const double> coefficients) const
{
  const Frame frame = MakeFrame(coefficients);
  const std::array<std::size_t, 3> stride{ static_cast<std::size_t>(
                                             (Degree[1] + 1) * (Degree[2] + 1)),
    static_cast<std::size_t>(Degree[2] + 1), 1 };
  std::vector<double> g(Size);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& row = frame.row[i];
    for (std::size_t at = 0; at < Size; ++at)
    {
      g[at] = row[0] * coefficients[at] + row[1] * coefficients[Size + at] +
        row[2] * coefficients[2 * Size + at];
    }
    double noise = Gamma(16) * frame.magnitude[i];
    for (std::size_t c = 0; c < 3; ++c)
    {
      noise += std::fabs(row[c]) * (Slack[c] + box.error[c]);
    }
    double diagonal = 0.0;
    double others = 0.0;
    double ranges = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      const auto degree = static_cast<std::size_t>(Degree[j]);
      Hull slope{ std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity() };
      for (std::size_t at = 0; at < Size; ++at)
      {
        if (at / stride[j] % (degree + 1) < degree)
        {
          const double difference = g[at + stride[j]] - g[at];
          slope = { std::min(slope.lower, difference), std::max(slope.upper, difference) };
        }
      }
      const double error = 2.0 * noise;
      const auto factor = static_cast<double>(degree);
      ranges += factor * (slope.upper - slope.lower + 2.0 * error);
      if (j == i)
      {
        diagonal = factor * (std::max(slope.lower, -slope.upper) - error);
      }
      else
      {
        others += factor * (std::max(-slope.lower, slope.upper) + error);
      }
    }
    if (!(diagonal > others * (1.0 + Gamma(16)) + 1e-4 * ranges))
    {
      return false;
    }
  }
  return true;
}

/// Newton from the box's centre. A root in the shape decides, wherever the iteration took it.
NewtonStatus Subdivision::FindRoot(const Box& box, const Vec3& x, SubdivisionResult& found) const
{
  const Vec3 start =
    Boxed.inReferenceSpace ? box.centre : TensorToReference(Problem.space.shape, box.centre);
  InverseProblem problem = Problem;
  double lanes[9][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    problem.start[d] = start[d];
    std::fill_n(lanes[d], kLanePadding, x[d]);
  }
  const InverseResult result{ { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], lanes[8] };
  Kernels.invert(problem, { { lanes[0], lanes[1], lanes[2] }, 1 }, result);
  found = { Verdict::Inside, { lanes[3][0], lanes[4][0], lanes[5][0] }, lanes[8][0] };
  return static_cast<NewtonStatus>(static_cast<int>(lanes[6][0]));
}

/// Halves the box on top of the stack in its widest direction; false where it is too small.
bool Subdivision::SplitTop()
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
    // The coefficients shrink with the box, and with them what each halving rounds.
    const Hull hull = HullOf(Slot(slot).subspan(c * Size, Size));
    Boxes.back().error[c] +=
      Gamma(Degree[static_cast<std::size_t>(direction)]) * std::max(-hull.lower, hull.upper);
    pixelexact::Halve(Degree, direction, Slot(slot).subspan(c * Size, Size),
      Slot(slot + 1).subspan(c * Size, Size));
  }
  Box upper = Boxes.back();
  Halve(Boxes.back(), upper, direction);
  Boxes.push_back(upper);
  return true;
}

/// Makes two copies of a box its halves.
void Subdivision::Halve(Box& lower, Box& upper, int direction)
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
