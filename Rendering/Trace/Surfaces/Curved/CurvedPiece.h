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
/// What elements' pieces of a surface have in common. Without a field, the surface is made of
/// elements' faces; else it lies where a component of the field has a value.
struct CurvedEquation
{
  Mesh mesh;
  const Field* field = nullptr;
  int component = 0; ///< or kMagnitude
  double value = 0.0;
};

/// An element's part of a surface: one of its faces (FacesOf), or what of an iso-surface is in it.
struct CurvedPart
{
  std::int32_t element = -1;
  std::int32_t face = -1;
};

/// A box of eta (of a face, flat), and what is proven of the four functions
///   y = Phi in the element's units,  f = the face's plane in xi, or (F - value) 2^-exponent
/// over it. Derivatives are by xi, which no collapsed edge makes singular.
///
/// A search goes past most pieces: what it asks first is in one line of the cache.
struct alignas(64) CurvedPiece
{
  Box3 bounds; ///< in world coordinates: no point of the surface's piece lies outside
  /// Null before the piece is split; an end without a surface has no bounds (lower > upper).
  mutable std::atomic<const std::array<CurvedPiece, 2>*> children{ nullptr };
  int subdivisions = 0;
  /// The ranges are so small that most rays are decided here, or it has been halved often enough to
  /// ask first.
  bool flat = false;
  /// f vanishes throughout, or all of a face's piece is one point, up to rounding: no halving
  /// decides what f is.
  bool plateau = false;
  /// Second derivatives are known.
  bool curves = false;

  /// Of a plateau: `halvings` of the largest piece about it that is one. A root of order n makes a
  /// plateau of all that is nearer than the n-th root of rounding: thin, but as wide as the
  /// element.
  int plateauFrom = 0;
  EtaBox box;
  Vec3 centre{ 0.0 };    ///< in xi
  Vec3 half{ 0.0 };      ///< the box lies within centre +- half
  double value[4] = {};  ///< at the centre
  double error[4] = {};  ///< of it, the map's uncertainty included
  double slope[4][3]{};  ///< derivatives at the centre; of a magnitude the middles of their ranges
  double radius[4][3]{}; ///< how far from these the derivatives are over the box
  /// How far the functions are over the box from value and slopes, as they are.
  double bend[4] = {};
  /// Second derivatives: of a slope d by xi_d, and by the next xi. At xi slope d is slope[c][d],
  /// shift[c][d] and these times xi - centre, up to the rest; of a piece that curves.
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
