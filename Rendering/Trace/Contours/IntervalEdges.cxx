// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/IntervalEdges.h"

#include "Core/Base/Error.h"
#include "Core/Questions/ValueSet.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <limits>
#include <string>

namespace pixelexact
{
namespace
{
/// Largest count of samples that are traced together.
constexpr std::size_t kBatch = 4096;

/// State of a pixel, from the samples and parts on its edge.
struct SeenPixel
{
  bool in = false;
  bool shown = false;                   ///< the mesh
  PartVerdict edges = PartVerdict::Out; ///< the least certain of their parts
};

class TileClassifier
{
public:
  TileClassifier(TileVisit& tile, std::span<const std::vector<double>> values)
    : Tile(tile)
    , Values(values)
    , Lattice(tile.Area())
    , Parts(tile.GetScene(), tile.GetCamera(), values)
    , Pixels(static_cast<std::size_t>(Lattice.Pixels()))
    , Seen(Pixels.size() * values.size(),
        { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
  }

  void Run(int subdivisions, IntervalCounters& counters)
  {
    LookAtCorners();
    for (int edge = 0; edge < Lattice.Edges(); ++edge)
    {
      const auto corners = Lattice.CornersOf(edge);
      Open.push_back({ edge, corners[0], corners[1] });
    }
    for (int level = 0; level <= subdivisions; ++level)
    {
      if (level > 0)
      {
        Subdivide(counters);
      }
      ClassifyOpen(counters);
      CountLevel(level, counters);
    }
    for (const SeenPixel& pixel : Pixels)
    {
      const bool out = !pixel.in && pixel.edges == PartVerdict::Out;
      counters.in += pixel.in ? 1 : 0;
      counters.out += out && pixel.shown ? 1 : 0;
      counters.undecided += pixel.in || out ? 0 : 1;
      counters.unproven += !pixel.in && pixel.edges == PartVerdict::Unproven ? 1 : 0;
    }
  }

  void Write(std::span<std::uint8_t> verdicts) const
  {
    std::ranges::transform(Pixels, verdicts.begin(),
      [](const SeenPixel& pixel)
      {
        const ContourVerdict verdict = pixel.in ? ContourVerdict::In
          : pixel.edges == PartVerdict::Out     ? ContourVerdict::Out
                                                : ContourVerdict::Undecided;
        return static_cast<std::uint8_t>(verdict);
      });
  }

private:
  void LookAtCorners()
  {
    const TileArea& area = Tile.Area();
    const SampleBuffers& corners = Tile.Corners();
    for (std::size_t i = 0; i < corners.Size(); ++i)
    {
      const auto at = static_cast<int>(i);
      const int x = area.x0 + at % corners.width;
      const int y = area.y0 + at / corners.width;
      Samples.push_back(SampleFrom(corners, i, { static_cast<double>(x), static_cast<double>(y) }));
    }
    for (int pixel = 0; pixel < Lattice.Pixels(); ++pixel)
    {
      for (const int corner : Lattice.CornersOfPixel(pixel))
      {
        Show(pixel, Samples[static_cast<std::size_t>(corner)]);
      }
    }
  }

  /// Adds a sample on a pixel's edge.
  void Show(int pixel, const EdgeSample& sample)
  {
    SeenPixel& seen = Pixels[static_cast<std::size_t>(pixel)];
    seen.shown = seen.shown || sample.verdict != PixelVerdict::Nothing;
    if (sample.verdict != PixelVerdict::Exact || sample.layer >= Values.size())
    {
      return;
    }
    Interval& range =
      Seen[static_cast<std::size_t>(pixel) * Values.size() + std::size_t{ sample.layer }];
    // A NaN changes nothing.
    range.lower = std::min(range.lower, sample.value);
    range.upper = std::max(range.upper, sample.value);
    seen.in = seen.in || ValueSet{ Values[sample.layer] }.Meets(range.lower, range.upper);
  }

  [[nodiscard]] bool IsAsked(int edge) const
  {
    return std::ranges::any_of(Lattice.PixelsOf(edge),
      [this](int pixel) { return pixel >= 0 && !Pixels[static_cast<std::size_t>(pixel)].in; });
  }

  /// Classifies the open parts by intervals. Parts that may hold an iso-value stay open.
  void ClassifyOpen(IntervalCounters& counters)
  {
    std::erase_if(Open, [this](const EdgePart& part) { return !IsAsked(part.edge); });
    counters.parts += static_cast<std::int64_t>(Open.size());
    std::vector<PartVerdict> verdicts;
    Parts.Classify(Samples, Open, verdicts);
    for (SeenPixel& pixel : Pixels)
    {
      pixel.edges = PartVerdict::Out;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < Open.size(); ++i)
    {
      if (verdicts[i] != PartVerdict::Out)
      {
        for (const int pixel : Lattice.PixelsOf(Open[i].edge))
        {
          if (pixel >= 0)
          {
            PartVerdict& edges = Pixels[static_cast<std::size_t>(pixel)].edges;
            edges = std::max(edges, verdicts[i]);
          }
        }
        Open[kept++] = Open[i];
      }
    }
    Open.resize(kept);
  }

  /// Subdivides the open parts at samples in their middles.
  void Subdivide(IntervalCounters& counters)
  {
    const auto first = Samples.size();
    std::vector<ImagePosition> middles;
    for (const EdgePart& part : Open)
    {
      const ImagePosition& from = Samples[static_cast<std::size_t>(part.from)].at;
      const ImagePosition& to = Samples[static_cast<std::size_t>(part.to)].at;
      middles.push_back({ 0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]) });
    }
    for (std::size_t begin = 0; begin < middles.size(); begin += kBatch)
    {
      const auto some = std::span(middles).subspan(begin, std::min(kBatch, middles.size() - begin));
      const SampleBuffers traced = Tile.Trace(some, kEdgeSampleBuffers);
      for (std::size_t i = 0; i < some.size(); ++i)
      {
        Samples.push_back(SampleFrom(traced, i, some[i]));
      }
    }
    counters.samples += static_cast<std::int64_t>(middles.size());
    std::vector<EdgePart> children;
    for (std::size_t i = 0; i < Open.size(); ++i)
    {
      const EdgePart& part = Open[i];
      const auto middle = static_cast<int>(first + i);
      for (const int pixel : Lattice.PixelsOf(part.edge))
      {
        if (pixel >= 0)
        {
          Show(pixel, Samples[first + i]);
        }
      }
      children.push_back({ part.edge, part.from, middle });
      children.push_back({ part.edge, middle, part.to });
    }
    Open = std::move(children);
  }

