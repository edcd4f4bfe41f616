// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/BezierBend.h"
#include "Trace/Surfaces/HitSlots.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Patches, and the edges that they share with control points equal to the bit. Bounds the distance
/// of the patches from chords between hits.
class BezierSeams
{
public:
  BezierSeams() = default;
  explicit BezierSeams(std::span<const BezierPatch> patches);

  /// As Surface::Sagitta, for hits with patch and parameters: inside one patch, or across one edge
  /// that two patches share.
  [[nodiscard]] double Sagitta(
    const Chord& chord, const SurfacePoint& from, const SurfacePoint& to) const;

private:
  /// The edges u = 0, u = 1, v = 0, v = 1; places on them grow with the other parameter.
  static constexpr int kEdges = 4;
  /// The patch on the other side of an edge.
  struct Neighbour
  {
    std::int32_t patch = -1;
    int edge = 0;
    bool reversed = false;
  };

  [[nodiscard]] const BezierBend& BendOf(std::int32_t patch) const
  {
    return Bends[static_cast<std::size_t>(patch)];
  }
  void Join(std::span<const BezierPatch> patches);
  [[nodiscard]] double Across(const Chord& chord, std::int32_t patch, int edge,
    const BezierBend::Place& from, const BezierBend::Place& to) const;

  std::vector<BezierBend> Bends;
  std::vector<std::array<Neighbour, kEdges>> Beyond;
};
} // namespace pixelexact
