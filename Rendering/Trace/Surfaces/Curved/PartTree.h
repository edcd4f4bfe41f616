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
/// The pieces of an element's part of a surface: made until they are flat, and halved further where
/// rays need it. Safe to use from several threads: pieces are read without a lock.
class PartTree
{
public:
  /// `faceModes`: of a face, what the map is there; or null. They must outlive the tree.
  PartTree(
    const CurvedEquation& equation, const CurvedPart& part, const FaceModes* faceModes = nullptr);

  /// What the tree begins with; together the whole part.
  [[nodiscard]] const std::vector<std::unique_ptr<CurvedPiece>>& Roots() const { return All; }
  /// A piece's halves, made where they are not there yet.
  const std::array<CurvedPiece, 2>& Split(const CurvedPiece& piece) const;

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
  /// The same, kept.
  [[nodiscard]] const Polys& Converted(const PieceForm::Piece& piece) const;
  /// What has been converted, over a box of it. Slopes only where they are wanted.
  [[nodiscard]] Polys Restricted(const Polys& whole, const EtaBox& box, bool slopes) const;
  /// How many components make f.
  [[nodiscard]] int Components() const;
  void Fill(CurvedPiece& piece, Polys polys, int besides) const;
  void Describe(CurvedPiece& piece, const Polys& polys) const;
  void DescribeField(CurvedPiece& piece, const Polys& polys) const;
  void SetCurvature(CurvedPiece& piece, const Polys& polys) const;
  void SplitInto(const CurvedPiece& piece, Polys polys, int besides) const;
  [[nodiscard]] int DirectionOf(const CurvedPiece& piece, const Polys& polys) const;

  CurvedEquation Equation;
  CurvedPart ThePart;
  const FaceModes* Modes;
  Shape TheShape;
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
};
} // namespace pixelexact
