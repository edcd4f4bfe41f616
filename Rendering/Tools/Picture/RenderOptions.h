// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/FontOptions.h"
#include "Picture/AnimationOptions.h"
#include "Picture/ContourFile.h"
#include "Picture/ExtremeMarks.h"
#include "Picture/FieldArrows.h"
#include "Picture/FieldDots.h"
#include "Picture/FieldTexture.h"
#include "Picture/Figure.h"
#include "Picture/MeshOutline.h"
#include "Scene/BufferOptions.h"
#include "Scene/ContourOptions.h"
#include "Scene/DebugOptions.h"
#include "Scene/QualitySettings.h"
#include "Scene/Shot.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The options of render.
struct RenderOptions
{
  ShotOptions shot;
  DebugOptions debug;
  BufferOptions buffers;
  ContourOptions contours;
  ContourFileOptions lines;
  FigureOptions figure;
  ExtremeMarks marks;
  FieldArrows arrows;
  FieldDots dots;
  FieldTexture texture;
  FontOptions font;
  MeshOutline outline;
  AnimationOptions animation;
  QualityOptions quality;
  std::optional<double> dpi;
  int jpegQuality = 0;
  std::string output;

  void AddTo(CLI::App& command);

  /// Checks what depends on the command line only, and computes size and letters in pixels.
  /// `picture`: the output file. Throws UsageError, and Error for a file that cannot be written.
  void Check(const std::string& picture);
  /// The options of the picture inside the figure. Must be called after Check.
  [[nodiscard]] ShotOptions OfPicture() const;

  /// Throws UsageError for options of colour bars in a figure without one.
  void CheckBars(const std::vector<LayerSettings>& layers) const;
  /// Pixels in an inch; none: the picture has no physical size.
  [[nodiscard]] std::optional<double> Dpi() const;
};
} // namespace pixelexact
