// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceReferee.h"

#include "Core/Bernstein/RootFinder.h"
#include "Core/Math/Rounding.h"
#include "Trace/Scene.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kBoxes = 500;
constexpr int kPolish = 3;

/// y_a - s_a y_k - q_a over a piece.
TensorPolynomial Across(const BoxPolynomial& ya, const BoxPolynomial& yk, double slope, double q)
{
  TensorPolynomial result{ ya.degree, ya.b, 0.0 };
  double largest = std::fabs(q);
  for (std::size_t i = 0; i < result.coefficients.size(); ++i)
  {
    largest = std::max({ largest, std::fabs(ya.b[i]), std::fabs(slope * yk.b[i]) });
    result.coefficients[i] = ya.b[i] - slope * yk.b[i] - q;
  }
  // Roundings here, and of slope and q.
  result.error = (ya.error + std::fabs(slope) * yk.error + Gamma(16) * largest) * (1.0 + Gamma(8));
  return result;
}
/// Whether two equations in two variables are one, up to their errors: a ray in the plane of a flat
/// face.
bool AreOne(const TensorPolynomial& a, const TensorPolynomial& b)
{
  const double sizeA = LargestMagnitude(a.coefficients);
  const double sizeB = LargestMagnitude(b.coefficients);
  double same = 0.0;
  double opposite = 0.0;
  for (std::size_t i = 0; i < a.coefficients.size(); ++i)
  {
    const double x = a.coefficients[i] * sizeB;
    const double y = b.coefficients[i] * sizeA;
    same = std::max(same, std::fabs(x - y));
    opposite = std::max(opposite, std::fabs(x + y));
  }
  return std::min(same, opposite) <= 4.0 * (a.error * sizeB + b.error * sizeA);
}

CurvedHit UndecidedAt(PieceSolver& solver, const PieceRay& of, const Vec3& xi)
{
  CurvedHit hit = solver.HitAt(*of.piece, of.ray, xi, 0);
  hit.status = HitStatus::Undecided;
  return hit;
}
} // namespace

void FindHits(const CurvedEquation& equation, const CurvedPart& part, const PartTree& tree,
  const RayBundle& bundle, PieceSolver& solver, const PieceRay& of, int& boxes,
  std::vector<CurvedHit>& hits)
{
  const CurvedPiece& piece = *of.piece;
  const auto i = static_cast<std::size_t>(of.ray);
  const auto k = static_cast<std::size_t>(bundle.axes[2]);
  const Shape shape = equation.mesh.ShapeOf(part.element);
  const bool isMagnitude = equation.field != nullptr && equation.component == kMagnitude;
  if (isMagnitude || piece.plateau || boxes <= 0)
  {
    // A magnitude's equation is no polynomial that is kept.
    hits.push_back(UndecidedAt(solver, of, piece.centre));
    return;
  }
  // Directions of eta that the piece extends along.
  std::vector<int> free;
  for (int d = 0; d < 3; ++d)
  {
    if (piece.box.upper[d] > piece.box.lower[d])
    {
      free.push_back(d);
    }
  }
  const auto polys = tree.Polynomials(piece);
  const auto q = solver.Across(of.ray);
  std::vector<TensorPolynomial> equations;
  for (std::size_t a = 0; a < 2; ++a)
  {
    equations.push_back(
      Across(polys[static_cast<std::size_t>(bundle.axes[a])], polys[k], bundle.slope[a][i], q[a]));
  }
  if (polys.size() == 3 && AreOne(equations[0], equations[1]))
  {
    hits.push_back(UndecidedAt(solver, of, piece.centre));
    return;
  }
  if (polys.size() > 3)
  {
    equations.push_back({ polys[3].degree, polys[3].b, polys[3].error });
  }
  for (TensorPolynomial& one : equations)
  {
    Degrees degree{};
    for (std::size_t v = 0; v < free.size(); ++v)
    {
      degree[v] = one.degree[static_cast<std::size_t>(free[v])];
    }
    one.degree = degree;
  }
  const auto xiOf = [&](const Parameters& at)
  {
    Vec3 eta = 0.5 * (piece.box.lower + piece.box.upper);
    for (std::size_t v = 0; v < free.size(); ++v)
    {
      const int d = free[v];
      const double lower = piece.box.lower[d];
      eta[d] = std::clamp(lower + at[v] * (piece.box.upper[d] - lower), lower, piece.box.upper[d]);
    }
    return TensorToReference(shape, eta);
  };
  RootSearch options;
  options.budget = std::min(boxes, kBoxes);
  const RootSearchResult found =
    FindRoots(PolynomialSystem(static_cast<int>(free.size()), equations), options);
  boxes -= static_cast<int>(found.boxes);
  for (const IsolatedRoot& root : found.roots)
  {
    Parameters middle{};
    for (std::size_t v = 0; v < free.size(); ++v)
    {
      middle[v] = std::clamp(root.enclosure[v].Middle(), 0.0, 1.0);
    }
    hits.push_back(solver.HitAt(piece, of.ray, xiOf(middle), kPolish));
  }
  for (const ParameterBox& box : found.undecided)
  {
    Parameters middle{};
    for (std::size_t v = 0; v < free.size(); ++v)
    {
      middle[v] = 0.5 * (box.lower[v] + box.upper[v]);
    }
    hits.push_back(UndecidedAt(solver, of, xiOf(middle)));
  }
}
} // namespace pixelexact
