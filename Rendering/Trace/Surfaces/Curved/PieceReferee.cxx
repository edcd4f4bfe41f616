// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceReferee.h"

#include "Core/Bernstein/RootFinder.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kBoxes = 2000;
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

/// The equations of rays over a piece, and what its parameters stand for.
class PieceSystem
{
public:
  PieceSystem(Shape shape, const RayBundle& bundle, const CurvedPiece& piece,
    const std::vector<BoxPolynomial>& polys)
    : TheShape(shape)
    , Bundle(bundle)
    , Piece(piece)
    , Polys(polys)
  {
    for (int d = 0; d < 3; ++d)
    {
      if (piece.box.upper[d] > piece.box.lower[d])
      {
        Free.push_back(d);
      }
    }
  }

  /// Of a magnitude, f is no polynomial that is kept.
  [[nodiscard]] bool IsSquare() const { return Polys.size() == Free.size() + 1; }

  [[nodiscard]] RootSearchResult Solve(int ray, const std::array<double, 2>& q) const
  {
    const BoxPolynomial& along = Polys[static_cast<std::size_t>(Bundle.axes[2])];
    std::vector<TensorPolynomial> equations;
    for (std::size_t a = 0; a < 2; ++a)
    {
      equations.push_back(Across(Polys[static_cast<std::size_t>(Bundle.axes[a])], along,
        Bundle.slope[a][static_cast<std::size_t>(ray)], q[a]));
    }
    if (Polys.size() > 3)
    {
      equations.push_back({ Polys[3].degree, Polys[3].b, Polys[3].error });
    }
    for (TensorPolynomial& one : equations)
    {
      Degrees degree{};
      for (std::size_t v = 0; v < Free.size(); ++v)
      {
        degree[v] = one.degree[static_cast<std::size_t>(Free[v])];
      }
      one.degree = degree;
    }
    RootSearch options;
    options.budget = kBoxes;
    return FindRoots(PolynomialSystem(static_cast<int>(Free.size()), equations), options);
  }

  [[nodiscard]] Vec3 XiOf(const Parameters& at) const
  {
    Vec3 eta = Piece.box.lower;
    for (std::size_t v = 0; v < Free.size(); ++v)
    {
      const int d = Free[v];
      const double lower = Piece.box.lower[d];
      const double upper = Piece.box.upper[d];
      eta[d] = std::clamp(lower + at[v] * (upper - lower), lower, upper);
    }
    return TensorToReference(TheShape, eta);
  }

private:
  Shape TheShape;
  const RayBundle& Bundle;
  const CurvedPiece& Piece;
  const std::vector<BoxPolynomial>& Polys;
  std::vector<int> Free; ///< directions of eta that the piece extends along
};
} // namespace

void FindHits(Shape shape, const PartTree& tree, const RayBundle& bundle, PieceSolver& solver,
  const CurvedPiece& piece, const RaySet& rays, std::vector<CurvedHit>& hits)
{
  const auto polys = tree.Polynomials(piece);
  const PieceSystem system(shape, bundle, piece, polys);
  const auto addUndecided = [&](int ray, const Vec3& xi)
  {
    CurvedHit hit = solver.HitAt(piece, ray, xi, 0);
    hit.status = HitStatus::Undecided;
    hits.push_back(hit);
  };
  rays.ForEach(
    [&](int ray)
    {
      if (!system.IsSquare())
      {
        addUndecided(ray, piece.centre);
        return;
      }
      const RootSearchResult found = system.Solve(ray, solver.Across(ray));
      for (const IsolatedRoot& root : found.roots)
      {
        const auto middle = [&root](std::size_t v) { return root.enclosure[v].Middle(); };
        hits.push_back(
          solver.HitAt(piece, ray, system.XiOf({ middle(0), middle(1), middle(2) }), kPolish));
      }
      for (const ParameterBox& box : found.undecided)
      {
        const auto middle = [&box](std::size_t v) { return 0.5 * (box.lower[v] + box.upper[v]); };
        addUndecided(ray, system.XiOf({ middle(0), middle(1), middle(2) }));
      }
    });
}
} // namespace pixelexact
