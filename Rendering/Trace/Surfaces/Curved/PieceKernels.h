// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/FaceChart.h"
#include "Trace/Surfaces/Curved/RayBundle.h"

#include <array>
#include <cstdint>
#include <vector>

// Operations on many rays and pieces of one element, in lanes, dispatched at run time to the
// instruction set. All instruction sets give the same bits.
namespace pixelexact
{
/// An element's units, and its bounds of rounding.
struct ElementFrame
{
  Shape shape = Shape::Hexahedron;
  bool hasField = false;
  FaceChart chart; ///< without a field
  Vec3 centre{ 0.0 };
  double size = 1.0;
  double inverseSize = 1.0;
  double rounding = 0.0;  ///< error of y and f
  double tolerance = 0.0; ///< tolerance of y and f where the element's boundary clamps a step
};

/// A ray, a piece that it may meet in at most one point, and the state of the search. For a face,
/// matrix, box and norm are those of its chart, in the first 4, 2 and 2 of their columns.
enum PairColumn
{
  kOpenColumn, ///< 1: the pair is open; 0: it pads a pack, or has ended
  kRayColumn,
  kPieceColumn,                      ///< index in PiecePairs::pieces
  kSlopeColumn,                      ///< 2: of the ray
  kPlaceColumn = kSlopeColumn + 2,   ///< 2: q_a = p_a - s_a p_k, in the element's units
  kInverseColumn = kPlaceColumn + 2, ///< 9: of the piece's matrix, row by row
  kLowerColumn = kInverseColumn + 9, ///< 3: the piece's box
  kUpperColumn = kLowerColumn + 3,   ///< 3
  kKappaColumn = kUpperColumn + 3,
  kLastColumn, ///< the residual before a clamped step; 0: none
  kRoundsColumn,
  kXiColumn,                     ///< 3
  kNormColumn = kXiColumn + 3,   ///< 3: factors of the norm
  kSideColumn = kNormColumn + 3, ///< 3: in a volume, side . xi of a root is
  kMinColumn = kSideColumn + 3,  ///< at least this number
  kPairColumns
};

struct PiecePairs
{
  static constexpr int kMax = 768;
  static constexpr std::size_t kStride = kMax + 2 * kLanePadding;

  int count = 0;
  std::vector<const CurvedPiece*> pieces;
  std::vector<double> columns = std::vector<double>(kPairColumns * kStride);

  void Clear()
  {
    count = 0;
    pieces.clear();
  }
  /// Removes packs without open pairs.
  void DropEnded();
  [[nodiscard]] double* Column(int column)
  {
    return columns.data() + static_cast<std::size_t>(column) * kStride;
  }
};

enum class PairResult : std::uint8_t
{
  Again,
  Hit,
  Miss,
  Unclear
};

struct PieceKernels
{
  /// Returns the rays that may meet the box within their depths.
  RaySet (*meetBox)(const RayBundle& bundle, const Box3& box, const RaySet& rays);
  /// One step of all pairs of an iso-surface. `values` are y (3), f and their derivatives (9 and 3)
  /// at the pairs' xi, with `stride` numbers per row. Moves the pairs that continue.
  void (*step)(const RayBundle& bundle, const ElementFrame& frame, const double* values,
    std::size_t stride, PiecePairs& pairs, double* const position[3], double* result);
};

const PieceKernels& GetPieceKernels();
} // namespace pixelexact
