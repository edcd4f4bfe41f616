// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/XmlBlocks.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <functional>

namespace pixelexact::nektar
{
namespace
{
constexpr std::size_t kLargestPage = std::size_t{ 1 } << 16U;
constexpr std::size_t kBlock = std::size_t{ 1 } << 16U;

std::array<int, 256> MakeDigitTable()
{
  std::array<int, 256> table{};
  table.fill(-1);
  for (std::size_t i = 0; i < kBase64Digits.size(); ++i)
  {
    table[static_cast<unsigned char>(kBase64Digits[i])] = static_cast<int>(i);
  }
  return table;
}

constexpr std::size_t kLong = std::size_t{ 1 } << 18U;
constexpr std::size_t kTogether = std::size_t{ 1 } << 18U;
/// A character that cannot occur in XML. Marks begin with a letter, as base64 of a zlib stream
/// does.
constexpr char kMark = '\x01';
constexpr std::string_view kBegin = "B\x01";

/// Whether a character belongs to base64 or is a blank.
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

/// The text between a tag and the next one.
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

std::string Base64(std::span<const std::byte> bytes)
{
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const auto at = [&](std::size_t k)
    { return i + k < bytes.size() ? std::to_integer<unsigned>(bytes[i + k]) : 0U; };
    const unsigned triple = at(0) << 16U | at(1) << 8U | at(2);
    text += kBase64Digits[triple >> 18U];
    text += kBase64Digits[triple >> 12U & 63U];
    text += i + 1 < bytes.size() ? kBase64Digits[triple >> 6U & 63U] : '=';
    text += i + 2 < bytes.size() ? kBase64Digits[triple & 63U] : '=';
  }
  return text;
}
} // namespace

Decompressor::Decompressor(
  std::string_view base64, std::size_t most, std::string where, const FileText* file)
  : Text(base64)
  , Most(most)
  , Where(std::move(where))
{
  State = inflateInit(&Stream);
  // The parser writes into the text before and after a block, so the page in which the text begins
  // is kept.
  const std::string_view whole = file != nullptr ? file->Get() : std::string_view();
  if (!file || file->Own().empty() || base64.empty() ||
    std::less<>()(base64.data(), whole.data()) ||
    !std::less<>()(base64.data(), whole.data() + whole.size()))
  {
    return;
  }
  Begin = whole.data();
  Trace = ReadingTrace(file, static_cast<std::size_t>(base64.data() - Begin) + kLargestPage);
}

Decompressor::~Decompressor()
{
  inflateEnd(&Stream);
}

/// Decodes the next bytes of the stream.
void Decompressor::Decode()
{
  static const auto table = MakeDigitTable();
  Packed.clear();
  std::size_t at = 0;
  for (; at < Text.size() && Packed.size() < kBlock; ++at)
  {
    const char c = Text[at];
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
    {
      continue;
    }
    if (c == '=')
    {
      at = Text.size();
      break;
    }
    const int digit = table[static_cast<unsigned char>(c)];
    if (digit < 0)
    {
      throw InvalidData(Where +
        ": the compressed data hold a character that is no base64; the "
        "file is damaged.");
    }
    Bits = Bits << 6U | static_cast<unsigned>(digit);
    Count += 6;
    if (Count >= 8)
    {
      Count -= 8;
      Packed.push_back(static_cast<unsigned char>(Bits >> Count & 0xffU));
    }
  }
  Text.remove_prefix(at);
  if (Begin != nullptr && !Text.empty())
  {
    Trace.Passed(static_cast<std::size_t>(Text.data() - Begin));
  }
  Stream.next_in = Packed.data();
  Stream.avail_in = static_cast<uInt>(Packed.size());
}

std::size_t Decompressor::Read(std::span<std::byte> bytes)
{
  std::size_t got = 0;
  while (got < bytes.size() && State == Z_OK)
  {
    if (Stream.avail_in == 0)
    {
      Decode();
    }
    const auto room = static_cast<uInt>(std::min(bytes.size() - got, kBlock));
    Stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + got);
    Stream.avail_out = room;
    State = inflate(&Stream, Z_NO_FLUSH);
    got += room - Stream.avail_out;
    if (Total + got > Most)
    {
      throw InvalidData(Where + ": the compressed data expand to more than the " +
        std::to_string(Most) + " bytes that they should have; the file is damaged.");
    }
  }
  if (State != Z_OK && State != Z_STREAM_END)
  {
    throw InvalidData(
      Where + ": the compressed data are damaged or cut short; copy the file again.");
  }
  Total += got;
  return got;
}

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

std::string StoredBlock(std::span<const std::byte> bytes)
{
  auto size = compressBound(bytes.size());
  std::vector<std::byte> stream(size);
  if (compress2(reinterpret_cast<Bytef*>(stream.data()), &size,
        reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_NO_COMPRESSION) != Z_OK)
  {
    throw Error("there is not enough memory for a data set.");
  }
  return Base64(std::span(stream).first(size));
}

std::string Block(const std::string& tag, const std::vector<std::int64_t>& numbers)
{
  if (numbers.empty())
  {
    return {};
  }
  return "<" + tag + " " + kBlockAttributes + ">" + StoredBlock(std::as_bytes(std::span(numbers))) +
    "</" + tag + ">";
}

std::vector<std::int64_t> PointRecords(
  const std::vector<std::int64_t>& ids, const std::vector<double>& places)
{
  std::vector<std::int64_t> records;
  records.reserve(4 * ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    records.push_back(ids[i]);
    for (std::size_t d = 0; d < 3; ++d)
    {
      records.push_back(std::bit_cast<std::int64_t>(places[3 * i + d]));
    }
  }
  return records;
}
} // namespace pixelexact::nektar
