// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/LongBlocks.h"

#include "Core/Base/ParseWhole.h"
#include "Formats/FileText.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace pixelexact::nektar
{
namespace
{
constexpr std::size_t kLong = std::size_t{ 1 } << 18U;
constexpr std::size_t kTogether = std::size_t{ 1 } << 18U;
/// No XML has this character. Marks begin with a letter, as base64 of a zlib stream does.
constexpr char kMark = '\x01';
constexpr std::string_view kBegin = "B\x01";

/// Characters of base64, and blanks.
constexpr std::array<bool, 256> MakeTable()
{
  std::array<bool, 256> table{};
  for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                       "0123456789+/= \n\r\t"))
  {
    table[static_cast<unsigned char>(c)] = true;
  }
  return table;
}

bool IsBase64(char c)
{
  static constexpr std::array<bool, 256> kTable = MakeTable();
  return kTable[static_cast<unsigned char>(c)];
}

/// What stands between a tag and the next one.
struct Between
{
  std::size_t end = 0;
  std::size_t lines = 0;
  bool isBlock = true;
};

Between ReadBetween(std::string_view text, std::size_t begin, ReadingTrace& trace)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n", begin);
  Between found{ begin, 0,
    first < text.size() && std::isalpha(static_cast<unsigned char>(text[first])) != 0 };
  for (;;)
  {
    const std::string_view some = text.substr(found.end, kTogether);
    const std::string_view own = some.substr(0, some.find('<'));
    found.isBlock = found.isBlock && std::ranges::all_of(own, &IsBase64);
    found.lines += static_cast<std::size_t>(std::ranges::count(own, '\n'));
    found.end += own.size();
    trace.Passed(found.end);
    if (own.size() < some.size() || some.empty())
    {
      return found;
    }
  }
}
} // namespace

std::optional<ShortXml> WithoutLongBlocks(const FileText& file)
{
  const std::string_view text = file.Get();
  if (file.Own().empty())
  {
    return std::nullopt;
  }
  ShortXml result;
  ReadingTrace trace(&file);
  std::size_t copied = 0;
  std::size_t blocks = 0;
  for (std::size_t at = text.find('>'); at != std::string_view::npos; at = text.find('>', at))
  {
    const Between between = ReadBetween(text, ++at, trace);
    const std::size_t size = between.end - at;
    if (between.isBlock && size >= kLong)
    {
      result.text.append(text, copied, at - copied);
      result.text.append(kBegin).append(std::to_string(result.blocks.size())) += kMark;
      result.text.append(between.lines, '\n');
      result.blocks.push_back(text.substr(at, size));
      copied = between.end;
      blocks += size;
    }
    at = between.end;
  }
  const auto marks = static_cast<std::size_t>(std::ranges::count(result.text, kMark));
  const std::string_view rest = text.substr(copied);
  if (blocks < text.size() / 2 || marks != 2 * result.blocks.size() ||
    rest.find(kMark) != std::string_view::npos)
  {
    return std::nullopt;
  }
  result.text.append(rest);
  return result;
}

std::optional<std::size_t> BlockAt(std::string_view text)
{
  const std::size_t end = text.find(kMark, kBegin.size());
  std::int64_t number = 0;
  if (!text.starts_with(kBegin) || end == std::string_view::npos ||
    !ParseWhole(text.substr(kBegin.size(), end - kBegin.size()), number) || number < 0)
  {
    return std::nullopt;
  }
  return static_cast<std::size_t>(number);
}
} // namespace pixelexact::nektar
