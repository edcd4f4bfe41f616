// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Tree/EtaBox.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

namespace pixelexact
{
/// The equation of a surface, common to all elements' pieces. Without a field, the surface consists
/// of elements' faces; otherwise it is the set where a component of the field has a value.
struct CurvedEquation
{
  Mesh mesh;
  const Field* field = nullptr;
  int component = 0; ///< or kMagnitude
  double value = 0.0;
};

/// An element's part of a surface: one of its faces (FacesOf), or the part of an iso-surface in it.
struct CurvedPart
{
  std::int32_t element = -1;
  std::int32_t face = -1;
};

/// A box of eta (for a face, flat), and bounds over it of the four functions
///   y = Phi in the element's units,  f = the face's plane in xi, or (F - value) 2^-exponent.
/// Derivatives are by xi, so that collapsed edges cause no singularity.
///
/// Most pieces are skipped by a search; the members that it reads first share a cache line.
struct alignas(64) CurvedPiece
{
  Box3 bounds; ///< in world coordinates; contains the piece of the surface
  /// Null before the piece is subdivided. A leaf without a surface has empty bounds (lower >
  /// upper).
  mutable std::atomic<const std::array<CurvedPiece, 2>*> children{ nullptr };
  int subdivisions = 0;
  /// The ranges are so small that most rays are decided here, or the piece has been subdivided so
  /// often that it is tested first.
  bool flat = false;
  /// f vanishes everywhere, or a face's piece is a single point, up to rounding, so subdivision
  /// does not decide anything.
  bool plateau = false;
  /// Second derivatives are known.
  bool curves = false;

  /// On a plateau: `subdivisions` of the largest plateau piece around this one. Near a root of
  /// order n, all points closer than the n-th root of rounding form a plateau: thin, but as wide as
  /// the element.
  int plateauFrom = 0;
  EtaBox box;
  Vec3 centre{ 0.0 };   ///< in xi
  Vec3 half{ 0.0 };     ///< the box lies within centre +- half
  double value[4] = {}; ///< at the centre
  double error[4] = {}; ///< error of `value`, including the map's uncertainty
  double slope[4][3]{}; ///< derivatives at the centre; for a magnitude, the middles of their ranges
  double radius[4][3]{}; ///< largest deviation of the derivatives over the box
  /// Largest deviation, over the box, of the functions from value plus slopes.
  double bend[4] = {};
  /// Second derivatives of a piece that curves: three of slope d by xi_d, then three by the next
  /// xi. At xi, slope d is slope[c][d], plus shift[c][d], plus these times xi - centre, with an
  /// error of at most `rest`.
  float curve[4][6]{};
  float shift[4][3]{};
  float rest[4][3]{};

  CurvedPiece() = default;
  ~CurvedPiece() { delete children.load(std::memory_order_relaxed); }
  CurvedPiece(const CurvedPiece&) = delete;
  CurvedPiece& operator=(const CurvedPiece&) = delete;

  [[nodiscard]] bool IsEmpty() const { return bounds.lower.x > bounds.upper.x; }
};
} // namespace pixelexact
