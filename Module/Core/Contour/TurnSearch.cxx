// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/TurnSearch.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Contour/SeedList.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Boxes of the root finder for a part that can still be subdivided.
constexpr int kTry = 48;
/// Subdivisions of a piece before the first call of the root finder, and the largest number of
/// subdivisions.
constexpr int kFirstAsked = 3;
constexpr int kMaxTurnDepth = 15;

/// The direction in which a part's polynomials bend most; the part is subdivided along it.
int DirectionOf(const CurvePart& part)
{
  int best = 0;
  double most = -1.0;
  for (int d = 0; d < 3; ++d)
  {
    const auto bend = [&](const BoxPolynomial& one)
    { return one.Variation(d, 2) / std::max(one.Hull().Magnitude(), 1e-300); };
    const double width = part.box.upper[d] - part.box.lower[d];
    const double score = bend(part.polynomials.f) + bend(part.polynomials.s) + 1e-3 * width;
    if (score > most)
    {
      most = score;
      best = d;
    }
  }
  return best;
}
} // namespace

void TurnSearch::Visit(CurvePart part, int depth)
{
  if (!part.polynomials.MayVanish())
  {
    return;
  }
  if (List.IsFull())
  {
    List.result.complete = false;
    List.result.spent = true;
    return;
  }
  if (Left <= 0)
  {
    List.result.spent = true;
    const Vec3 middle = TensorToReference(shape_, (part.box.lower + part.box.upper) / 2.0);
    List.AddUndecided(Evaluator.Near(middle, 0.5), 0, middle);
    return;
  }
  --Left;
  if (HasNone(part))
  {
    return;
  }
  const bool last = depth >= kMaxTurnDepth;
  if ((depth >= kFirstAsked || last) && Ask(part, last))
  {
    return;
  }
  const int direction = DirectionOf(part);
  const double middle = (part.box.lower[direction] + part.box.upper[direction]) / 2.0;
  CurvePart upper{ part.box, part.polynomials.Subdivide(direction) };
  upper.box.lower[direction] = middle;
  part.box.upper[direction] = middle;
  Visit(std::move(part), depth + 1);
  Visit(std::move(upper), depth + 1);
}

/// Whether c . (grad f x grad s) has one sign, by hulls of the derivatives.
bool TurnSearch::HasNone(const CurvePart& part) const
{
  Interval f[3];
  Interval s[3];
  for (int d = 0; d < 3; ++d)
  {
    const Interval perWidth = Interval(1.0) / Interval(part.box.upper[d] - part.box.lower[d]);
    const auto slope = [&](const BoxPolynomial& one)
    { return EncloseDerivative(one.degree, d, one.b, one.error, 0.0) * perWidth; };
    f[d] = slope(part.polynomials.f);
    s[d] = slope(part.polynomials.s);
  }
  Interval turn = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    const int i = (d + 1) % 3;
    const int j = (d + 2) % 3;
    turn += Interval(Along[d]) * (f[i] * s[j] - f[j] * s[i]);
  }
  return !turn.Contains(0.0);
}

/// c . (grad f x grad s), times a constant.
BoxPolynomial TurnSearch::TurnOver(const CurvePart& part) const
{
  BoxPolynomial f[3];
  BoxPolynomial s[3];
  for (int d = 0; d < 3; ++d)
  {
    f[d] = Derivative(part.polynomials.f, d);
    s[d] = Derivative(part.polynomials.s, d);
  }
  BoxPolynomial turn;
  for (int d = 0; d < 3; ++d)
  {
    const int i = (d + 1) % 3;
    const int j = (d + 2) % 3;
    // Derivatives are by the part's own coordinates. Any fixed direction works if the whole element
    // is searched along it.
    const double factor = Along[d] * (part.box.upper[d] - part.box.lower[d]);
    const BoxPolynomial one = Combine(factor, Multiply(f[i], s[j]), -factor, Multiply(f[j], s[i]));
    turn = d == 0 ? one : Combine(1.0, turn, 1.0, one);
  }
  return turn;
}

/// Calls the root finder. Returns false where it left boxes undecided and a smaller part may
/// succeed.
bool TurnSearch::Ask(const CurvePart& part, bool last)
{
  const BoxPolynomial turn = TurnOver(part);
  std::vector<TensorPolynomial> system;
  for (const BoxPolynomial* one : { &part.polynomials.f, &part.polynomials.s, &turn })
  {
    system.push_back({ one->degree, one->b, one->error });
  }
  RootSearch options;
  options.budget = last ? kLastBoxes : kTry;
  options.smallest = kSmallestBox;
  const RootSearchResult found = FindRoots(PolynomialSystem(3, system), options);
  Left -= static_cast<int>(found.boxes / 8);
  if (!last && !found.undecided.empty())
  {
    return false;
  }
  const auto toXi = [&](const Parameters& t)
  {
    return TensorToReference(
      shape_, Vec3(part.Between(0, t[0]), part.Between(1, t[1]), part.Between(2, t[2])));
  };
  for (const IsolatedRoot& root : found.roots)
  {
    List.AddRoot(Evaluator.Near(toXi(MiddleOf(root.enclosure)), Accuracy.reach), 0);
  }
  for (const ParameterBox& box : found.undecided)
  {
    const Vec3 xi = toXi(MiddleOf(box));
    List.AddUndecided(Evaluator.Near(xi, kNear), 0, xi);
  }
  return true;
}
} // namespace pixelexact
