// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/Pipeline.h"
#include "Trace/TraceTile.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// How contours look.
struct ContourStyle
{
  static constexpr double kNarrowest = 0.1;
  static constexpr double kWidest = 32.0;

  double width = 1.5; ///< in pixels, kNarrowest to kWidest
  /// Undecided pixels get a colour of their own, teal as in the paper; else they show what they
  /// have of the lines between the samples.
  bool showUndecided = false;
  Rgba undecided{ 0, 128, 128, 255 };
  /// Whether sheets of a surface may hide each other: of planes they do not, and two buffers less
  /// are made.
  bool curved = true;
  bool keepBeneath = false; ///< the image without the lines, for whoever writes on it
  /// The nearest sheet gets the lines, too: for somebody who draws sheets one by one.
  bool onSheet = false;

  bool operator==(const ContourStyle&) const = default;
};

/// Colours in the ascending order of the values that they are given for, of equal ones the first;
/// one for all stays as it is.
[[nodiscard]] std::vector<Rgba> InOrderOf(
  const std::vector<double>& values, const std::vector<Rgba>& colors);
/// The map's, in the ascending order of the values, each once.
[[nodiscard]] std::vector<Rgba> ColorsOf(std::vector<double> values, const ColorMap& map);

/// Draws the lines on which the field has the iso-values of a ContourCertifier, of a width in
/// pixels, each pixel by the part of it that the line covers.
///
/// Where the line goes follows from the exact values at the corners (ContourCells): from a pixel's
/// centre the field is followed up or down to the value, through pixels whose corners all show one
/// sheet of one layer. So there is no line from one sheet or layer to another, none beyond the
/// mesh, and none near an extremum that does not reach the value. A pixel whose verdict is In
/// always shows some of the line, as much as a straight line through its centre would cover where
/// the corners do not tell where it goes: at the ends of surfaces and of the mesh, where the field
/// is constant up to rounding, or where a contour comes and goes by the same side. A pixel that is
/// Out has a part of the width of its neighbours' lines, or nothing, and so has an Undecided one
/// unless it has a colour of its own; without finite values there are none.
///
/// Lines are opaque, over translucent layers, too, of which the nearest sheet counts; they are
/// drawn over the image, also where that is transparent. The frame's image alone changes, unless
/// ContourStyle::onSheet is set; without colours nothing is drawn. Of contours beyond the image's
/// edge nothing is known. Belongs after the certifier and whatever else draws.
class ContourLines final : public FrameModule
{
public:
  /// Of a pixel that is not Out, the line covers no less.
  static constexpr double kMinShare = 0.05;

  /// `colors`: for each of the certifier's layers one for each of its values, in ascending order,
  /// or one for all. Throws Error for a width out of range, and where colours are missing. The
  /// certifier must outlive this and precede it in the pipeline.
  ContourLines(const ContourCertifier& certifier, const ContourStyle& style,
    std::vector<std::vector<Rgba>> colors);

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;

  /// Whether undecided pixels have lines, and not a colour of their own.
  [[nodiscard]] bool DrawsUndecided() const { return !Style.showUndecided; }
  [[nodiscard]] const Rgba& ColorOf(std::size_t layer, std::size_t value) const;
  /// With ContourStyle::keepBeneath.
  [[nodiscard]] const std::vector<std::uint8_t>& Beneath() const { return Under; }

private:
  class Tile;
  /// For each of these pixels, row by row, whether it may show some of a line, or lie between a
  /// line and one that does: no farther from a pixel that is not Out.
  [[nodiscard]] std::vector<std::uint8_t> PixelsNearLines(
    const TileArea& about, int width, int height) const;

  const ContourCertifier& Certifier;
  ContourStyle Style;
  std::vector<std::vector<Rgba>> Colors;
  int Far; ///< of the contours that touch a pixel, each way, in pixels
  std::vector<std::uint8_t> Under;
};
} // namespace pixelexact
