// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/CarefulInverse.h"

#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
/// Boxes looked at before the point is called unknown.
constexpr int kBudget = 4000;
/// A box halved this often in a direction is smaller than what rounding leaves to decide.
constexpr int kMaxDepth = 45;

struct TensorBox
{
  Vec3 centre{ 0.0 };
  Vec3 halfWidth{ 1.0 };
  std::array<int, 3> depth{ 0, 0, 0 };
  std::array<std::vector<double>, 3> residual; ///< Bernstein coefficients of Phi - y
};

bool Excludes(const Hull& hull, double slack)
{
  return hull.lower > slack || hull.upper < -slack;
}

class Subdivision
{
public:
  Subdivision(const Mesh& mesh, int element, const ElementBounds& bounds, const Vec3& x)
    : Problem(MakeInverseProblem(mesh, element, bounds))
    , Kernels(KernelsFor(Problem.space))
    , TheForm(BernsteinForm::Of(Problem.space))
    , X(x)
  {
    TensorBox root;
    const int modes = Problem.space.Modes();
    for (int c = 0; c < 3; ++c)
    {
      const double* component = Problem.coefficients + static_cast<std::ptrdiff_t>(c) * modes;
      auto& residual = root.residual[c];
      residual.resize(TheForm.Size());
      TheForm.Convert(component, residual);
      const double y = (x[c] - Problem.centre[c]) * Problem.inverseSize;
      double largest = 0.0;
      for (double& b : residual)
      {
        b -= y;
        largest = std::max(largest, std::fabs(b));
      }
      // Conversion, subtraction, and the halvings of kMaxDepth levels in three directions.
      const int halvings = 3 * kMaxDepth * Problem.space.MaxOrder();
      Slack[c] = TheForm.ErrorBound(component) + Problem.uncertainty[c] +
        Gamma(halvings + 2) * (largest + std::fabs(y));
    }
    Stack.push_back(std::move(root));
  }

  CarefulResult Run()
  {
    bool undecided = false;
    for (int looked = 0; !Stack.empty(); ++looked)
    {
      if (looked == kBudget)
      {
        return {};
      }
      TensorBox box = std::move(Stack.back());
      Stack.pop_back();
      if (IsExcluded(box))
      {
        continue;
      }
      CarefulResult found;
      if (FindRoot(box, found))
      {
        return found;
      }
      undecided = !Split(std::move(box)) || undecided;
    }
    return { undecided ? Verdict::Unknown : Verdict::Outside, Vec3(0.0), 0.0 };
  }

private:
  [[nodiscard]] bool IsExcluded(const TensorBox& box) const
  {
    for (int c = 0; c < 3; ++c)
    {
      if (Excludes(HullOf(box.residual[c]), Slack[c]))
      {
        return true;
      }
    }
    return IsExcludedByFrame(box);
  }

  /// The hulls of M r for M the inverse of the mean Jacobian over the box: r = 0 exactly where
  /// M r = 0, and M r is nearly the identity, so that boxes beside the root are excluded too.
  [[nodiscard]] bool IsExcludedByFrame(const TensorBox& box) const
  {
    const auto [P, Q, R] = TheForm.Degree();
    const std::size_t strides[3] = { static_cast<std::size_t>(Q + 1) * (R + 1),
      static_cast<std::size_t>(R + 1), 1 };
    double mean[9];
    for (int c = 0; c < 3; ++c)
    {
      const auto& b = box.residual[c];
      for (int d = 0; d < 3; ++d)
      {
        const int degree = TheForm.Degree()[d];
        double first = 0.0;
        double last = 0.0;
        for (std::size_t at = 0; at < b.size(); ++at)
        {
          const auto i = static_cast<int>(at / strides[d]) % (degree + 1);
          first += i == 0 ? b[at] : 0.0;
          last += i == degree ? b[at] : 0.0;
        }
        mean[3 * c + d] = last - first;
      }
    }
    const double det = mean[0] * (mean[4] * mean[8] - mean[5] * mean[7]) -
      mean[1] * (mean[3] * mean[8] - mean[5] * mean[6]) +
      mean[2] * (mean[3] * mean[7] - mean[4] * mean[6]);
    if (!(std::fabs(det) > 0.0) || !std::isfinite(1.0 / det))
    {
      return false;
    }
    // Rows of the adjugate: scaling does not matter to a test against zero.
    for (int i = 0; i < 3; ++i)
    {
      double row[3];
      for (int c = 0; c < 3; ++c)
      {
        const int c1 = (c + 1) % 3;
        const int c2 = (c + 2) % 3;
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        row[c] = mean[3 * c1 + i1] * mean[3 * c2 + i2] - mean[3 * c1 + i2] * mean[3 * c2 + i1];
      }
      Hull hull{ std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity() };
      double largest = 0.0;
      for (std::size_t at = 0; at < box.residual[0].size(); ++at)
      {
        double sum = 0.0;
        double magnitude = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          const double term = row[c] * box.residual[c][at];
          sum += term;
          magnitude += std::fabs(term);
        }
        hull.lower = std::min(hull.lower, sum);
        hull.upper = std::max(hull.upper, sum);
        largest = std::max(largest, magnitude);
      }
      double slack = Gamma(4) * largest;
      for (int c = 0; c < 3; ++c)
      {
        slack += std::fabs(row[c]) * Slack[c] * (1.0 + Gamma(8));
      }
      if (Excludes(hull, slack))
      {
        return true;
      }
    }
    return false;
  }

  /// Newton from the box's centre. A root in the shape decides, wherever the iteration took it.
  bool FindRoot(const TensorBox& box, CarefulResult& found) const
  {
    const Vec3 start = TensorToReference(Problem.space.shape, box.centre);
    InverseProblem problem = Problem;
    // A frame of zero slope starts the kernel's iteration where we want it.
    std::fill_n(problem.inverse, 9, 0.0);
    problem.affine = false;
    problem.start[0] = start.x;
    problem.start[1] = start.y;
    problem.start[2] = start.z;
    double lanes[9][kLanePadding];
    for (int d = 0; d < 3; ++d)
    {
      std::fill_n(lanes[d], kLanePadding, X[d]);
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

  /// Halves the box where its coefficients vary most; false where it is too small for that.
  bool Split(TensorBox box)
  {
    int direction = -1;
    double widest = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      const double width = box.depth[d] < kMaxDepth ? box.halfWidth[d] : 0.0;
      if (width > widest)
      {
        widest = width;
        direction = d;
      }
    }
    if (direction < 0)
    {
      return false;
    }
    TensorBox upper = box;
    for (int c = 0; c < 3; ++c)
    {
      Halve(TheForm.Degree(), direction, box.residual[c], upper.residual[c]);
    }
    for (TensorBox* half : { &box, &upper })
    {
      ++half->depth[direction];
      half->halfWidth[direction] *= 0.5;
    }
    box.centre[direction] -= box.halfWidth[direction];
    upper.centre[direction] += upper.halfWidth[direction];
    Stack.push_back(std::move(upper));
    Stack.push_back(std::move(box));
    return true;
  }

  InverseProblem Problem;
  KernelSet Kernels;
  const BernsteinForm& TheForm;
  Vec3 X;
  double Slack[3];
  std::vector<TensorBox> Stack;
};
} // namespace

CarefulResult CarefulInverse(
  const Mesh& mesh, int element, const ElementBounds& bounds, const Vec3& x)
{
  return Subdivision(mesh, element, bounds, x).Run();
}
} // namespace pixelexact
