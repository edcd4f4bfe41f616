// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Element/RangeIngredients.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/FaceModes.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace pixelexact
{
/// The children of a piece. The tree owns them with the piece, or `own` does if the trees are full.
struct PieceChildren
{
  const std::array<CurvedPiece, 2>* pieces = nullptr;
  std::shared_ptr<const std::array<CurvedPiece, 2>> own;
};

/// The pieces of an element's part of a surface. They are subdivided until they are flat, and
/// further where rays need it. Safe to use from several threads: pieces are read without a lock.
///
/// The memory of all trees of the process has a limit. Above it, GetChildren returns pieces that
/// belong to the caller. The numbers in pieces do not depend on their owner.
class PartTree
{
public:
  /// `faceModes`: for a face, its map; or null. All arguments must outlive the tree.
  PartTree(
    const CurvedEquation& equation, const CurvedPart& part, const FaceModes* faceModes = nullptr);

  ~PartTree();
  PartTree(const PartTree&) = delete;
  PartTree& operator=(const PartTree&) = delete;

  /// The tree's roots, which together are the whole part.
  [[nodiscard]] const std::vector<std::unique_ptr<CurvedPiece>>& Roots() const { return All; }
  [[nodiscard]] PieceChildren GetChildren(const CurvedPiece& piece) const;
  /// Estimated cost of subdividing a piece, in nanoseconds, if its children are not kept.
  [[nodiscard]] std::int64_t SplitCost() const { return CostOfChildren; }

  /// All trees together have reached the memory limit.
  [[nodiscard]] static bool AreFull();
  /// The bytes that all trees of the process keep, and their limit, 1 GiB by default. A lower limit
  /// does not free existing pieces.
  [[nodiscard]] static std::int64_t BytesKept();
  static void SetMostBytes(std::int64_t bytes);
  static constexpr std::int64_t kMaxBytes = std::int64_t{ 1 } << 30;

  /// The components of f, one after the other, scaled as f.
  [[nodiscard]] const ScaledModes& FieldModes() const { return *Field; }
  [[nodiscard]] double Value() const { return ScaledValue; }
  [[nodiscard]] const FaceModes* OnFace() const { return Modes; }
  /// The three coordinates over a piece, and f unless the part is a face or f is of a magnitude.
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(const CurvedPiece& piece) const;

  [[nodiscard]] std::int64_t Pieces() const { return Count.load(std::memory_order_relaxed); }

private:
  /// Polynomials of a piece, function by function: the coordinates, their derivatives, components
  /// of the field, their derivatives.
  using Polys = std::vector<BoxPolynomial>;

  /// Converts the functions over a piece or, for a face, over its side on the face, in the scales
  /// of the modes.
  [[nodiscard]] Polys Convert(const PieceForm::Piece& piece) const;
  /// Converts from the face's map alone: the slope across is zero, and the slopes along the face
  /// are the chart's.
  [[nodiscard]] Polys ConvertOnFace(const PieceForm::Piece& piece) const;
  /// Calls visit(Polys) with the same polynomials, which are kept if memory allows.
  template <class Visit>
  void WithConverted(const PieceForm::Piece& piece, const Visit& visit) const;
  /// Restricts converted polynomials to a box inside their piece. `slopes`: includes the
  /// derivatives.
  [[nodiscard]] Polys Restricted(const Polys& whole, const EtaBox& box, bool slopes) const;
  /// Count of the components of f.
  [[nodiscard]] int Components() const;
  void Fill(CurvedPiece& piece, Polys polys, int besides) const;
  void Describe(CurvedPiece& piece, const Polys& polys) const;
  void DescribeField(CurvedPiece& piece, const Polys& polys) const;
  void SetCurvature(CurvedPiece& piece, const Polys& polys) const;
  using Children = std::array<CurvedPiece, 2>;
  [[nodiscard]] std::unique_ptr<const Children> Split(
    const CurvedPiece& piece, Polys polys, int besides) const;
  [[nodiscard]] int DirectionOf(const CurvedPiece& piece, const Polys& polys) const;
  /// Change of the slopes of a magnitude's square along a direction.
  [[nodiscard]] double MagnitudeVariation(const Polys& polys, int direction) const;
  void Keep(std::int64_t bytes) const;

  CurvedEquation Equation;
  CurvedPart part_;
  const FaceModes* Modes;
  Shape shape_;
  ScaledModes Map;
  std::optional<ScaledModes> Field;
  double ScaledValue = 0.0;
  int Level = 0;
  double Uncertainty = 0.0;
  std::vector<std::unique_ptr<CurvedPiece>> All;
  mutable std::mutex Growing;
  mutable std::mutex Converting;
  mutable std::map<PieceForm::Piece, const Polys> Whole; ///< of pieces that rays have subdivided
  mutable std::atomic<std::int64_t> Count{ 0 };
  mutable std::atomic<std::int64_t> Bytes{ 0 };
  std::int64_t CostOfChildren = 0;
};
} // namespace pixelexact
