// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Location/ElementBounds.h"

#include <array>
#include <vector>

namespace pixelexact
{
struct CarefulResult
{
  Verdict verdict = Verdict::Unknown;
  Vec3 xi{ 0.0 };
  double residual = 0.0;
};

/// Decides by subdivision whether an element holds a point: boxes of the tensor space whose
/// Bernstein hulls (plain, and seen through the inverse of the box's mean Jacobian) exclude the
/// point are dropped, Newton starts from the others, the rest is halved. The first eight boxes'
/// frames are made once per element and exclude most points at once.
///
/// `Inside` and `Outside` carry the reasons that Verdict names: a converged inverse; hulls widened
/// by the element's uncertainty and their rounding. `Unknown` when the budget is spent. The place
/// of the certified engine for polynomial systems, which is to prove uniqueness too.
///
/// Made once per element, for any number of points; not to be shared between threads.
class CarefulInverse
{
public:
  CarefulInverse(const Mesh& mesh, int element, const ElementBounds& bounds);

  CarefulResult Decide(const Vec3& x);

private:
  struct Box
  {
    Vec3 centre{ 0.0 };
    Vec3 halfWidth{ 1.0 };
    std::array<int, 3> depth{ 0, 0, 0 };

    [[nodiscard]] int Level() const { return depth[0] + depth[1] + depth[2]; }
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
  };

  void MakeOctants(std::vector<double> map);
  void SetSlack(const std::array<double, 3>& y);
  [[nodiscard]] bool Excludes(const Octant& octant, const std::array<double, 3>& y) const;
  Verdict Search(const Octant& octant, const Vec3& x, const std::array<double, 3>& y, int& budget,
    CarefulResult& found);
  [[nodiscard]] std::span<double> Slot(std::size_t slot);
  [[nodiscard]] bool IsExcluded(std::span<const double> residual) const;
  [[nodiscard]] Frame MakeFrame(std::span<const double> coefficients) const;
  bool FindRoot(const Box& box, const Vec3& x, CarefulResult& found) const;
  bool SplitTop();
  static void Halve(Box& lower, Box& upper, int direction);

  InverseProblem Problem;
  KernelSet Kernels;
  const BernsteinForm& TheForm;
  std::size_t Size;               ///< coefficients of one component
  std::array<double, 3> MapError; ///< of each Bernstein coefficient of Phi
  std::array<double, 3> Largest;  ///< coefficient of Phi, in magnitude
  std::vector<Octant> Octants;
  std::array<double, 3> Slack{}; ///< of every residual coefficient of the current point
  std::vector<Box> Boxes;        ///< a stack
  std::vector<double> Residuals; ///< of Phi - y, 3 Size per box of the stack
};
} // namespace pixelexact
