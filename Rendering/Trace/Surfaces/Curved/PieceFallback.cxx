// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceFallback.h"

#include "Core/Bernstein/RootFinder.h"
#include "Core/Math/Rounding.h"
#include "Trace/Scene.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
/// Largest count of the root finder's boxes in a piece, and how many are paid for at once.
constexpr int kBoxes = 500;
constexpr int kBoxesAtOnce = 20;
/// A piece's polynomials cost this fraction of its children's cost.
constexpr std::int64_t kPartOfChildren = 4;
/// Estimated costs, in nanoseconds, of a box of the root finder, and of each coefficient of an
/// equation.
constexpr std::int64_t kCostOfBox = 2000;
constexpr std::int64_t kCostOfCoefficient = 14;
constexpr int kPolish = 3;
/// Relative to an element's size.
constexpr double kBlurred = 0.1;

/// The polynomial y_a - s_a y_k - q_a over a piece.
TensorPolynomial Across(const BoxPolynomial& ya, const BoxPolynomial& yk, double slope, double q)
{
  TensorPolynomial result{ ya.degree, ya.b, 0.0 };
  double largest = std::fabs(q);
  for (std::size_t i = 0; i < result.coefficients.size(); ++i)
  {
    largest = std::max({ largest, std::fabs(ya.b[i]), std::fabs(slope * yk.b[i]) });
    result.coefficients[i] = ya.b[i] - slope * yk.b[i] - q;
  }
  // Roundings of this sum, and of slope and q.
  result.error = (ya.error + std::fabs(slope) * yk.error + Gamma(16) * largest) * (1.0 + Gamma(8));
  return result;
}

/// Two equations in two variables agree up to their errors: the ray lies in the plane of a flat
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

/// The equations of rays over a piece, in the piece's free directions.
class PieceSystem
{
public:
  PieceSystem(Shape shape, const RayBundle& bundle, const CurvedPiece& piece,
    const std::vector<BoxPolynomial>& polys)
    : shape_(shape)
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

  /// None if a ray lies in the plane of a flat face. Tests at most `most` boxes.
  [[nodiscard]] std::optional<RootSearchResult> Solve(
    int ray, const std::array<double, 2>& q, int most) const
  {
    const BoxPolynomial& along = Polys[static_cast<std::size_t>(Bundle.axes[2])];
    std::vector<TensorPolynomial> equations;
    for (std::size_t a = 0; a < 2; ++a)
    {
      equations.push_back(Across(Polys[static_cast<std::size_t>(Bundle.axes[a])], along,
        Bundle.slope[a][static_cast<std::size_t>(ray)], q[a]));
    }
    if (Polys.size() == 3 && AreOne(equations[0], equations[1]))
    {
      return std::nullopt;
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
    options.budget = most;
    return FindRoots(PolynomialSystem(static_cast<int>(Free.size()), equations), options);
  }

  /// Estimated cost of the root finder for a box, in nanoseconds.
  [[nodiscard]] std::int64_t BoxCost() const
  {
    return kCostOfBox +
      kCostOfCoefficient * static_cast<std::int64_t>(Polys.size() * Polys.front().b.size());
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
    return TensorToReference(shape_, eta);
  }

private:
  Shape shape_;
  const RayBundle& Bundle;
  const CurvedPiece& Piece;
  const std::vector<BoxPolynomial>& Polys;
  std::vector<int> Free; ///< directions of eta that the piece extends along
};
} // namespace

bool AreBlurred(const RayBundle& bundle, const Mesh& mesh, const CurvedPart& part)
{
  return bundle.MostSlack() > kBlurred * mesh.size[static_cast<std::size_t>(part.element)];
}

void AddUndecided(const RayBundle& bundle, const RayLanes& rays, PieceSolver& solver,
  const OpenPiece& open, std::vector<CurvedHit>& hits)
{
  const auto ray = static_cast<std::size_t>(bundle.First()) + static_cast<std::size_t>(open.ray);
  CurvedHit hit = solver.HitAt(*open.piece, open.ray, open.piece->centre, 0);
  hit.t = std::min(std::max(bundle.TimeOf(open.ray, open.depth), rays.tNear[ray]), rays.tFar[ray]);
  hit.status = HitStatus::Undecided;
  hits.push_back(hit);
}

void FindHits(const MetPart& met, PieceSolver& solver, const OpenPiece& open, EdgeWork& work,
  std::vector<CurvedHit>& hits)
{
  const CurvedEquation& equation = met.equation;
  // No polynomial of a magnitude's equation is available.
  const bool isMagnitude = equation.field != nullptr && equation.component == kMagnitude;
  if (isMagnitude || open.piece->plateau || AreBlurred(met.bundle, equation.mesh, met.part) ||
    !work.Affords(met.tree.SplitCost() / kPartOfChildren))
  {
    AddUndecided(met.bundle, met.rays, solver, open, hits);
    return;
  }
  const auto polys = met.tree.Polynomials(*open.piece);
  const PieceSystem system(equation.mesh.ShapeOf(met.part.element), met.bundle, *open.piece, polys);
  const std::int64_t cost = system.BoxCost();
  int most = 0;
  while (most < kBoxes && work.Affords(cost * kBoxesAtOnce))
  {
    most += kBoxesAtOnce;
  }
  const auto found =
    most > 0 ? system.Solve(open.ray, solver.Across(open.ray), most) : std::nullopt;
  if (!found || found->budgetSpent)
  {
    AddUndecided(met.bundle, met.rays, solver, open, hits);
  }
  if (!found)
  {
    return;
  }
  work.Spend(cost * (found->boxes - most));
  for (const IsolatedRoot& root : found->roots)
  {
    const auto middle = [&root](std::size_t v)
    { return std::clamp(root.enclosure[v].Middle(), 0.0, 1.0); };
    hits.push_back(solver.HitAt(
      *open.piece, open.ray, system.XiOf({ middle(0), middle(1), middle(2) }), kPolish));
  }
  for (const ParameterBox& box : found->undecided)
  {
    if (found->budgetSpent)
    {
      break;
    }
    const auto middle = [&box](std::size_t v) { return 0.5 * (box.lower[v] + box.upper[v]); };
    CurvedHit hit =
      solver.HitAt(*open.piece, open.ray, system.XiOf({ middle(0), middle(1), middle(2) }), 0);
    hit.status = HitStatus::Undecided;
    hits.push_back(hit);
  }
}
} // namespace pixelexact
