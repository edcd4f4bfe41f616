// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/PartTree.h"
#include "Trace/Surfaces/Curved/RayBundle.h"
#include "Trace/Surfaces/HitSlots.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Where a ray meets an element's part of a surface.
struct CurvedHit
{
  int ray = 0; ///< of the bundle
  double t = kNoHit;
  Vec3 position{ 0.0 };
  Vec3 xi{ 0.0 };
  std::int32_t part = -1;
  HitStatus status = HitStatus::Certain;
};

/// A ray and a piece that it may meet in one point at most.
struct PieceRay
{
  const CurvedPiece* piece = nullptr;
  int ray = 0;
};

/// Solves, for rays of a bundle and pieces of one element's part,
///   y_a - s_a y_k = p_a - s_a p_k  for the two coordinates a across the ray, and f = 0,
/// by Newton's iteration that never leaves the piece: a step that does is clamped to it. In the
/// norm of the shape the clamp brings no two points farther from each other, so that a step with
/// the piece's own matrix M brings every root nearer by the factor kappa, the norm of |M^-1| times
/// the ranges' radii: where kappa is below 1 the piece holds one root at most, and a clamped step
/// after which the residual has not fallen as this demands proves that it holds none.
class PieceSolver
{
public:
  /// What is known of a ray in a piece without evaluating the functions.
  enum class Outlook
  {
    Misses, ///< proven
    May,    ///< one root at most
    Unclear ///< the piece bends too much as seen by the ray
  };

  PieceSolver(const CurvedEquation& equation, const CurvedPart& part, const PartTree& tree,
    const RayBundle& bundle);

  /// Of a ray and a flat piece. Where it May, the pair is listed for Solve.
  Outlook Look(const CurvedPiece& piece, int ray);

  /// Solves for all that is listed, and empties the list. Appends hits, and to `unclear` what did
  /// not settle.
  void Solve(std::vector<CurvedHit>& hits, std::vector<PieceRay>& unclear);

  /// The point at a xi, after some steps of Newton's iteration: as a hit of a ray that is known to
  /// be there.
  [[nodiscard]] CurvedHit HitAt(const CurvedPiece& piece, int ray, Vec3 xi, int steps);
  /// q_a = p_a - s_a p_k in the element's units.
  [[nodiscard]] std::array<double, 2> Across(int ray) const;

private:
  struct Pair
  {
    PieceRay of;
    std::array<double, 9> inverse; ///< of the piece's matrix, row by row
    Vec3 xi{ 0.0 };
    double kappa = 0.0;
    double last = 0.0; ///< the residual before a clamped step; 0: none
    int rounds = 0;
  };
  enum class Next
  {
    Again,
    Hit,
    Miss,
    Unclear
  };

  struct Values
  {
    double value[4];
    double slope[4][3];
  };
  struct Residual
  {
    double g[3];
    double slope[3][3];
  };
  void Evaluate(std::span<const Vec3> xi);
  void EvaluateField(const double* const xi[3], int count);
  [[nodiscard]] Values At(std::size_t i) const;
  [[nodiscard]] Residual ResidualOf(const CurvedPiece& piece, int ray, const Values& at) const;
  Next Step(Pair& pair, const Values& at, Vec3& position) const;
  [[nodiscard]] Vec3 World(const Values& at, const Vec3& step) const;

  const CurvedEquation& Equation;
  const CurvedPart& Part;
  const PartTree& Tree;
  const RayBundle& Bundle;
  Shape TheShape;
  Vec3 Centre;
  double Size;
  double InverseSize;
  double Uncertainty;
  double FieldScale;
  std::vector<Pair> Pairs;
  std::vector<double> Lanes;
  std::size_t Stride = 0;
};

/// The point of a piece that is taken for a xi outside of it: along each direction of eta in turn,
/// from the last to the first, the nearest.
Vec3 ClampTo(Shape shape, const EtaBox& box, const Vec3& xi);
/// The factors of the maximum norm of a shape in which ClampTo brings no two points farther from
/// each other: the ends of a tetrahedron's eta_1 move with both other coordinates.
const Vec3& NormOf(Shape shape);
} // namespace pixelexact