  void CountLevel(int level, IntervalCounters& counters)
  {
    const auto at = static_cast<std::size_t>(level);
    for (const SeenPixel& pixel : Pixels)
    {
      counters.undecidedAfter[at] += !pixel.in && pixel.edges != PartVerdict::Out ? 1 : 0;
      counters.unprovenAfter[at] += !pixel.in && pixel.edges == PartVerdict::Unproven ? 1 : 0;
    }
    const auto in = std::ranges::count_if(Pixels, &SeenPixel::in);
    counters.inAt[at] += in - CountedIn;
    CountedIn = in;
  }

  TileVisit& Tile;
  std::span<const std::vector<double>> Values;
  IntervalLattice Lattice;
  IntervalParts Parts;
  std::vector<SeenPixel> Pixels;
  std::vector<Interval> Seen;      ///< by pixel and layer: of the values at samples
  std::vector<EdgeSample> Samples; ///< the corners first
  std::vector<EdgePart> Open;
  std::int64_t CountedIn = 0; ///< at the levels before
};
} // namespace

void IntervalCounters::Add(const IntervalCounters& other)
{
  in += other.in;
  out += other.out;
  undecided += other.undecided;
  unproven += other.unproven;
  for (std::size_t level = 0; level < inAt.size(); ++level)
  {
    inAt[level] += other.inAt[level];
    undecidedAfter[level] += other.undecidedAfter[level];
    unprovenAfter[level] += other.unprovenAfter[level];
  }
  samples += other.samples;
  parts += other.parts;
}

void ClassifyByIntervals(TileVisit& tile, std::span<const std::vector<double>> values,
  int subdivisions, std::span<std::uint8_t> verdicts, IntervalCounters& counters)
{
  if (!(subdivisions >= 0 && subdivisions <= kMaxSubdivisions))
  {
    throw Error("contours by intervals: " + std::to_string(subdivisions) +
      " subdivisions; give 0 to " + std::to_string(kMaxSubdivisions) + ".");
  }
  const auto layers = tile.GetScene().layers.size();
  if (values.size() > layers)
  {
    throw Error("contours by intervals: iso-values of " + std::to_string(values.size()) +
      " layers, but the scene has " + std::to_string(layers) + "; give a list for each layer.");
  }
  for (const Layer& layer : tile.GetScene().layers)
  {
    if (layer.field != nullptr)
    {
      RequirePolynomials(*layer.field, "contours by intervals");
    }
  }
  TileClassifier classifier(tile, values);
  classifier.Run(subdivisions, counters);
  classifier.Write(verdicts);
}
} // namespace pixelexact
