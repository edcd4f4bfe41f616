// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeWork.h"
#include "Trace/Pipeline.h"
#include "Trace/TraceTile.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Verdict on a pixel: whether an iso-value occurs on its edge or, with ContourMethod::interior,
/// inside it (paper, section 5.3).
enum class ContourVerdict : std::uint8_t
{
  Out = 0, ///< proven: no iso-value occurs
  In = 1,  ///< proven: one occurs, or the field jumps across it
  Undecided = 2
};

/// Counts of a frame's pixels, for reports and tests.
struct ContourCounters
{
  std::int64_t in = 0;
  std::int64_t out = 0; ///< only pixels that show the mesh somewhere on their edge
  std::int64_t undecided = 0;
  std::int64_t jumps = 0;   ///< edges that are In because the field jumps across a value
  std::int64_t loops = 0;   ///< pixels that are In only by a value inside
  std::int64_t samples = 0; ///< without corners
  std::int64_t spent = 0;   ///< layers of tiles that exhausted their part of ContourMethod::work
  // Pixels by the step that decided them, summed over layers with iso-values: ranges and blocks,
  // with no corner traced; whole edges; subdivided edges.
  std::int64_t byBlocks = 0;
  std::int64_t byEdges = 0;
  std::int64_t byParts = 0;

  void Add(const ContourCounters& other);
};

/// How pixels are classified, and the limits.
struct ContourMethod
{
  /// Subdivisions of the paper's algorithm (ClassifyByIntervals); none: the project's algorithm.
  std::optional<int> subdivisions;
  // Limits of the project's algorithm.
  int edgeLevels = 8; ///< of an edge in one element
  int crossings = 12; ///< of an edge that leaves its element
  int parts = 16;     ///< open parts of an edge at once
  static constexpr int kAny = std::numeric_limits<int>::max();
  int samples = 20; ///< of an edge on a plane whose ends are on one side
  /// Work budget of a frame for samples and boxes of elements, in about nanoseconds (EdgeWork).
  std::int64_t work = 40'000'000'000;
  /// Searches iso-values also inside pixels whose edges are Out. Excludes the paper's algorithm.
  bool interior = false;
  int quarterings = 6; ///< levels of a pixel's square, for `interior`
  int squares = 64;    ///< open squares of a pixel at once

  /// Multiplies the limits by `effort`, 0.001 to 1000. A doubling adds one more subdivision of
  /// edges and of pixels.
  void SetEffort(double effort);

  bool operator==(const ContourMethod&) const = default;
};

class ContourBounds;

/// Classifies pixels by whether a layer's iso-values occur on their edges. ContourLines draws lines
/// from the verdicts.
class ContourCertifier final : public FrameModule
{
public:
  /// `values`: the iso-values of each of the scene's layers, in any order; duplicates are removed;
  /// an empty list: no contours on the layer. `bounds`: bounds of the fields, kept for later
  /// frames; null: they are computed for each frame. Throws Error for a value that is not finite
  /// and for a contradictory method. Process throws Error if the number of lists is not that of
  /// layers.
  explicit ContourCertifier(std::vector<std::vector<double>> values,
    const ContourMethod& method = {}, std::shared_ptr<ContourBounds> bounds = nullptr);
  ~ContourCertifier() override;
  ContourCertifier(const ContourCertifier&) = delete;
  ContourCertifier& operator=(const ContourCertifier&) = delete;

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;
  /// Second and third pass: tiles that exhausted their part of ContourMethod::work share the
  /// remaining work.
  [[nodiscard]] FrameModule* Rest() override;

  /// ContourVerdict of each pixel of the last frame, lower-left first.
  [[nodiscard]] const std::vector<std::uint8_t>& Verdicts() const { return Pixels; }
  [[nodiscard]] const ContourCounters& Counters() const { return Counted; }
  /// All corners of the pixel have one value up to rounding, so the place of a line is undefined.
  [[nodiscard]] bool IsOnPlateau(std::size_t pixel) const { return OnPlateau[pixel] != 0; }
  /// One of these pixels, or of those around them, is not Out. Exact up to squares of kTileSize.
  [[nodiscard]] bool HasLinesNear(const TileArea& pixels) const;
  /// Per layer, in ascending order, without duplicates.
  [[nodiscard]] const std::vector<std::vector<double>>& Values() const { return IsoValues; }

private:
  class Remainder final : public FrameModule
  {
  public:
    /// Runs after the pass with this number.
    Remainder(ContourCertifier& of, std::size_t pass, FrameModule* next)
      : Of(of)
      , Pass(pass)
      , Next(next)
    {
    }
    [[nodiscard]] SampleNeeds Needs() const override;
    void Begin(int /*width*/, int /*height*/) override {}
    void Process(TileVisit& tile) override;
    [[nodiscard]] FrameModule* Rest() override { return Next; }

  private:
    ContourCertifier& Of;
    std::size_t Pass;
    FrameModule* Next;
  };
  /// State of a classified tile.
  struct ClassifiedTile
  {
    TileArea area{};
    ContourCounters counters;
    std::vector<EdgeWork> works; ///< of its layers with iso-values
    std::int64_t spent = 0;      ///< in the last pass
  };
  /// The first pass visits all tiles. Each later pass visits the tiles that exhausted their work in
  /// the pass before.
  struct Pass
  {
    std::int64_t spent = 0;
    /// Tiles with exhausted work; complete when the next pass begins.
    std::vector<ClassifiedTile> left;
  };
  static constexpr std::size_t kPasses = 3;

  /// The layer has iso-values and a field.
  [[nodiscard]] bool HasLines(const Scene& scene, std::size_t layer) const;
  /// Work budget of a frame, in nanoseconds.
  [[nodiscard]] double WorkOf(const Scene& scene) const;
  void Classify(TileVisit& tile, std::int64_t most, ClassifiedTile& classified);
  void ProcessAgain(TileVisit& tile, std::size_t pass);
  /// Records a tile after a pass.
  void Take(ClassifiedTile classified, std::size_t pass);
  [[nodiscard]] std::vector<ContourVerdict> VerdictsOf(const TileArea& area) const;
  void Count(const ContourCounters& counters);
  /// Stores the verdicts of an area's pixels, row by row, and counts them.
  void Keep(
    const TileArea& area, std::span<const std::uint8_t> verdicts, ContourCounters& counters);
  /// Stores which of an area's pixels lie on a plateau, row by row.
  void KeepPlateaus(const TileArea& area, std::span<const std::uint8_t> onPlateau);
  [[nodiscard]] std::size_t PixelAt(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(Width) +
      static_cast<std::size_t>(x);
  }
  /// Index in Marked of the square in column `x` and row `y`.
  [[nodiscard]] std::size_t SquareAt(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(Across) +
      static_cast<std::size_t>(x);
  }

  std::vector<std::vector<double>> IsoValues;
  ContourMethod Method;
  std::shared_ptr<ContourBounds> Given;
  std::shared_ptr<ContourBounds> Bounds;
  std::vector<std::uint8_t> Pixels;
  std::vector<std::uint8_t> OnPlateau;
  int Width = 0;
  int Across = 0;                   ///< columns of squares with sides of kTileSize pixels
  std::vector<std::uint8_t> Marked; ///< 1: the square has a pixel that is not Out
  Remainder Last{ *this, 1, nullptr };
  Remainder Again{ *this, 0, &Last };
  std::mutex CountersMutex;
  ContourCounters Counted;
  std::array<Pass, kPasses> Passes;
};
} // namespace pixelexact
