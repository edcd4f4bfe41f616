// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/FieldSeries.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace pixelexact::nektar
{
namespace
{
/// The metadata stand before the data.
constexpr std::size_t kHead = std::size_t{ 1 } << 16U;

std::string HeadOf(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string head(kHead, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}
} // namespace

std::vector<std::string> FieldParts(const std::string& path)
{
  std::error_code failure;
  if (!std::filesystem::is_directory(path, failure))
  {
    return { path };
  }
  std::vector<std::string> parts;
  for (const auto& entry : std::filesystem::directory_iterator(path))
  {
    const auto suffix = entry.path().extension();
    if (entry.is_regular_file() &&
      (suffix == ".xml" || suffix == ".fld" || suffix == ".chk" || suffix == ".rst"))
    {
      parts.push_back(entry.path().string());
    }
  }
  if (parts.empty())
  {
    throw InvalidData("the folder '" + path +
      "' holds no parts of a Nektar++ field file (Info.xml, P0000000.fld, ...); name the folder "
      "that the solver wrote.");
  }
  std::ranges::sort(parts);
  return parts;
}

std::optional<double> FieldTime(const std::string& path)
{
  const std::string head = HeadOf(FieldParts(path).front());
  const std::string open = "<Time>";
  const auto at = head.find(open);
  if (at == std::string::npos)
  {
    return std::nullopt;
  }
  const std::string_view text = std::string_view(head).substr(at + open.size());
  const auto end = text.find('<');
  double time = 0.0;
  if (end == std::string_view::npos || !ParseWhole(WithoutBlanks(text.substr(0, end)), time))
  {
    throw InvalidData(path + ": its <Time> is no number; mend it or take it out.");
  }
  return time;
}
} // namespace pixelexact::nektar
