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
/// What is known of a pixel and the iso-values (paper, section 5.3): whether one of them occurs on
/// its edge or, with ContourMethod::interior, in it.
enum class ContourVerdict : std::uint8_t
{
  Out = 0, ///< proven: none does
  In = 1,  ///< proven: one does, or the field jumps across it there
  Undecided = 2
};

/// What a frame's pixels are, for reports and tests.
struct ContourCounters
{
  std::int64_t in = 0;
  std::int64_t out = 0; ///< of pixels that show the mesh somewhere on their edge
  std::int64_t undecided = 0;
  std::int64_t jumps = 0;   ///< edges that are in because the field jumps across a value
  std::int64_t loops = 0;   ///< pixels that are in because of a value inside alone
  std::int64_t samples = 0; ///< beside the corners
  std::int64_t spent = 0;   ///< tiles of layers in which their part of ContourMethod::work ran out
  // By what pixels are settled, those of each layer with values: by ranges, by blocks of them and
  // by what is known of these, with no corner traced; by whole edges; by edges that were halved.
  std::int64_t byBlocks = 0;
  std::int64_t byEdges = 0;
  std::int64_t byParts = 0;

  void Add(const ContourCounters& other);
};

/// How pixels are told.
struct ContourMethod
{
  /// The paper's algorithm with so many subdivisions (ClassifyByIntervals); none: the project's
  /// own.
  std::optional<int> subdivisions;
  // What may be spent on an edge by the project's own.
  int subdivisions = 8; ///< of an edge in one element
  int crossings = 12;   ///< of one that leaves its element
  int parts = 16;       ///< of an edge that are open at once
  static constexpr int kAny = std::numeric_limits<int>::max();
  int samples = 20; ///< of an edge on a plane, but between values on two sides
  /// On samples and on boxes of elements, for a frame, in about nanoseconds (EdgeWork).
  std::int64_t work = 40'000'000'000;
  /// Whether values are looked for inside of pixels on whose edges there are none, too; not with
  /// subdivisions.
  bool interior = false;
  int quarterings = 6; ///< of a pixel's square, for that
  int squares = 64;    ///< of a pixel that are open at once

  /// Multiplies the limits by `effort`, 0.001 to 1000. A doubling adds one more subdivision of
  /// edges and of pixels.
  void SetEffort(double effort);

  bool operator==(const ContourMethod&) const = default;
};

class ContourBounds;

/// Which of a layer's iso-values occur on the edges of a pixel: the verdicts, with which lines are
/// drawn (ContourLines).
class ContourCertifier final : public FrameModule
{
public:
  /// `values`: of each of the scene's layers its iso-values, in any order, each counted once; none:
  /// no contours on it.
  /// `bounds`: what is known of the fields, to be used again; null: it is found out for each frame.
  /// Throws Error for a value that is not finite, and for a method that contradicts itself; Process
  /// does for fewer or more lists than layers.
  explicit ContourCertifier(std::vector<std::vector<double>> values,
    const ContourMethod& method = {}, std::shared_ptr<ContourBounds> bounds = nullptr);
  ~ContourCertifier() override;
  ContourCertifier(const ContourCertifier&) = delete;
  ContourCertifier& operator=(const ContourCertifier&) = delete;

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;
  /// Tiles in which their part of ContourMethod::work ran out get what others left.
  [[nodiscard]] FrameModule* Rest() override;

  /// Of the last frame: a ContourVerdict for each pixel, lower-left first.
  [[nodiscard]] const std::vector<std::uint8_t>& Verdicts() const { return Pixels; }
  [[nodiscard]] const ContourCounters& Counters() const { return Counted; }
  /// Whether all corners of a pixel have one value, up to rounding, so that there is no telling
  /// where a line goes.
  [[nodiscard]] bool IsOnPlateau(std::size_t pixel) const { return OnPlateau[pixel] != 0; }
  /// Whether some of these pixels, or of those about them, are not Out.
  [[nodiscard]] bool HasLinesNear(const TileArea& pixels) const;
  /// In ascending order, each once.
  [[nodiscard]] const std::vector<std::vector<double>>& Values() const { return IsoValues; }

private:
  class Remainder final : public FrameModule
  {
  public:
    /// After the pass of this number.
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
  /// A tile, as far as it is judged.
  struct ClassifiedTile
  {
    TileArea area{};
    ContourCounters counters;
    std::vector<EdgeWork> works; ///< of its layers with lines
    std::int64_t spent = 0;      ///< the last time
  };
  /// All tiles once, or those of the pass before in which it ran out.
  struct Pass
  {
    std::int64_t spent = 0;
    std::vector<ClassifiedTile> left; ///< in which it ran out; complete when the next pass begins
  };
  static constexpr std::size_t kPasses = 3;

  /// The project's own, with so much to spend; keeps the verdicts. A tile that was judged before
  /// goes on where it ended.
  [[nodiscard]] bool HasLines(const Scene& scene, std::size_t layer) const;
  /// What may be spent on a frame.
  [[nodiscard]] double WorkOf(const Scene& scene) const;
  void Classify(TileVisit& tile, std::int64_t most, ClassifiedTile& classified);
  void ProcessAgain(TileVisit& tile, std::size_t pass);
  /// After a pass.
  void Take(ClassifiedTile classified, std::size_t pass);
  [[nodiscard]] std::vector<ContourVerdict> VerdictsOf(const TileArea& area) const;
  void Count(const ContourCounters& counters);
  /// Verdicts of an area's pixels, row by row.
  void Keep(
    const TileArea& area, std::span<const std::uint8_t> verdicts, ContourCounters& counters);
  /// Which of an area's pixels are on a plateau, row by row.
  void KeepPlateaus(const TileArea& area, std::span<const std::uint8_t> onPlateau);
  [[nodiscard]] std::size_t PixelAt(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(Width) +
      static_cast<std::size_t>(x);
  }
  /// Of the square in column `x` and row `y`, its place in Marked.
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
  int Across = 0;                   ///< of squares of kTileSize pixels
  std::vector<std::uint8_t> Marked; ///< those with a pixel that is not Out
  Remainder Last{ *this, 1, nullptr };
  Remainder Again{ *this, 0, &Last };
  std::mutex CountersMutex;
  ContourCounters Counted;
  std::array<Pass, kPasses> Passes;
};
} // namespace pixelexact
