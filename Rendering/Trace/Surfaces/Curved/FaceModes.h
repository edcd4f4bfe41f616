// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/RangeIngredients.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/FaceChart.h"

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace pixelexact
{
/// The map on a face as a polynomial of its chart (FaceChart) alone: what Newton's iteration and
/// normals ask for has fewer modes than in the element, and two slopes.
struct FaceModes
{
  /// Of a hexahedron or, of triangles, a prism, without order along xi2: u is its xi1, v its xi3.
  Space space;
  std::vector<double> coefficients; ///< three components, in the element's units
  /// No coordinate is farther from the element's map, on the face: some roundings.
  double error = 0.0;

  /// The same of derivatives by u and v (Markov's inequality on a body as wide as the face's).
  [[nodiscard]] double SlopeError() const
  {
    const double n = space.MaxOrder();
    return 4.0 * n * n * error;
  }
};

/// What a function of the chart is over the face's side of a piece of the element, along the
/// element's directions.
[[nodiscard]] BoxPolynomial OverFace(const FaceChart& chart, const RangeIngredient& ingredient,
  int level, const PieceForm::Piece& piece);

/// The map of an element on one of its faces, in the element's units.
class FaceMap
{
public:
  /// `modes`: of the face, or null. What is referred to must outlive it.
  FaceMap(const Mesh& mesh, const CurvedPart& part, const FaceModes* modes);

  /// At points of the face: value[c] of each coordinate, and slope[2 c + j], its derivatives by u
  /// (j = 0) and v. slope[6] is room. Arrays hold PaddedCount(xi.count) doubles.
  void Evaluate(const LanePoints& xi, double* const value[3], double* const slope[7]) const;
  [[nodiscard]] const FaceChart& Chart() const { return chart_; }
  /// Of the product of the slopes by u and v, where the Jacobian is positive: 1 if it points out of
  /// the element, else -1.
  [[nodiscard]] double OutwardSign() const;

private:
  void EvaluateInElement(
    const LanePoints& xi, double* const value[3], double* const slope[7]) const;

  FaceChart chart_;
  Vec3 Inwards; ///< in xi
  const FaceModes* Modes;
  const Space& InElement;
  const double* Coefficients;
};

/// Makes FaceModes. What faces of one number have in common in elements of one space is made once.
/// Safe to use from several threads.
class FaceRestriction
{
public:
  /// None where the map on the face is no polynomial of the chart, as on triangles of pyramids in
  /// tensor form, and above kHighestOrder.
  [[nodiscard]] std::optional<FaceModes> Of(const Mesh& mesh, const CurvedPart& part) const;

  /// Matrices of higher orders are large, and seldom wanted.
  static constexpr int kHighestOrder = 12;

private:
  /// From an element's modes to a face's.
  struct Change
  {
    ChangeOfBasis matrix;
    std::vector<double> largest;   ///< of each of the face's modes, on the face
    std::vector<double> inElement; ///< of each of the element's, in it
  };
  using Key = std::pair<Space, std::int32_t>;
  [[nodiscard]] const Change* ChangeFor(const Space& space, std::int32_t face) const;

  mutable std::mutex Making;
  mutable std::map<Key, std::unique_ptr<const Change>> Made; ///< null where there is none
};
} // namespace pixelexact
