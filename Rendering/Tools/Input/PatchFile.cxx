// SPDX-License-Identifier: BSD-3-Clause
#include "Input/PatchFile.h"

#include "Base/FileOrPipe.h"
#include "Base/Numbers.h"
#include "Base/Options.h"
#include "Input/Input.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Base/Quote.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace pixelexact
{
namespace
{
constexpr std::size_t kPoints = 16;
constexpr std::size_t kLongestLine = 60; ///< that is shown whole

/// The point of a line; none: the line holds nothing.
std::optional<Vec3> ReadPoint(const std::string& file, std::size_t number, std::string line)
{
  line.erase(std::find(line.begin(), line.end(), '#'), line.end());
  std::ranges::replace(line, '\t', ' ');
  std::ranges::replace(line, '\r', ' ');
  std::vector<std::string> words = SplitAt(line, ' ');
  std::erase(words, "");
  if (words.empty())
  {
    return std::nullopt;
  }
  Vec3 point(0.0);
  for (int d = 0; d < 3; ++d)
  {
    const auto word = static_cast<std::size_t>(d);
    if (words.size() != 3 || !ParseNumber(words[word], point[d]) || !std::isfinite(point[d]))
    {
      CannotRead(file,
        "line " + std::to_string(number) + ": expected three finite numbers x y z, got " +
          Quote(line, kLongestLine));
    }
  }
  return point;
}
} // namespace

std::vector<BezierPatch> ReadPatches(const std::string& file)
{
  if (!std::filesystem::exists(file))
  {
    CannotRead(file, "there is no such file");
  }
  const std::unique_ptr<std::istream> opened = OpenFileOrPipe(file);
  std::istream& stream = *opened;
  if (!stream || std::filesystem::is_directory(file))
  {
    CannotRead(file, "it cannot be opened; name a file of patches");
  }
  std::vector<BezierPatch> patches;
  std::string line;
  std::size_t number = 0;
  while (std::getline(stream, line))
  {
    ++number;
    const std::optional<Vec3> point = ReadPoint(file, number, line);
    if (!point)
    {
      continue;
    }
    if (patches.empty() || patches.back().points.size() == kPoints)
    {
      patches.push_back({ { 3, 3 }, {} });
    }
    patches.back().points.push_back(*point);
  }
  if (stream.bad())
  {
    CannotRead(file, "it ends early; check the disk");
  }
  if (patches.empty())
  {
    CannotRead(file, "it holds no points; a bicubic patch has 16 lines x y z, rows of u");
  }
  if (const std::size_t points = patches.back().points.size(); points != kPoints)
  {
    CannotRead(file,
      "line " + std::to_string(number) + ": the file ends after " + Counted(points, "point") +
        " of patch " + std::to_string(patches.size()) +
        "; a bicubic patch has 16 lines x y z, rows of u");
  }
  return patches;
}
} // namespace pixelexact
