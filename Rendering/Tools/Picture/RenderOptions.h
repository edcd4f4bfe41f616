// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/FontOptions.h"
#include "Picture/AnimationOptions.h"
#include "Picture/ContourFile.h"
#include "Picture/Figure.h"
#include "Picture/MeshOutline.h"
#include "Scene/BufferOptions.h"
#include "Scene/ContourOptions.h"
#include "Scene/DebugOptions.h"
#include "Scene/QualitySettings.h"
#include "Scene/Shot.h"

#include <optional>
#include <string>

namespace pixelexact
{
/// What render was asked for.
struct RenderOptions
{
  ShotOptions shot;
  DebugOptions debug;
  BufferOptions buffers;
  ContourOptions contours;
  ContourFileOptions lines;
  FigureOptions figure;
  FontOptions font;
  MeshOutline outline;
  AnimationOptions animation;
  QualityOptions quality;
  std::optional<double> dpi;
  int jpegQuality = 0;
  std::string output;

  void AddTo(CLI::App& command);

  /// What the command line alone can tell to be wrong; size and letters get their pixels.
  /// `picture`: the file that is written. Throws UsageError, Error for a file that cannot be
  /// written.
  void Check(const std::string& picture);
  /// The shot of the picture, which a figure is around: after Check.
  [[nodiscard]] ShotOptions OfPicture() const;

  /// Pixels in an inch; none: the picture has no lengths.
  [[nodiscard]] std::optional<double> Dpi() const;
};
} // namespace pixelexact
