// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Location/Owners.h"
#include "Trace/Frame.h"
#include "Trace/RunsByKey.h"
#include "Trace/Scene.h"
#include "Trace/TraceTile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Writes samples to the frame's buffers, one buffer after the other. Rows of neighbouring samples
/// inside the mesh, which most samples are, are written together.
class SampleWriter
{
public:
  /// Sorts the samples by their verdicts. `place`: their places in the frame's buffers; must live
  /// until the next call. `complete`: these are all samples of a tile's lattice.
  void Sort(
    std::span<const Verdict> verdicts, std::span<const std::size_t> place, bool complete = false);

  [[nodiscard]] std::int64_t Exact() const { return ExactCount; }
  [[nodiscard]] std::int64_t Unknown() const { return static_cast<std::int64_t>(Unknowns.size()); }

  /// Sets buffer[place[i]] = valueOf(i) for the samples inside. Does nothing to an empty buffer.
  template <class T, class ValueOf>
  void WriteInside(std::vector<T>& buffer, const ValueOf& valueOf) const
  {
    if (buffer.empty())
    {
      return;
    }
    for (const std::size_t begin : Rows)
    {
      std::array<T, TileSamples::kRow> row;
      for (std::size_t k = 0; k < row.size(); ++k)
      {
        row[k] = valueOf(begin + k);
      }
      std::ranges::copy(row, &buffer[Place[begin]]);
    }
    WriteThese(Singles, buffer, valueOf);
  }

  /// The same for the samples inside and the undecided ones.
  template <class T, class ValueOf>
  void WriteHeld(std::vector<T>& buffer, const ValueOf& valueOf) const
  {
    WriteInside(buffer, valueOf);
    WriteThese(Unknowns, buffer, valueOf);
  }

private:
  template <class T, class ValueOf>
  void WriteThese(
    const std::vector<std::size_t>& samples, std::vector<T>& buffer, const ValueOf& valueOf) const
  {
    if (!buffer.empty())
    {
      for (const std::size_t i : samples)
      {
        buffer[Place[i]] = valueOf(i);
      }
    }
  }

  std::span<const std::size_t> Place;
  std::vector<std::size_t> Rows;     ///< first samples of rows that are inside
  std::vector<std::size_t> Singles;  ///< the other samples inside
  std::vector<std::size_t> Unknowns; ///< the undecided samples
  std::int64_t ExactCount = 0;
};

/// An array that keeps its memory and its entries when it is resized.
template <class T>
class Column
{
public:
  void Resize(std::size_t size)
  {
    if (Memory.size() < size)
    {
      Memory.resize(size);
    }
    All = std::span(Memory).first(size);
  }
  [[nodiscard]] std::span<T> View() const { return All; }
  [[nodiscard]] bool IsEmpty() const { return All.empty(); }
  [[nodiscard]] T& operator[](std::size_t i) const { return All[i]; }

private:
  std::vector<T> Memory;
  std::span<T> All;
};

/// The hits of one layer that a tile evaluates together, as a structure of arrays: entry i of each
/// column belongs to hit i. Hits have no other layout between the surfaces' slots and the frame's
/// buffers. Unneeded columns are empty.
class TileHits
{
public:
  /// A layer of the scene and all hits of the tile's rays with it.
  struct Source
  {
    const Layer& layer;
    std::uint8_t number; ///< of the layer
    const HitSlots& slots;
  };

  /// Takes the hits of all rays from slot 0, in place. Every ray must have a hit there. `place`:
  /// place of each ray in the buffers.
  void TakeFirstSlot(const Source& from, std::span<const std::size_t> place);
  /// Gathers one hit of each ray in `rays` (ascending), from that ray's entry of `slots`. Both
  /// arrays must live as long as the hits are used. `place`: place of each ray of the tile in the
  /// buffers.
  void Gather(const Source& from, std::span<const int> rays, std::span<const int> slots,
    std::span<const std::size_t> place);

  /// Locates the hits and evaluates the layer's field, as far as the buffers of `wanted` need it.
  /// Hits of surfaces that store elements are not located. An Undecided hit that is not outside
  /// gets the verdict Unknown. Adds to `check` if values are computed in floats.
  void Evaluate(const Locator& locator, const SampleBuffers& wanted, PrecisionCheck& check);
  /// Writes the hits that are not outside to their sheets, and counts them. `depth`: the sheet of
  /// each ray; empty: the nearest sheet. Owners are also written for hits outside the mesh but
  /// within its bounds.
  void Write(
    const Locator& locator, std::span<const int> depth, Sheets& sheets, FrameCounters& counters);

  [[nodiscard]] std::size_t Size() const { return Ray.size(); }
  [[nodiscard]] const Layer& GetLayer() const { return *Of; }
  [[nodiscard]] int RayOf(std::size_t i) const { return Ray[i]; }
  [[nodiscard]] std::span<const Verdict> Verdicts() const { return VerdictOf.View(); }

private:
  void Begin(const Source& from, std::span<const int> rays, std::span<const int> slots);
  void EvaluateInElements(const Mesh& mesh, const Field* field, const SampleTarget& target);
  void FindNormals(bool ofAll);
  void Reduce(std::size_t components);
  [[nodiscard]] std::span<const Verdict> VerdictsOn(int sheet);
  void WriteSheet(SampleBuffers& to) const;
  void WriteOwners(const Locator& locator, SampleBuffers& nearest);
  void Count(int sheet, std::span<const Verdict> verdicts, FrameCounters& counters) const;
  [[nodiscard]] LanePoints Positions() const;
  [[nodiscard]] Vec3 PositionOf(std::size_t i) const
  {
    return { Position[0][i], Position[1][i], Position[2][i] };
  }
  [[nodiscard]] HitStatus StatusOf(std::size_t i) const { return Slots->StatusOf(Slot[i], Ray[i]); }
  [[nodiscard]] SurfacePoint PointOf(std::size_t i) const
  {
    return Slots->PointOf(Slot[i], Ray[i]);
  }

  const Layer* Of = nullptr;
  std::uint8_t Number = 0;
  const HitSlots* Slots = nullptr;
  bool IsComplete = false; ///< one hit of each ray of the tile
  std::span<const int> Ray;
  std::span<const int> Slot;
  Column<int> Sheet;                  ///< empty: all hits are on the nearest
  std::span<const std::size_t> Place; ///< in the buffers
  const double* T = nullptr;          ///< padded, as Position
  std::array<const double*, 3> Position{};
  Column<Verdict> VerdictOf;
  Column<std::int32_t> Element;
  Column<Vec3> Xi;
  // All components of each hit during evaluation, then only the layer's component.
  Column<double> Value;
  Column<double> Lower;
  Column<double> Upper;
  Column<Vec3> Normal;
  // Scratch memory: columns that cannot be read in place, and arrays of single steps.
  std::vector<int> AllRays;    ///< 0, 1, 2 ...
  std::vector<int> FirstSlots; ///< zeros
  Column<std::size_t> Places;
  Column<double> Lanes;
  Column<double> XiLanes;
  Column<Verdict> OnSheet;
  std::vector<KeyRun> Runs;
  std::vector<int> OfElement;
  std::vector<SurfacePoint> Points;
  std::vector<Vec3> WorldPositions;
  std::vector<Owners> Counted;
  SampleWriter Writer;
};
} // namespace pixelexact
