// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include "DrawnShot.h"
#include "ImageFile.h"
#include "RenderOptions.h"

#include <fmt/format.h>

#include <algorithm>

namespace pixelexact
{
std::string EncodePicture(const RenderOptions& options, const DrawnShot& drawn,
  const std::string& file, const RepeatedCommand& command, const PictureTexts& told)
{
  PictureFacts facts{ options.Dpi(), told };
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
  }
  const PictureFormat format = FormatOf("--output", file);
  return IsVector(format) ? drawn.Vectors(format, facts.texts, file)
                          : EncodeImage(drawn.Picture(), format, facts, file);
}
} // namespace pixelexact
