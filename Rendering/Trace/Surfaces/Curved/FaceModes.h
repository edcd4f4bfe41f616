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
/// The map on a face as a polynomial of its chart (FaceChart). Newton's iteration and normals need
/// fewer modes of it than in the element, and two slopes.
struct FaceModes
{
  /// The space of a hexahedron or, for triangles, of a prism, of order 0 along xi2: u is its xi1, v
  /// its xi3.
  Space space;
  std::vector<double> coefficients; ///< three components, in the element's units
  /// Largest difference of a coordinate from the element's map on the face: some roundings.
  double error = 0.0;

  /// The same for derivatives by u and v (Markov's inequality on a body as wide as the face).
  [[nodiscard]] double SlopeError() const
  {
    const double n = space.MaxOrder();
    return 4.0 * n * n * error;
  }
};

/// The polynomial, over the face's side of a piece of the element, of a function of the chart, in
/// the element's directions.
[[nodiscard]] BoxPolynomial OverFace(const FaceChart& chart, const RangeIngredient& ingredient,
  int level, const PieceForm::Piece& piece);

/// The map of an element on one of its faces, in the element's units.
class FaceMap
{
public:
  /// `modes`: of the face, or null. The arguments' objects must outlive the map.
  FaceMap(const Mesh& mesh, const CurvedPart& part, const FaceModes* modes);

  /// Evaluates points of the face: value[c] is coordinate c, slope[2 c + j] its derivative by u (j
  /// = 0) or v. slope[6] is scratch memory. Arrays hold PaddedCount(xi.count) doubles.
  void Evaluate(const LanePoints& xi, double* const value[3], double* const slope[7]) const;
  [[nodiscard]] const FaceChart& Chart() const { return chart_; }
  /// 1 if the cross product of the slopes by u and v points out of the element where the Jacobian
  /// is positive, else -1.
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

/// Computes FaceModes. The matrices for a face number and a space of elements are computed once.
/// Safe to use from several threads.
class FaceRestriction
{
public:
  /// None if the map on the face is not a polynomial of the chart, as on triangles of pyramids in
  /// tensor form, and for orders above kHighestOrder.
  [[nodiscard]] std::optional<FaceModes> Of(const Mesh& mesh, const CurvedPart& part) const;

  /// Matrices of higher orders are large, and seldom needed.
  static constexpr int kHighestOrder = 12;

private:
  /// The change from an element's modes to a face's.
  struct Change
  {
    ChangeOfBasis matrix;
    std::vector<double> largest;   ///< largest magnitude of each of the face's modes, on the face
    std::vector<double> inElement; ///< the same of each of the element's modes, in the element
  };
  using Key = std::pair<Space, std::int32_t>;
  [[nodiscard]] const Change* ChangeFor(const Space& space, std::int32_t face) const;

  mutable std::mutex Making;
  mutable std::map<Key, std::unique_ptr<const Change>> Made; ///< null where there is none
};
} // namespace pixelexact
