// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FrameNames.h"

#include "Base/Command.h"

#include <fmt/format.h>

#include <regex>

namespace pixelexact
{
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
