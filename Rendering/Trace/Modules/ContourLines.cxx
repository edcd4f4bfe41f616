// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ContourLines.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/Error.h"
#include "Trace/Modules/ContourCells.h"
#include "Trace/Modules/LineShare.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

namespace pixelexact
{
namespace
{
/// Distance from a pixel's centre to its corners, in pixels, rounded up.
constexpr double kHalfDiagonal = 0.7072;
/// Less than half a step of a colour channel.
constexpr double kUnseen = 1.0 / 512.0;

std::size_t NearestTo(double value, std::span<const double> values)
{
  const auto above = std::ranges::lower_bound(values, value);
  const auto at = static_cast<std::size_t>(above - values.begin());
  const bool below = at == values.size() || (at > 0 && value - values[at - 1] < *above - value);
  return below ? at - 1 : at;
}

TileArea Widened(const TileArea& area, int by, int width, int height)
{
  return { std::max(0, area.x0 - by), std::max(0, area.y0 - by), std::min(width, area.x1 + by),
    std::min(height, area.y1 + by) };
}

/// The pixels that lines in a tile may depend on.
struct NearPixels
{
  TileArea about;
  std::span<const std::uint8_t> near; ///< of its pixels, row by row

  [[nodiscard]] bool Has(int x, int y) const
  {
    return near[static_cast<std::size_t>(y - about.y0) * static_cast<std::size_t>(about.Width()) +
             static_cast<std::size_t>(x - about.x0)] != 0;
  }
};

/// Blends a colour over another; both have straight alpha.
void PutOver(const Rgba& color, double share, std::uint8_t* to)
{
  const double part = share * color[3] / 255.0;
  const double left = (1.0 - part) * to[3] / 255.0;
  const double alpha = part + left;
  for (std::size_t c = 0; c < 3 && alpha > 0.0; ++c)
  {
    to[c] = static_cast<std::uint8_t>(std::lround((part * color[c] + left * to[c]) / alpha));
  }
  to[3] = static_cast<std::uint8_t>(std::lround(255.0 * alpha));
}
} // namespace

std::vector<Rgba> InOrderOf(const std::vector<double>& values, const std::vector<Rgba>& colors)
{
  if (colors.size() != values.size())
  {
    return colors;
  }
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::ranges::stable_sort(order, {}, [&values](std::size_t i) { return values[i]; });
  std::vector<Rgba> sorted;
  sorted.reserve(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    if (k == 0 || values[order[k]] != values[order[k - 1]])
    {
      sorted.push_back(colors[order[k]]);
    }
  }
  return sorted;
}

std::vector<Rgba> ColorsOf(std::vector<double> values, const ColorMap& map)
{
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<Rgba> colors(values.size());
  if (!values.empty())
  {
    map(values, colors.front().data());
  }
  return colors;
}

/// Draws a tile.
class ContourLines::Tile
{
public:
  /// `corners`: of the pixels in `near`.
  Tile(const ContourLines& lines, TileVisit& visit, const NearPixels& near,
    const LatticePart& corners, ContourCells& cells)
    : Lines(lines)
    , Image(visit.GetFrame())
    , Area(visit.Area())
    , Near(near)
    , Corners(corners)
    , Cells(cells)
  {
    Cells.Begin(Corners, near.about, lines.Style.curved ? &visit.GetCamera() : nullptr);
  }

  /// Draws on pixels of 4 bytes each.
  void Draw(std::vector<std::uint8_t>& pixels)
  {
    Target = pixels.data();
    const auto& ranges = Cells.RangesAbout(Area, Lines.Far);
    std::size_t at = 0;
    for (int y = Area.y0; y < Area.y1; ++y)
    {
      for (int x = Area.x0; x < Area.x1; ++x, ++at)
      {
        if (Near.Has(x, y))
        {
          DrawPixel(x, y, ranges[at]);
        }
      }
    }
  }

private:
  /// The layer whose contours a pixel shows: that of its centre or else, with `atCorners`, of its
  /// first corner with a layer; kNoLayer: none.
  [[nodiscard]] std::uint8_t LayerAt(int x, int y, std::size_t pixel, bool atCorners) const
  {
    std::uint8_t layer = LayerOf(Image.centres, pixel);
    for (std::size_t k = 0; k < kCorners.size() && atCorners && layer == kNoLayer; ++k)
    {
      layer = LayerOf(Corners.samples, Corners.At(x + kCorners[k][0], y + kCorners[k][1]));
    }
    return layer;
  }

