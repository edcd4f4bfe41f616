// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/AnimationFrames.h"

#include "Base/Command.h"
#include "Base/Provenance.h"
#include "Drawing/Picture.h"
#include "Picture/RenderOptions.h"

#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <utility>

namespace pixelexact
{
FrameProgress::FrameProgress(std::string what, int frames)
  : What(std::move(what))
  , Frames(frames)
  , Terminal(isatty(STDERR_FILENO) != 0)
{
}

FrameProgress::~FrameProgress()
{
  if (Terminal)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

void FrameProgress::Tell(int done, int made) const
{
  if (!Terminal)
  {
    return;
  }
  std::cerr << fmt::format("\r\033[K{} {} of {}", What, done + 1, Frames);
  if (made > 0)
  {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - Begin;
    const double left = passed.count() / made * (Frames - done);
    std::cerr << (left < 90.0 ? fmt::format(", {:.0f} s left", left)
                              : fmt::format(", {:.0f} min left", left / 60.0));
  }
  std::cerr << std::flush;
}

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

namespace
{
constexpr const char* kFrame = "{frame}";
constexpr const char* kStep = "{step}";

std::string Numbered(int number, int digits)
{
  return fmt::format("{:0{}}", number, digits);
}

int DigitsOf(int count)
{
  return static_cast<int>(std::to_string(count > 0 ? count - 1 : 0).size());
}

void Replace(std::string& text, const std::string& what, const std::string& by)
{
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
  {
    text.replace(at, what.size(), by);
  }
}
} // namespace

FrameNames::FrameNames(const char* option, const std::string& pattern, const std::string& example)
  : Pattern(pattern)
{
  static const std::regex kNumber("%(0([1-9]))?d");
  std::smatch found;
  if (std::regex_search(pattern, found, kNumber))
  {
    Digits = found[2].matched ? std::stoi(found[2]) : 1;
    Pattern = found.prefix().str() + kFrame + found.suffix().str();
  }
  if (Pattern.find('%') != std::string::npos ||
    (Pattern.find(kFrame) == std::string::npos && Pattern.find(kStep) == std::string::npos))
  {
    throw UsageError(std::string(option) + ": '" + pattern +
      "' names one file, and there are several pictures; number them, as " + example);
  }
}

std::string FrameNames::Of(int frame, int step, int frames, int steps) const
{
  std::string name = Pattern;
  Replace(name, kFrame, Numbered(frame, Digits > 0 ? Digits : DigitsOf(frames)));
  Replace(name, kStep, Numbered(step, DigitsOf(steps)));
  return name;
}

bool IsVideo(const std::string& file)
{
  return file.ends_with(".mp4") || file.ends_with(".webm");
}
} // namespace pixelexact
