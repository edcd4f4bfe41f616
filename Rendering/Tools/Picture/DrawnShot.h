// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Image.h"
#include "Drawing/ImageFile.h"
#include "Drawing/VectorLines.h"
#include "Picture/ContourPaths.h"
#include "Picture/ExtremeMarks.h"
#include "Picture/RenderReport.h"
#include "Scene/DebugOptions.h"
#include "Scene/ShotAppearance.h"

#include "Trace/Tracer.h"

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
struct FigureContent;
struct RenderOptions;
struct Shot;

/// Casts the rays that a picture needs.
Frame TraceShot(const RenderOptions& options, const Shot& shot, const Progress& progress);

/// Whether to go on with a picture. May be called from several threads at once. Empty: always.
using GoesOn = std::function<bool()>;

/// A picture was given up because its GoesOn returned false.
class Interrupted final : public std::exception
{
public:
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

/// A shot with colours, contours, labels, outlines and its report's data.
class DrawnShot
{
public:
  /// `traced`: the frame of TraceShot. `paths`: draws contours, element edges and outlines as paths
  /// instead of pixels where possible. Throws Error as ShotAppearance, and Interrupted: `goesOn` is
  /// called for each tile of contours, anti-aliasing, element edges and outlines. The options and
  /// the shot must outlive it.
  DrawnShot(const RenderOptions& options, const Shot& shot, Frame traced, bool paths = false,
    const GoesOn& goesOn = {});
  DrawnShot(const DrawnShot&) = delete;
  DrawnShot& operator=(const DrawnShot&) = delete;

  [[nodiscard]] const Frame& GetFrame() const { return Pixels; }
  [[nodiscard]] const ShotAppearance& GetAppearance() const { return *Colors; }
  [[nodiscard]] const DebugOptions& Debug() const { return Told; }
  /// Null where there are no contours.
  [[nodiscard]] const ContourCertifier* Contours() const { return Colors->GetPainter().Contours(); }
  [[nodiscard]] const Found& WhatIsFound() const { return found_; }

  /// The size of Picture.
  [[nodiscard]] ImageSize Size() const;
  /// The picture alone, or with a figure around it.
  [[nodiscard]] Image Picture() const;
  /// The bytes of the same as a PDF or SVG.
  [[nodiscard]] std::string Vectors(
    PictureFormat format, const PictureTexts& texts, const std::string& file) const;
  /// Parts that were requested as paths but are drawn in pixels: "contours", "element edges".
  [[nodiscard]] const std::vector<std::string>& InPixels() const { return Staying; }
  /// "12 exact, 3 nothing, 0 unknown".
  [[nodiscard]] std::string PixelsText() const;

private:
  void ReportUnchanged(const char* what, bool arePaths);
  void AddLines(std::vector<std::vector<CanvasPoint>> paths, double width, const Rgba& color);
  void AddContours(const std::vector<ContourPath>& contours);
  /// Draws the picture with its paths and, where there is a layout, the figure.
  void DrawOn(Canvas& canvas) const;
  void DrawFigure(Canvas& canvas) const;
  /// Adds the colours of visible walls at jumps, and of edges by kind.
  void AddSolidLayers(FigureContent& content) const;
  /// Adds the colour of values that have no logarithm, where there are any.
  void AddNoLogarithm(FigureContent& content) const;

  const RenderOptions& Options;
  const Shot& Of;
  Frame Pixels;
  DebugOptions Told;
  std::optional<ShotAppearance> Colors;
  std::optional<int> Labels;             ///< number of labels drawn, where requested
  std::vector<SurfaceExtremes> Extremes; ///< of marks
  VectorLines Over;
  std::vector<std::string> Staying;
  Found found_;
};
} // namespace pixelexact
