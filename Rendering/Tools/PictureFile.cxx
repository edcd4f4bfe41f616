// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include "DrawnShot.h"
#include "ImageFile.h"
#include "RenderOptions.h"

namespace pixelexact
{
std::string EncodePicture(const RenderOptions& options, const DrawnShot& drawn,
  const std::string& file, const RepeatedCommand& command, const PictureTexts& told)
{
  PictureFacts facts{ options.Dpi(), told };
  if (options.figure.IsAsked() || !told.empty())
  {
    facts.texts.insert(facts.texts.end(),
      { { "Source", DescribeFiles(options.shot.input.files) }, { "Command", command.Text() },
        { "Pixels", drawn.PixelsText() } });
  }
  const PictureFormat format = FormatOf("--output", file);
  return IsVector(format) ? drawn.Vectors(format, facts.texts, file)
                          : EncodeImage(drawn.Picture(), format, facts, file);
}
} // namespace pixelexact
