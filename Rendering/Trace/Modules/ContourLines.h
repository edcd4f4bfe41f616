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
/// Appearance of contours.
struct ContourStyle
{
  static constexpr double kNarrowest = 0.1;
  static constexpr double kWidest = 32.0;

  double width = 1.5; ///< in pixels, kNarrowest to kWidest
  /// Undecided pixels get a colour of their own, teal as in the paper; otherwise they show the
  /// lines that follow from the corners' values.
  bool showUndecided = false;
  Rgba undecided{ 0, 128, 128, 255 };
  /// Sheets of a surface may hide each other. Planes have one sheet and need two buffers less.
  bool curved = true;
  bool keepBeneath = false; ///< keeps the image without the lines, for labels
  /// Draws the lines also on the nearest sheet, for callers that draw sheets one by one.
  bool onSheet = false;

  bool operator==(const ContourStyle&) const = default;
};

/// Sorts colours by the values that they are given for, in ascending order. Of equal values the
/// first colour counts. A single colour stays single.
[[nodiscard]] std::vector<Rgba> InOrderOf(
  const std::vector<double>& values, const std::vector<Rgba>& colors);
/// The map's colours of the values, in ascending order of the values, without duplicates.
[[nodiscard]] std::vector<Rgba> ColorsOf(std::vector<double> values, const ColorMap& map);

/// Draws the lines on which the field has the iso-values of a ContourCertifier. Lines have a width
/// in pixels; a pixel is painted in proportion to the area that the line covers.
///
/// A line's place follows from the exact values at the corners (ContourCells). From a pixel's
/// centre, the field is followed up or down to the value, through pixels whose corners all show one
/// sheet of one layer. So no line leads from one sheet or layer to another or leaves the mesh, and
/// none surrounds an extremum that does not reach the value. A pixel whose verdict is In always
/// shows a part of a line. It shows the part of a straight line through its centre if the corners
/// do not determine the line: at the ends of surfaces and of the mesh, where the field is constant
/// up to rounding, or where a contour enters and leaves by one side. A pixel that is Out shows only
/// the width of neighbours' lines. So does an Undecided one, unless it has a colour of its own.
/// Without finite values there are no lines.
///
/// Lines are opaque, also over translucent layers, of which the nearest sheet counts. They are
/// drawn over the image, also where it is transparent. Changes only the frame's image, unless
/// ContourStyle::onSheet is set; without colours nothing is drawn. Contours outside the image are
/// unknown and add no width inside. Belongs after the certifier and after other modules that draw.
class ContourLines final : public FrameModule
{
public:
  /// The least share of an In pixel that its line covers.
  static constexpr double kMinShare = 0.05;

  /// `colors`: for each of the certifier's layers, one per value in ascending order, or one for
  /// all. Throws Error for a width out of range and for missing colours. The certifier must outlive
  /// this object and precede it in the pipeline.
  ContourLines(const ContourCertifier& certifier, const ContourStyle& style,
    std::vector<std::vector<Rgba>> colors);

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;

  /// Undecided pixels show lines, not a colour of their own.
  [[nodiscard]] bool DrawsUndecided() const { return !Style.showUndecided; }
  [[nodiscard]] const Rgba& ColorOf(std::size_t layer, std::size_t value) const;
  /// The image without the lines; only with ContourStyle::keepBeneath.
  [[nodiscard]] const std::vector<std::uint8_t>& Beneath() const { return Under; }

private:
  class Tile;
  /// For each of these pixels, row by row: 1 if it may show a part of a line, or lies between a
  /// line and such a pixel, that is, within Far of a pixel that is not Out.
  [[nodiscard]] std::vector<std::uint8_t> PixelsNearLines(
    const TileArea& about, int width, int height) const;

  const ContourCertifier& Certifier;
  ContourStyle Style;
  std::vector<std::vector<Rgba>> Colors;
  int Far; ///< largest distance of contours that touch a pixel, in each direction, in pixels
  std::vector<std::uint8_t> Under;
};
} // namespace pixelexact
