// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

namespace pixelexact
{
/// t where a ray meets nothing.
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// What is known of a hit.
enum class HitStatus : std::uint8_t
{
  Certain,  ///< the surface is there, and between the ray's hits it is not
  Numeric,  ///< found by a search that may have overlooked others
  Undecided ///< whether the ray meets the surface there is not decided
};

/// Where rays meet a surface, padded as the rays are.
struct HitLanes
{
  double* t;
  double* position[3]; ///< the surface's point, on ray and surface up to rounding
};

/// Of a surface that is made of elements, which tells this of all of its hits: where on them they
/// are. They are not located, and so come to lie in no neighbour.
struct ElementLanes
{
  std::int32_t* element;
  double* xi[3];
};

/// Of a surface that is made of pieces: where on them its hits are, for its normals.
struct PieceLanes
{
  std::int32_t* piece;
  double* parameters[2];
};

/// A point of a surface; what a hit knows of it.
struct SurfacePoint
{
  Vec3 position;
  std::int32_t element = -1;
  Vec3 xi{ 0.0 };
  std::int32_t piece = -1;
  double parameters[2] = { 0.0, 0.0 };
};

/// All hits of one surface with the rays of a tile. The k-th hits of all rays are slot k; t does
/// not fall from slot to slot, and is kNoHit after a ray's last hit.
///
/// A surface is asked for some of the rays at a time, and its lanes begin with the first of these.
/// What it asks for for the first time in a tile holds nothing (kNoHit, Certain, -1) for all rays.
class HitSlots
{
public:
  /// Before a tile of so many rays: no hit anywhere.
  void Begin(int rays);
  /// The ray that lanes begin with from now on.
  void MoveTo(int first) { First = static_cast<std::size_t>(first); }

  // For surfaces. Slots come one after the other: k is at most Count().
  HitLanes Slot(int k);
  HitStatus* Status(int k);
  ElementLanes Elements(int k);
  PieceLanes Pieces(int k);

  // For readers: of all rays, whatever MoveTo said.
  [[nodiscard]] int Count() const { return Used; }
  [[nodiscard]] const double* T(int k) const { return At(k).t.data(); }
  [[nodiscard]] const double* Position(int k, int axis) const
  {
    return At(k).position.data() + static_cast<std::size_t>(axis) * Stride;
  }
  [[nodiscard]] HitStatus StatusOf(int k, int ray) const
  {
    const OneSlot& slot = At(k);
    return slot.hasStatus ? slot.status[static_cast<std::size_t>(ray)] : HitStatus::Certain;
  }
  /// Of any slot.
  [[nodiscard]] bool HasStatuses() const;
  [[nodiscard]] bool HasElements() const;
  [[nodiscard]] SurfacePoint PointOf(int k, int ray) const;

private:
  struct OneSlot
  {
    std::vector<double> t;
    std::vector<double> position; ///< coordinate by coordinate
    bool hasStatus = false;
    bool hasElements = false;
    bool hasPieces = false;
    std::vector<HitStatus> status;
    std::vector<std::int32_t> element;
    std::vector<double> xi;
    std::vector<std::int32_t> piece;
    std::vector<double> parameters;
  };
  [[nodiscard]] const OneSlot& At(int k) const { return Slots[static_cast<std::size_t>(k)]; }
  [[nodiscard]] OneSlot& At(int k) { return Slots[static_cast<std::size_t>(k)]; }

  std::deque<OneSlot> Slots; ///< kept from tile to tile
  std::size_t Stride = 0;
  std::size_t First = 0;
  int Rays = 0;
  int Used = 0;
};
} // namespace pixelexact
