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

/// A ray and a piece in which it did not come to an end.
struct PieceRay
{
  const CurvedPiece* piece = nullptr;
  int ray = 0;
};

/// A piece in which a ray is open after all rays have been looked at together.
struct OpenPiece
{
  const CurvedPiece* piece = nullptr;
  const PartTree* tree = nullptr;
  std::int32_t part = -1;
  int ray = 0;
  double depth = 0.0;                                    ///< RayBundle::DepthOf its box
  std::shared_ptr<const std::array<CurvedPiece, 2>> own; ///< of a piece that no tree keeps
};

/// A part that rays of a bundle may meet.
struct PartAhead
{
  double depth = 0.0;
  std::int32_t part = -1;
  const Box3* box = nullptr;
};

/// What a solver leaves, and the room that it needs.
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
/// by Newton's iteration that never leaves the piece. In a volume it begins where a ray has one
/// root at most on one side of a plane, and a step out of the piece ends it. On a face such a step
/// is held back at the end. In the norm of the shape that brings no two points farther from each
/// other, so that a step with the piece's own matrix M brings every root nearer by the factor
/// kappa, the norm of |M^-1| times the ranges' radii: where kappa is below 1 the piece holds one
/// root at most, and a step after which the residual has not fallen as this demands proves that it
/// holds none.
class PieceSolver
{
public:
  PieceSolver(const CurvedEquation& equation, const CurvedPart& part, const PartTree& tree,
    const RayBundle& bundle, SolverWork& work);

  /// Of rays and a flat piece: lists for Solve where there may be a hit; returns the rays to which
  /// the piece bends too much.
  [[nodiscard]] RaySet Look(const CurvedPiece& piece, const RaySet& rays);

  /// Solves for all that is listed. Appends to the work's hits, and to `unclear` what did not come
  /// to an end.
  void Solve();

  /// The point at a xi, after some steps of Newton's iteration: as a hit of a ray that is known to
  /// be there.
  [[nodiscard]] CurvedHit HitAt(const CurvedPiece& piece, int ray, const Vec3& xi, int steps);
  /// p_a - s_a p_k in the element's units.
  [[nodiscard]] std::array<double, 2> Across(int ray) const;

private:
  void Step(double* const position[3], double* result);
  /// Into rows of the work's values, of volumes: y, f, their derivatives by xi.
  void Evaluate(double* const xi[3], int count);
  /// The same of faces: y, a row that is left out, their derivatives by u and v.
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
