// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FrameProvenance.h"

#include "Base/Command.h"
#include "Base/Provenance.h"
#include "Drawing/Picture.h"
#include "Picture/RenderOptions.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace pixelexact
{
std::string ProvenanceOf(const RenderOptions& options, const CommonOptions& common)
{
  std::string all = DescribeFiles(WithFilesBehind(options.shot.input.files)) + '\n' + kPictureMark;
  for (std::size_t i = 0; i < common.words.size(); ++i)
  {
    const std::string& word = common.words[i];
    const bool takesOne = word == "--threads" || word == "-o" || word == "--output";
    const bool joined = word.starts_with("--threads=") || word.starts_with("--output=");
    if (word != "--resume" && word != "--json" && word != "--quiet" && word != "-q" && !takesOne &&
      !joined)
    {
      all += '\n' + word;
      // A font, a colour map or a surface may be another one under the same name.
      const std::string value = word.substr(word.starts_with("--") ? word.find('=') + 1 : 0);
      for (const std::string& file : { value, value.substr(0, value.rfind(':')) })
      {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored))
        {
          all += '\n' + DescribeFiles({ file });
          break;
        }
      }
    }
    i += takesOne ? 1 : 0;
  }
  return all;
}

std::string HashOf(const std::string& provenance, int frame, int frames)
{
  const std::string text = fmt::format("{}\n{} of {}", provenance, frame, frames);
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

bool IsThere(const std::string& file, const std::string& hash)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return stream && text.str().find(hash) != std::string::npos;
}
} // namespace pixelexact
