// SPDX-License-Identifier: BSD-3-Clause
#include "FilesBeside.h"

#include "Core/Base/ParseWhole.h"

#include <algorithm>
#include <system_error>

namespace pixelexact
{
std::vector<std::filesystem::path> FilesBeside(
  const std::filesystem::path& file, const std::string& suffix)
{
  std::vector<std::filesystem::path> files;
  std::error_code failure;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
  {
    if (entry.path().extension() == suffix)
    {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

int NumberBehind(const std::string& name, const std::string& stem)
{
  int number = -1;
  const bool is = name.starts_with(stem + "_") &&
    ParseWhole(std::string_view(name).substr(stem.size() + 1), number);
  return is ? number : -1;
}

std::string WithoutNumber(const std::string& name)
{
  const std::size_t at = name.rfind('_');
  return at != std::string::npos && NumberBehind(name, name.substr(0, at)) >= 0 ? name.substr(0, at)
                                                                                : name;
}
} // namespace pixelexact
