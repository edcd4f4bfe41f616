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
/// A piece's children. They belong to whom the piece belongs to, or to `own` where a tree keeps no
/// more.
struct PieceChildren
{
  const std::array<CurvedPiece, 2>* pieces = nullptr;
  std::shared_ptr<const std::array<CurvedPiece, 2>> own;
};

/// The pieces of an element's part of a surface: made until they are flat, and halved further where
/// rays need it. Safe to use from several threads: pieces are read without a lock.
///
/// What all trees of the process keep is limited. Above the limit GetChildren returns pieces that
/// belong to the caller. Which of the two it returns changes no number in them.
class PartTree
{
public:
  /// `faceModes`: of a face, what the map is there; or null. They must outlive the tree.
  PartTree(
    const CurvedEquation& equation, const CurvedPart& part, const FaceModes* faceModes = nullptr);

  ~PartTree();
  PartTree(const PartTree&) = delete;
  PartTree& operator=(const PartTree&) = delete;

  /// What the tree begins with; together the whole part.
  [[nodiscard]] const std::vector<std::unique_ptr<CurvedPiece>>& Roots() const { return All; }
  [[nodiscard]] PieceChildren GetChildren(const CurvedPiece& piece) const;
  /// About the nanoseconds that a piece's halves cost where they are not there yet.
  [[nodiscard]] std::int64_t SplitCost() const { return CostOfChildren; }

  /// Whether all trees together keep as much as they may.
  [[nodiscard]] static bool AreFull();
  /// The bytes that all trees of the process keep, and the limit, 1 GiB by default. Trees above a
  /// lower limit keep what they have.
  [[nodiscard]] static std::int64_t BytesKept();
  static void SetMostBytes(std::int64_t bytes);
  static constexpr std::int64_t kMaxBytes = std::int64_t{ 1 } << 30;

  /// Of the components that make f, scaled as f is: one after the other.
  [[nodiscard]] const ScaledModes& FieldModes() const { return *Field; }
  [[nodiscard]] double Value() const { return ScaledValue; }
  [[nodiscard]] const FaceModes* OnFace() const { return Modes; }
  /// The three coordinates over a piece, and f unless it is a face's or of a magnitude.
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(const CurvedPiece& piece) const;

  [[nodiscard]] std::int64_t Pieces() const { return Count.load(std::memory_order_relaxed); }

private:
  /// Of the map, by functions: the coordinates, their derivatives, components of the field, their
  /// derivatives.
  using Polys = std::vector<BoxPolynomial>;

  /// Over a piece of the conversion, on the face, in the scales of the modes.
  [[nodiscard]] Polys Convert(const PieceForm::Piece& piece) const;
  /// By what the map is on the face alone: it has no slope across, and those along are the chart's.
  [[nodiscard]] Polys ConvertOnFace(const PieceForm::Piece& piece) const;
  /// visit(Polys): the same, kept where that is allowed.
  template <class Visit>
  void WithConverted(const PieceForm::Piece& piece, const Visit& visit) const;
  /// What has been converted, over a box of it. Slopes only where they are wanted.
  [[nodiscard]] Polys Restricted(const Polys& whole, const EtaBox& box, bool slopes) const;
  /// How many components make f.
  [[nodiscard]] int Components() const;
  void Fill(CurvedPiece& piece, Polys polys, int besides) const;
  void Describe(CurvedPiece& piece, const Polys& polys) const;
  void DescribeField(CurvedPiece& piece, const Polys& polys) const;
  void SetCurvature(CurvedPiece& piece, const Polys& polys) const;
  using Children = std::array<CurvedPiece, 2>;
  [[nodiscard]] std::unique_ptr<const Children> Split(
    const CurvedPiece& piece, Polys polys, int besides) const;
  [[nodiscard]] int DirectionOf(const CurvedPiece& piece, const Polys& polys) const;
  /// How much the slopes of a magnitude's square change along a direction.
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
  mutable std::map<PieceForm::Piece, const Polys> Whole; ///< of pieces that rays need halved
  mutable std::atomic<std::int64_t> Count{ 0 };
  mutable std::atomic<std::int64_t> Bytes{ 0 };
  std::int64_t CostOfChildren = 0;
};
} // namespace pixelexact
