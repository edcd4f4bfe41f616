// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ExodusName.h"

#include "Input/Input.h"

#include <fmt/format.h>

#include <filesystem>
#include <regex>

namespace pixelexact
{
std::optional<ExodusName> ParseExodusName(const std::string& file)
{
  static const std::regex pattern(
    R"((.*\.(?:e|exo|ex2|exii|g))(-s(\d{1,8}))?(?:\.(\d{1,6})\.(\d{1,6}))?)",
    std::regex::ECMAScript | std::regex::icase);
  // Names of folders are any; the pattern is for what follows them.
  const auto begin = file.rfind('/') == std::string::npos ? 0 : file.rfind('/') + 1;
  const std::string last = file.substr(begin);
  std::smatch match;
  if (!std::regex_match(last, match, pattern))
  {
    return std::nullopt;
  }
  ExodusName name;
  name.first = file.substr(0, begin) + match[1].str();
  if (match[2].matched)
  {
    name.meshSuffix = match[2];
    name.mesh = std::stoi(match[3]);
  }
  if (match[4].matched)
  {
    name.partsText = match[4];
    name.parts = std::stoi(name.partsText);
    name.digits = match[5].str().size();
    if (name.parts < 1 || std::stoi(match[5]) >= name.parts)
    {
      return std::nullopt;
    }
  }
  return name;
}

bool IsExodusPart(const std::string& file)
{
  const auto name = ParseExodusName(file);
  return name && (name->parts > 0 || !name->meshSuffix.empty());
}

std::vector<std::string> PartsOf(const ExodusName& name)
{
  const std::string whole = name.first + name.meshSuffix;
  if (name.parts == 0)
  {
    return { whole };
  }
  std::vector<std::string> files;
  std::string missing;
  int count = 0;
  for (int part = 0; part < name.parts; ++part)
  {
    files.push_back(fmt::format("{}.{}.{:0{}}", whole, name.partsText, part, name.digits));
    std::error_code failure;
    if (!std::filesystem::exists(files.back(), failure))
    {
      missing = count++ == 0 ? files.back() : missing;
    }
  }
  if (count > 0)
  {
    CannotRead(files.front(),
      "the run wrote " + std::to_string(name.parts) + " parts, of which " + std::to_string(count) +
        " are not there, the first of them '" + missing + "'; put all beside each other");
  }
  return files;
}
} // namespace pixelexact
