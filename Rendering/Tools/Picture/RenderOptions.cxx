// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/RenderOptions.h"

#include "Base/Command.h"
#include "Base/Output.h"
#include "Drawing/ImageFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace pixelexact
{
namespace
{
constexpr int kSamplesOfFigures = 4;

/// Refuses a suffix that does not match the file's format.
void CheckSuffix(const char* option, const std::string& file, const char* suffix)
{
  if (!file.empty() && !IsStandardStream(file) && std::filesystem::path(file).extension() != suffix)
  {
    throw UsageError(
      std::string(option) + ": '" + file + "' is written as " + suffix + "; name it so");
  }
}
} // namespace

void RenderOptions::AddTo(CLI::App& command)
{
  shot.input.mayBeAll = true;
  shot.AddTo(command);
  Bind(command, "--clip", shot.clip);
  if (command.get_name() == "render")
  {
    shot.volume.AddTo(command);
  }
  contours.AddTo(command);
  debug.AddTo(command);
  shot.colors.AddUndecidedTo(command);
  Bind(command, "--output", output);
  buffers.AddTo(command);
  lines.AddTo(command);
  figure.AddTo(command);
  marks.AddTo(command);
  arrows.AddTo(command);
  dots.AddTo(command);
  texture.AddTo(command);
  font.AddTo(command);
  outline.AddTo(command);
  animation.AddTo(command);
  quality.AddTo(command, shot);
  Bind(command, "--dpi", dpi);
  Bind(command, "--jpeg-quality", jpegQuality);
}

std::optional<double> RenderOptions::Dpi() const
{
  return dpi ? dpi : shot.size.inches ? std::optional(kDefaultDpi) : std::nullopt;
}

void RenderOptions::Check(const std::string& picture)
{
  const PictureFormat format = FormatOf("--output", picture);
  CheckSuffix("--buffers", buffers.File(), ".vti");
  CheckSuffix("--contours-output", lines.file, ".vtp");
  CheckOutput("--output", picture, shot.input.files);
  CheckOutput("--buffers", buffers.File(), shot.input.files);
  CheckOutput("--contours-output", lines.file, shot.input.files);
  if (!lines.file.empty() && !contours.AreGiven())
  {
    throw UsageError("--contours-output: there are no contours to write; give --contours");
  }
  if (!lines.file.empty() && !shot.clip.empty())
  {
    throw UsageError("--contours-output: lines are those of whole surfaces; leave out --clip");
  }
  if (shot.colors.BackgroundColor()[3] == 0 && !HasAlpha(format))
  {
    throw UsageError(
      "--background none: a JPEG is not transparent; write .png, .tif, .svg or .pdf");
  }
  if (format != PictureFormat::Jpeg && IsGiven(*shot.command, "--jpeg-quality"))
  {
    throw UsageError("--jpeg-quality has no effect on '" + picture + "'; name a .jpg");
  }
  animation.Check(shot.input);
  shot.volume.Check(shot.HasVolumeAlone());
  for (const char* option : { "--arrows", "--lic", "--dots" })
  {
    if (shot.HasVolumeAlone() && IsGiven(*shot.command, option))
    {
      throw UsageError(std::string(option) +
        " is drawn on surfaces, and there is a volume alone; give a surface, such as --plane z");
    }
  }
  if (shot.volume.IsAsked() && animation.IsAsked(shot.input))
  {
    throw UsageError("--volume: is not available in animations; choose one --time-step");
  }
  quality.Check(*shot.command);
  if (!animation.IsAsked(shot.input))
  {
    shot.CheckRangeOfOne();
  }
  if (figure.IsAsked() && !IsGiven(*shot.command, "--size"))
  {
    shot.size.height = 0; // which the layout determines
  }
  shot.size = AtDpi(shot.size, Dpi().value_or(kDefaultDpi));
  const auto inPrint = shot.size.inches ? Dpi() : std::nullopt;
  if (shot.edgeWidth)
  {
    shot.edgeWidth->Resolve(inPrint);
  }
  contours.ResolveLengths(inPrint);
  outline.ResolveLengths(inPrint);
  arrows.ResolveLengths(inPrint);
  buffers.Check();
  font.Check();
  const std::vector<LayerSettings> layers = shot.MakeLayers();
  debug.Check(shot.samples, layers);
  if (Has(buffers.Needs(true), Buffer::Jump) && !Has(debug.Needs(), Buffer::Jump))
  {
    throw UsageError("--arrays: 'Jump' needs --show jumps");
  }
  if (debug.IsInPlace() && texture.IsAsked())
  {
    throw UsageError("--lic would change the colours of a legend; leave out --owners and --show");
  }
  contours.Check(layers);
  if (figure.IsAsked())
  {
    figure.Check(shot.size);
    CheckBars(layers);
    // Steps of pixels are not what a reader wants; where colours are a legend's they stay pure.
    if (!IsGiven(*shot.command, "--samples") && !debug.NeedsPureColors())
    {
      shot.samples = kSamplesOfFigures;
    }
  }
}

void RenderOptions::CheckBars(const std::vector<LayerSettings>& layers) const
{
  const bool isSolid = std::ranges::all_of(layers,
    [this](const LayerSettings& layer)
    { return layer.color || (shot.colors.Solid() && !layer.colormap && !layer.range); });
  const bool hasBar =
    debug.IsInPlace() ? debug.ShowsJumps() : !isSolid && (!contours.Only() || contours.ByMap());
  for (const char* option : { "--bar-title", "--unit", "--bar-ticks" })
  {
    if (!hasBar && IsGiven(*shot.command, option))
    {
      throw UsageError(
        std::string(option) + " has no effect: the figure has no colour bar; leave it out");
    }
  }
}

ShotOptions RenderOptions::OfPicture() const
{
  ShotOptions asked = shot;
  if (figure.IsAsked())
  {
    asked.layout = [this](const Shot& of)
    {
      FigureLayout layout = figure.LayOut(shot.size, of, animation.Turns());
      layout.isOfSeries = animation.IsAsked(shot.input);
      figure.NoteEffects(layout, of);
      return layout;
    };
  }
  for (const std::string& field : { arrows.Field(), texture.Field() })
  {
    if (!field.empty())
    {
      asked.otherFields.push_back(field);
    }
  }
  if (outline.IsAsked())
  {
    asked.alsoSeen = [&outline = outline](const Shot& of) { return outline.Points(of); };
  }
  return asked;
}
} // namespace pixelexact