  /// The layer that a sample shows, if the sample is exact and the layer has iso-values; else
  /// kNoLayer.
  [[nodiscard]] std::uint8_t LayerOf(const SampleBuffers& samples, std::size_t i) const
  {
    if (samples.verdict[i] != static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      return kNoLayer;
    }
    const std::uint8_t layer = samples.layer.empty() ? std::uint8_t{ 0 } : samples.layer[i];
    return Lines.Certifier.Values()[layer].empty() ? kNoLayer : layer;
  }

  /// The iso-value nearest to the mean of the values at corners that show the layer.
  [[nodiscard]] std::size_t NearestAt(
    int x, int y, std::uint8_t layer, std::span<const double> values) const
  {
    double sum = 0.0;
    int count = 0;
    for (const auto& [dx, dy] : kCorners)
    {
      const std::size_t corner = Corners.At(x + dx, y + dy);
      const double value = Corners.samples.value[corner];
      if (Corners.samples.layer[corner] == layer && std::isfinite(value))
      {
        sum += value;
        ++count;
      }
    }
    return NearestTo(count > 0 ? sum / count : values.front(), values);
  }

  void DrawPixel(int x, int y, const std::array<double, 2>& range)
  {
    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(Image.width) +
      static_cast<std::size_t>(x);
    const auto verdict = static_cast<ContourVerdict>(Lines.Certifier.Verdicts()[pixel]);
    std::uint8_t* const color = Target + 4 * pixel;
    if (verdict == ContourVerdict::Undecided && Lines.Style.showUndecided)
    {
      PutOver(Lines.Style.undecided, 1.0, color);
      return;
    }
    const bool held = verdict == ContourVerdict::In;
    if (!held && !(range[0] <= range[1]))
    {
      return;
    }
    const std::uint8_t layer = LayerAt(x, y, pixel, held);
    if (layer == kNoLayer)
    {
      return;
    }
    const std::span<const double> values = Lines.Certifier.Values()[layer];
    // On a plateau, lines would follow rounding errors.
    const bool isTold = Cells.LayerOf(x, y) == layer && !Lines.Certifier.IsOnPlateau(pixel);
    const double drawn = isTold ? DrawLines(x, y, layer, range, color) : 0.0;
    if (held && drawn < kMinShare)
    {
      const double least = drawn > 0.0 ? kMinShare : std::min(1.0, Lines.Style.width);
      PutOver(Lines.ColorOf(layer, NearestAt(x, y, layer, values)), least, color);
    }
  }

  /// Draws lines on a whole pixel. Returns the covered part of the pixel.
  double DrawLines(
    int x, int y, std::uint8_t layer, const std::array<double, 2>& range, std::uint8_t* color)
  {
    const std::span<const double> values = Lines.Certifier.Values()[layer];
    const double half = 0.5 * Lines.Style.width;
    double open = 1.0;
    for (auto value = std::ranges::lower_bound(values, range[0]);
         value != values.end() && *value <= range[1] && open > kUnseen; ++value)
    {
      const auto foot = Cells.Find(glm::dvec2(x + 0.5, y + 0.5), *value, Lines.Far);
      if (foot)
      {
        const double share = ShareBehind(foot->towards, foot->distance + half) -
          ShareBehind(foot->towards, foot->distance - half);
        PutOver(
          Lines.ColorOf(layer, static_cast<std::size_t>(value - values.begin())), share, color);
        open *= 1.0 - share;
      }
    }
    return 1.0 - open;
  }

  static constexpr std::array<std::array<int, 2>, 4> kCorners{ { { 0, 0 }, { 1, 0 }, { 0, 1 },
    { 1, 1 } } };

