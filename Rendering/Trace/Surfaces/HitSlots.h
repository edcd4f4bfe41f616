// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

namespace pixelexact
{
/// t of a ray without a hit.
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Reliability of a hit.
enum class HitStatus : std::uint8_t
{
  Certain,  ///< the hit exists, and there is none between the ray's hits
  Numeric,  ///< found by a search that may have missed other hits
  Undecided ///< it is undecided whether the ray meets the surface here
};

/// Intersections of rays with a surface; arrays are padded as the rays' are.
struct HitLanes
{
  double* t;
  double* position[3]; ///< on ray and surface up to rounding
};

/// Elements and xi of the hits of a mesh surface, which stores them for all of its hits. These hits
/// are not located, so that they cannot fall into a neighbour.
struct ElementLanes
{
  std::int32_t* element;
  double* xi[3];
};

/// Pieces and parameters of the hits of a surface that consists of pieces, for its normals.
struct PieceLanes
{
  std::int32_t* piece;
  double* parameters[2];
};

/// A point of a surface, with the data of its hit.
struct SurfacePoint
{
  Vec3 position;
  std::int32_t element = -1;
  Vec3 xi{ 0.0 };
  std::int32_t piece = -1;
  double parameters[2] = { 0.0, 0.0 };
};

/// All hits of one surface with the rays of a tile. The k-th hits of all rays are slot k; t does
/// not decrease from slot to slot, and is kNoHit after a ray's last hit.
///
/// A surface fills the slots for some of the rays at a time; its lanes begin with the first of
/// these rays. Lanes that it requests for the first time in a tile are reset for all rays (kNoHit,
/// Certain, -1).
class HitSlots
{
public:
  /// Resets the slots for a tile of `rays` rays.
  void Begin(int rays);
  /// Sets the ray that lanes begin with.
  void MoveTo(int first) { First = static_cast<std::size_t>(first); }

  // For surfaces. Slots are filled in order: k is at most Count().
  HitLanes Slot(int k);
  HitStatus* Status(int k);
  ElementLanes Elements(int k);
  PieceLanes Pieces(int k);

  // For readers: of all rays, independent of MoveTo.
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
  /// Some slot has statuses, or elements.
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
