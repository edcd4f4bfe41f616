// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Compressed.h"

#include "Core/Base/Error.h"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace pixelexact::nektar
{
namespace
{
constexpr std::string_view kDigits =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kBlock = std::size_t{ 1 } << 16U;

std::array<int, 256> MakeDigitTable()
{
  std::array<int, 256> table{};
  table.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
  {
    table[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  }
  return table;
}

std::vector<unsigned char> DecodeBase64(std::string_view text, const std::string& where)
{
  static const auto table = MakeDigitTable();
  std::vector<unsigned char> bytes;
  bytes.reserve(text.size() / 4 * 3);
  unsigned bits = 0;
  unsigned count = 0;
  for (const char c : text)
  {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
    {
      continue;
    }
    if (c == '=')
    {
      break;
    }
    const int digit = table[static_cast<unsigned char>(c)];
    if (digit < 0)
    {
      throw InvalidData(where +
        ": the compressed data hold a character that is no base64; the "
        "file is damaged.");
    }
    bits = bits << 6U | static_cast<unsigned>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> count & 0xffU));
    }
  }
  return bytes;
}

/// Ends the stream however the function is left.
struct Inflater
{
  Inflater() { ready = inflateInit(&stream) == Z_OK; }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream stream{};
  bool ready = false;
};
} // namespace

std::vector<std::byte> Decompress(
  std::string_view base64, std::size_t most, const std::string& where)
{
  std::vector<unsigned char> packed = DecodeBase64(base64, where);
  Inflater inflater;
  inflater.stream.next_in = packed.data();
  inflater.stream.avail_in = static_cast<uInt>(packed.size());
  std::vector<std::byte> bytes;
  int state = inflater.ready ? Z_OK : Z_MEM_ERROR;
  while (state == Z_OK)
  {
    const std::size_t begin = bytes.size();
    bytes.resize(begin + kBlock);
    inflater.stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + begin);
    inflater.stream.avail_out = kBlock;
    state = inflate(&inflater.stream, Z_NO_FLUSH);
    bytes.resize(begin + kBlock - inflater.stream.avail_out);
    if (bytes.size() > most)
    {
      throw InvalidData(where + ": the compressed data expand to more than the " +
        std::to_string(most) + " bytes that they should have; the file is damaged.");
    }
  }
  if (state != Z_STREAM_END)
  {
    throw InvalidData(
      where + ": the compressed data are damaged or cut short; copy the file anew.");
  }
  return bytes;
}
} // namespace pixelexact::nektar