  const ContourLines& Lines;
  const Frame& Image;
  TileArea Area;
  NearPixels Near;
  LatticePart Corners;
  ContourCells& Cells;
  std::uint8_t* Target = nullptr;
};

ContourLines::ContourLines(const ContourCertifier& certifier, const ContourStyle& style,
  std::vector<std::vector<Rgba>> colors)
  : Certifier(certifier)
  , Style(style)
  , Colors(std::move(colors))
  , Far(0)
{
  if (!(style.width >= ContourStyle::kNarrowest && style.width <= ContourStyle::kWidest))
  {
    std::ostringstream text;
    text << "a line width of " << style.width << " pixels: contours may be "
         << ContourStyle::kNarrowest << " to " << ContourStyle::kWidest << " pixels wide";
    throw Error(text.str());
  }
  Far = static_cast<int>(std::floor(0.5 + 0.5 * style.width + kHalfDiagonal));
  bool match = Colors.size() == certifier.Values().size();
  for (std::size_t k = 0; match && k < Colors.size(); ++k)
  {
    const std::size_t values = certifier.Values()[k].size();
    match = values == 0 || Colors[k].size() == 1 || Colors[k].size() == values;
  }
  if (!match)
  {
    throw Error("contours: give each layer one colour for each of its values, or one for all.");
  }
}

SampleNeeds ContourLines::Needs() const
{
  constexpr Buffer kSheets = Buffer::Position | Buffer::Normal;
  return { .centres = Buffer::Verdict | (Colors.size() > 1 ? Buffer::Layer : Buffer::None),
    .corners =
      Buffer::Value | Buffer::Verdict | Buffer::Layer | (Style.curved ? kSheets : Buffer::None),
    // A line in a pixel depends on the verdicts around it.
    .wholeFrame = true };
}

void ContourLines::Begin(int width, int height)
{
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Under.assign(Style.keepBeneath ? 4 * pixels : 0, 0);
}

const Rgba& ContourLines::ColorOf(std::size_t layer, std::size_t value) const
{
  const std::vector<Rgba>& colors = Colors[layer];
  return colors.size() == 1 ? colors.front() : colors[value];
}

std::vector<std::uint8_t> ContourLines::PixelsNearLines(
  const TileArea& about, int width, int height) const
{
  const auto across = static_cast<std::size_t>(about.Width());
  std::vector<std::uint8_t> found(across * static_cast<std::size_t>(about.Height()), 0);
  const TileArea near = Widened(about, Far, width, height);
  const std::vector<std::uint8_t>& verdicts = Certifier.Verdicts();
  for (int y = near.y0; y < near.y1; ++y)
  {
    const std::uint8_t* const row =
      &verdicts[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    for (int x = near.x0; x < near.x1; ++x)
    {
      if (row[x] == static_cast<std::uint8_t>(ContourVerdict::Out))
      {
        continue;
      }
      const int from = std::max(x - Far, about.x0);
      const int to = std::min(x + Far + 1, about.x1);
      for (int j = std::max(y - Far, about.y0); j < std::min(y + Far + 1, about.y1) && from < to;
           ++j)
      {
        std::fill_n(&found[static_cast<std::size_t>(j - about.y0) * across +
                      static_cast<std::size_t>(from - about.x0)],
          to - from, 1);
      }
    }
  }
  return found;
}

void ContourLines::Process(TileVisit& tile)
{
  Frame& frame = tile.GetFrame();
  if (frame.color.empty())
  {
    return;
  }
  const TileArea& area = tile.Area();
  for (int y = area.y0; y < area.y1 && Style.keepBeneath; ++y)
  {
    const std::size_t first = 4 *
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
        static_cast<std::size_t>(area.x0));
    std::copy_n(&frame.color[first], 4 * area.Width(), &Under[first]);
  }
  const TileArea about = Widened(area, Far, frame.width, frame.height);
  if (!Certifier.HasLinesNear(Widened(area, Far, frame.width, frame.height)))
  {
    return;
  }
  const std::vector<std::uint8_t> near = PixelsNearLines(about, frame.width, frame.height);
  const std::vector<std::uint8_t> wanted = CornersOfPixels(near, about.Width());
  if (std::ranges::find(wanted, 1) == wanted.end())
  {
    return;
  }
  SampleBuffers traced;
  const LatticePart corners = tile.CornersOf(
    { about.x0, about.y0, about.x1 + 1, about.y1 + 1 }, wanted, Needs().corners, traced);
  const CheckedOut<ContourCells> cells;
  Tile drawn(*this, tile, { about, near }, corners, *cells);
  drawn.Draw(frame.color);
  if (Style.onSheet)
  {
    drawn.Draw(frame.centres.color);
  }
}
} // namespace pixelexact
