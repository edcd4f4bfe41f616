// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/PictureFile.h"

#include "Base/Command.h"
#include "Base/Report.h"
#include "Drawing/ImageFile.h"
#include "Drawing/Picture.h"
#include "Picture/DrawnShot.h"
#include "Picture/RenderOptions.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

namespace pixelexact
{
namespace
{
/// Whether the file contains WritePng's mark near its beginning.
bool IsOurs(const std::filesystem::path& file)
{
  std::array<char, 4096> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  const std::string_view text(begin.data(), static_cast<std::size_t>(stream.gcount()));
  return text.find(kPictureMark) != std::string_view::npos;
}
} // namespace

std::string PictureNamedAfter(const std::string& input, const std::string& ending)
{
  std::filesystem::path name = std::filesystem::path(input).filename();
  if (name.extension() == ".gz")
  {
    name = name.stem();
  }
  name = name.stem();
  if (name.empty() || name == "-" || name == "." || name == "..")
  {
    throw UsageError("'" + input + "' gives no name for the picture; give one, --output cut.png");
  }
  name += ending + ".png";
  if (std::filesystem::exists(name) && !IsOurs(name))
  {
    throw UsageError("'" + name.string() +
      "' is there and was not made by pixelexact; to write over it name it, --output " +
      name.string());
  }
  return name.string();
}

std::string EncodePicture(const RenderOptions& options, const DrawnShot& drawn,
  const std::string& file, const RepeatedCommand& command, Stopwatch& watch,
  const PictureTexts& texts)
{
  PictureFacts facts{ options.Dpi(), texts, options.jpegQuality };
  // The losses of exactness are always stored, whatever other texts there are.
  if (const auto given = drawn.WhatIsFound().quality.Texts(); !given.empty())
  {
    facts.texts.emplace_back("Given up", fmt::format("{}", fmt::join(given, "\n")));
  }
  if (options.figure.IsAsked() || !texts.empty())
  {
    const bool hasSource =
      std::ranges::any_of(texts, [](const auto& text) { return text.first == kSourceText; });
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
