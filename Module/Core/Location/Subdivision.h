// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Location/BoxForm.h"
#include "Core/Location/ElementBounds.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace pixelexact
{
struct SubdivisionResult
{
  Verdict verdict = Verdict::Unknown;
  Vec3 xi{ 0.0 };
  double residual = 0.0;
};

/// Decides by subdivision whether an element holds a point: boxes whose Bernstein hulls (plain, and
/// seen through the inverse of the box's mean Jacobian) exclude the point are dropped, and boxes on
/// which the map is injective and has its root outside of the shape; Newton starts from the others,
/// the rest is halved. The first eight boxes' frames are made once per element and exclude most
/// points at once.
///
/// `Inside` and `Outside` carry the reasons that Verdict names: a converged inverse; hulls widened
/// by the element's uncertainty and their rounding. `Unknown` when the budget is spent.
///
/// Made once per element, for any number of points; not to be shared between threads.
class Subdivision
{
public:
  Subdivision(const Mesh& mesh, int element, const ElementBounds& bounds, BoxSpace space);

  /// `knownRoot`: where Newton's iteration converged to, outside of the shape; NaN where it did
  /// not.
  /// `budget`: boxes looked at before the point is called unknown.
  SubdivisionResult Decide(const Vec3& x, const Vec3& knownRoot, int budget);

private:
  struct Box
  {
    Vec3 centre{ 0.0 };
    Vec3 halfWidth{ 1.0 };
    std::array<int, 3> depth{ 0, 0, 0 };
    std::array<double, 3> error{}; ///< of the coefficients, by the halvings since the octant

    [[nodiscard]] int Level() const { return depth[0] + depth[1] + depth[2]; }
    /// The box, each side longer by 1e-6 of itself at either end, holds the point.
    [[nodiscard]] bool NearlyContains(const Vec3& point) const
    {
      const Vec3 reach = halfWidth * (1.0 + 2e-6);
      return std::fabs(point.x - centre.x) <= reach.x && std::fabs(point.y - centre.y) <= reach.y &&
        std::fabs(point.z - centre.z) <= reach.z;
    }
  };

  /// Rows of a matrix M near the inverse Jacobian over a box, up to factors of their own, and the
  /// hulls of M applied to a vector function given by its coefficients.
  struct Frame
  {
    std::array<std::array<double, 3>, 3> row;
    std::array<Hull, 3> hull;
    std::array<double, 3> magnitude; ///< the largest sum of magnitudes behind the hull
  };

  /// An eighth of the cube.
  struct Octant
  {
    Box box;
    std::vector<double> map; ///< Bernstein coefficients of Phi, component by component
    Frame frame;
    std::optional<bool> injective; ///< made when first asked for
  };

  void MakeOctants(std::vector<double> map);
  void SetSlack(const std::array<double, 3>& y);
  [[nodiscard]] bool Excludes(const Octant& octant, const std::array<double, 3>& y) const;
  bool IsSettled(Octant& octant, const Vec3& knownRoot) const;
  Verdict Search(const Octant& octant, const Vec3& x, const std::array<double, 3>& y,
    const Vec3& knownRoot, int& budget, SubdivisionResult& found);
  [[nodiscard]] bool HoldsOnly(
    const Box& box, const Vec3& root, std::span<const double> coefficients) const;
  [[nodiscard]] std::span<double> Slot(std::size_t slot);
  [[nodiscard]] bool IsExcluded(const Box& box, std::span<const double> residual) const;
  [[nodiscard]] bool IsInjective(const Box& box, std::span<const double> coefficients) const;
  [[nodiscard]] Frame MakeFrame(std::span<const double> coefficients) const;
  [[nodiscard]] NewtonStatus FindRoot(
    const Box& box, const Vec3& x, SubdivisionResult& found) const;
  bool SplitTop();
  static void Halve(Box& lower, Box& upper, int direction);

  InverseProblem Problem;
  KernelSet Kernels;
  BoxForm Boxed;
  std::array<int, 3> Degree;
  std::size_t Size;               ///< coefficients of one component
  std::array<double, 3> MapError; ///< of each Bernstein coefficient of Phi
  std::array<double, 3> Largest;  ///< coefficient of Phi, in magnitude
  std::vector<Octant> Octants;
  std::array<double, 3> Slack{}; ///< of every residual coefficient of the current point
  std::vector<Box> Boxes;        ///< a stack
  std::vector<double> Residuals; ///< of Phi - y, 3 Size per box of the stack
};
} // namespace pixelexact
