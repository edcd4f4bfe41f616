// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/IntegralPieces.h"

#include "Cuts/VtkCutFunction.h"
#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Core/Contour/SurfaceAbilities.h"
#include "Core/Location/Locator.h"

#include "vtkImplicitFunction.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// The matrix of a quadric's terms of degree 2: its function is z Q z + g z + c.
std::array<Vec3, 3> MatrixOf(const ImplicitPolynomial& form)
{
  const auto& q = form.a.q;
  return { Vec3(q[0], q[3] / 2.0, q[5] / 2.0), Vec3(q[3] / 2.0, q[1], q[4] / 2.0),
    Vec3(q[5] / 2.0, q[4] / 2.0, q[2]) };
}

/// The direction of the largest diagonal coefficient of Q.
int LargestDiagonal(const std::array<Vec3, 3>& matrix)
{
  int largest = 0;
  for (int d = 1; d < 3; ++d)
  {
    const auto at = [&matrix](int k) { return std::abs(matrix[static_cast<std::size_t>(k)][k]); };
    largest = at(d) > at(largest) ? d : largest;
  }
  return largest;
}

/// The form times the power of two that brings the largest diagonal coefficient of Q into [1,2):
/// products of its coefficients neither underflow nor overflow. Nothing where there is none.
std::optional<ImplicitPolynomial> InUnits(const ImplicitPolynomial& form)
{
  const auto matrix = MatrixOf(form);
  const int axis = LargestDiagonal(matrix);
  const double a = matrix[static_cast<std::size_t>(axis)][axis];
  if (a == 0.0 || !std::isfinite(a))
  {
    return std::nullopt;
  }
  ImplicitPolynomial scaled = form;
  const auto scale = [exponent = -std::ilogb(a)](double& of) { of = std::ldexp(of, exponent); };
  std::ranges::for_each(scaled.a.q, scale);
  for (int d = 0; d < 3; ++d)
  {
    scale(scaled.a.g[d]);
  }
  scale(scaled.a.c);
  return scaled;
}

/// Whether a b = c d, without rounding.
bool AreProductsEqual(double a, double b, double c, double d)
{
  const double first = a * b;
  const double second = c * d;
  return first == second && std::fma(a, b, -first) == std::fma(c, d, -second);
}

/// The vector n of a quadric, as InUnits returns it, whose function is
/// (n z)^2 / a + (g_k / a) (n z) + c, with its largest diagonal coefficient a = n_k; nothing where
/// the function depends on more than one direction.
std::optional<std::pair<Vec3, int>> OnlyDirectionOf(const ImplicitPolynomial& form)
{
  const auto rows = MatrixOf(form);
  const int axis = LargestDiagonal(rows);
  const Vec3& n = rows[static_cast<std::size_t>(axis)];
  const double a = n[axis];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      if (!AreProductsEqual(rows[static_cast<std::size_t>(i)][j], a, n[i], n[j]))
      {
        return std::nullopt;
      }
    }
    if (!AreProductsEqual(form.a.g[i], a, form.a.g[axis], n[i]))
    {
      return std::nullopt;
    }
  }
  return std::pair(n, axis);
}

/// Returns a quadric, or the parallel planes of a quadric whose function depends on one direction n
/// only: two, or one where they coincide, at the equation's roots rounded to doubles, with
/// gradients in the quadric's direction; none where there is no root. The subdivision cannot
/// separate two planes in boxes that are wider than their distance.
std::vector<ImplicitPolynomial> PartsOf(const ImplicitPolynomial& given)
{
  const std::optional<ImplicitPolynomial> inUnits = given.b ? std::nullopt : InUnits(given);
  if (!inUnits)
  {
    return { given };
  }
  const ImplicitPolynomial& form = *inUnits;
  const auto direction = OnlyDirectionOf(form);
  if (!direction)
  {
    return { form };
  }
  // s = n z is a root of s^2 + g_k s + a c.
  const auto& [n, axis] = *direction;
  const double a = n[axis];
  const auto half = -static_cast<long double>(form.a.g[axis]) / 2.0L;
  const auto product = static_cast<long double>(form.a.c) * a;
  const long double square = half * half - product;
  if (!(square >= 0.0L))
  {
    const long double rounding =
      4.0L * std::numeric_limits<long double>::epsilon() * (half * half + std::abs(product));
    return square < -rounding ? std::vector<ImplicitPolynomial>()
                              : std::vector<ImplicitPolynomial>{ form };
  }
  // The root of larger magnitude first: the other one does not cancel.
  const long double outer = half + (half < 0.0L ? -1.0L : 1.0L) * std::sqrt(square);
  const long double inner = outer != 0.0L ? product / outer : 0.0L;
  std::vector<ImplicitPolynomial> planes;
  for (const long double root : { outer, inner })
  {
    if (planes.empty() || square > 0.0L)
    {
      const double sense = static_cast<double>(root - half) * a < 0.0 ? -1.0 : 1.0;
      ImplicitPolynomial plane;
      plane.origin = form.origin;
      plane.a.g = sense * n;
      plane.a.c = -sense * static_cast<double>(root);
      planes.push_back(plane);
    }
  }
  return planes;
}

} // namespace

std::vector<SurfacePatch> IntegralPatchesOf(const std::vector<SurfacePatch>& patches)
{
  std::vector<SurfacePatch> all;
  for (const SurfacePatch& patch : patches)
  {
    for (const ImplicitPolynomial& part : PartsOf(patch.surface))
    {
      all.push_back({ part, patch.clips, patch.within });
    }
  }
  return all;
}

std::vector<SurfacePatch> IntegralPatchesOf(vtkImplicitFunction* function)
{
  const std::vector<SurfacePatch> patches = PatchesOf(function);
  if (patches.empty())
  {
    throw Unsupported(std::string(function->GetClassName()) + ": " +
      DescribeSurfacesWith(SurfaceUse::Integrals) + ".");
  }
  return IntegralPatchesOf(patches);
}

std::vector<ImplicitPolynomial> IntegralClipsOf(vtkImplicitFunction* function)
{
  std::vector<ImplicitPolynomial> clips = ClipsOf(function);
  if (clips.empty())
  {
    throw Unsupported(
      std::string(function->GetClassName()) + ": " + DescribeSurfacesWith(SurfaceUse::Clips) + ".");
  }
  return clips;
}

SurfaceIntegral IntegratePatches(const IntegralQuestion& question,
  std::span<const SurfacePatch> patches, std::span<const ImplicitPolynomial> clips,
  const HighOrderModel& model, const IntegralEffort& effort)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  SurfaceIntegral sum;
  sum.met = true;
  sum.sums.resize(question.Quantities());
  sum.magnitudes.resize(question.Quantities());
  std::size_t left = patches.size();
  for (const SurfacePatch& patch : patches)
  {
    std::vector<ImplicitPolynomial> all = patch.clips;
    std::ranges::copy(clips, std::back_inserter(all));
    const PolynomialSurface surface(patch.surface);
    IntegralQuestion part{ question.mesh, question.field, &surface, all };
    part.below = question.below;
    part.within = patch.within;
    IntegralEffort share = effort;
    // Time that earlier patches did not use is shared among the remaining ones.
    const std::chrono::duration<double> spent = Clock::now() - start;
    share.seconds = std::max(1e-3, (effort.seconds - spent.count()) / static_cast<double>(left--));
    AddTo(sum, IntegrateCut(part, model.GetLocator(), model.Faces(), share));
  }
  return sum;
}
} // namespace pixelexact
