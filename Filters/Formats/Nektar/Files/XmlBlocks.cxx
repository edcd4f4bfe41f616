// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/XmlBlocks.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <array>
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

} // namespace

Decompressor::Decompressor(
  std::string_view base64, std::size_t most, std::string where, const FileText* file)
  : Text(base64)
  , Most(most)
  , Where(std::move(where))
{
  State = inflateInit(&Stream);
  // The parser's own marks stand before and behind; the page in which the text begins is kept.
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

/// The next bytes of the stream.
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
      Where + ": the compressed data are damaged or cut short; copy the file anew.");
  }
  Total += got;
  return got;
}
} // namespace pixelexact::nektar
