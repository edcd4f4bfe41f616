// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PartTree.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"
#include "Trace/Surfaces/HitSlots.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace pixelexact
{
/// The hit of a ray with an element's part of a surface.
struct CurvedHit
{
  int ray = 0; ///< of the bundle
  double t = kNoHit;
  Vec3 position{ 0.0 };
  Vec3 xi{ 0.0 };
  std::int32_t part = -1;
  HitStatus status = HitStatus::Certain;
};

/// A ray and a piece in which its search did not end.
struct PieceRay
{
  const CurvedPiece* piece = nullptr;
  int ray = 0;
};

/// A piece in which a ray is open after all rays have been processed together.
struct OpenPiece
{
  const CurvedPiece* piece = nullptr;
  const PartTree* tree = nullptr;
  std::int32_t part = -1;
  int ray = 0;
  double depth = 0.0;                                    ///< RayBundle::DepthOf the piece's box
  std::shared_ptr<const std::array<CurvedPiece, 2>> own; ///< owner of a piece that no tree keeps
};

/// A part that rays of a bundle may meet.
struct PartAhead
{
  double depth = 0.0;
  std::int32_t part = -1;
  const Box3* box = nullptr;
};

/// Results of a solver, and its scratch memory.
struct SolverWork
{
  std::vector<PartAhead> parts;
  std::vector<CurvedHit> hits;
  std::vector<PieceRay> unclear;
  std::vector<OpenPiece> open;
  PiecePairs pairs;
  OpenRays near;
  OpenRays closer;
  std::vector<double> values = std::vector<double>(16 * PiecePairs::kStride);
  std::array<std::vector<double>, 4> ends{ Column(), Column(), Column(), Column() };

private:
  static std::vector<double> Column() { return std::vector<double>(PiecePairs::kStride); }
};

/// Solves, for rays of a bundle and pieces of one element's part,
///   y_a - s_a y_k = p_a - s_a p_k  for the two coordinates a across the ray, and f = 0,
/// by Newton's iteration that never leaves the piece. In a volume it starts where a ray has at most
/// one root on one side of a plane, and a step out of the piece ends it. On a face, such a step is
/// clamped to the boundary. The norm is one in which clamping increases no distance. So a step with
/// the piece's own matrix M reduces the distance to every root by the factor kappa, the norm of
/// |M^-1| times the ranges' radii. If kappa is below 1, the piece has at most one root, and a step
/// that reduces the residual less than this requires proves that it has none.
class PieceSolver
{
public:
  PieceSolver(const CurvedEquation& equation, const CurvedPart& part, const PartTree& tree,
    const RayBundle& bundle, SolverWork& work);

  /// Tests rays against a flat piece. Lists pairs for Solve where there may be a hit. Returns the
  /// rays for which the piece bends too much.
  [[nodiscard]] RaySet Look(const CurvedPiece& piece, const RaySet& rays);

  /// Solves all listed pairs. Appends to the work's hits, and appends pairs whose search did not
  /// end to `unclear`.
  void Solve();

  /// The point at xi after `steps` steps of Newton's iteration, as a hit of a ray that is known to
  /// meet it.
  [[nodiscard]] CurvedHit HitAt(const CurvedPiece& piece, int ray, const Vec3& xi, int steps);
  /// p_a - s_a p_k in the element's units.
  [[nodiscard]] std::array<double, 2> Across(int ray) const;

private:
  void Step(double* const position[3], double* result);
  /// Writes y, f and their derivatives by xi to rows of the work's values, for volumes.
  void Evaluate(double* const xi[3], int count);
  /// The same for faces: y, an unused row, derivatives by u and v.
  void EvaluateOnFace(double* const xi[3], int count);
  void EvaluateField(const LanePoints& xi, double* const out, double* const slope[3]);

  const CurvedEquation& Equation;
  const CurvedPart& Part;
  const PartTree& Tree;
  const RayBundle& Bundle;
  SolverWork& Work;
  ElementFrame Frame;
  std::optional<FaceMap> OnFace;
};
} // namespace pixelexact
