// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/PictureFile.h"

#include "Base/Report.h"
#include "Drawing/ImageFile.h"
#include "Drawing/Picture.h"
#include "Picture/DrawnShot.h"
#include "Picture/RenderOptions.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace pixelexact
{
std::string EncodePicture(const RenderOptions& options, const DrawnShot& drawn,
  const std::string& file, const RepeatedCommand& command, Stopwatch& watch,
  const PictureTexts& told)
{
  PictureFacts facts{ options.Dpi(), told, options.jpegQuality };
  // Whoever gets the file is to know, whatever else it tells.
  if (const auto given = drawn.WhatIsFound().knobs.Texts(); !given.empty())
  {
    facts.texts.emplace_back("Given up", fmt::format("{}", fmt::join(given, "\n")));
  }
  if (options.figure.IsAsked() || !told.empty())
  {
    const bool hasSource =
      std::ranges::any_of(told, [](const auto& text) { return text.first == kSourceText; });
    if (!hasSource)
    {
      facts.texts.emplace_back(kSourceText, DescribeFiles(options.shot.input.files));
    }
    facts.texts.emplace_back("Command", command.Text());
    facts.texts.emplace_back("Pixels", drawn.PixelsText());
    watch.Stage("provenance");
  }
  const PictureFormat format = FormatOf("--output", file);
  std::string bytes;
  if (IsVector(format))
  {
    bytes = drawn.Vectors(format, facts.texts, file);
  }
  else
  {
    const Image picture = drawn.Picture();
    watch.Stage("figure");
    bytes = EncodeImage(picture, format, facts, file);
  }
  watch.Stage("encode");
  return bytes;
}

std::string EncodeBuffersOf(
  const RenderOptions& options, const Shot& shot, const DrawnShot& drawn, const std::string& file)
{
  const ContourCertifier* contours = drawn.Contours();
  return EncodeBuffers(file, options.buffers.Arrays(), drawn.GetFrame(),
    shot.input.model->SourceCells(),
    contours != nullptr ? std::span(contours->Verdicts()) : std::span<const std::uint8_t>());
}
} // namespace pixelexact
