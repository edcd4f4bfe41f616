// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/XmlBlock.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Files/XmlBlocks.h"

#include <zlib.h>

#include <bit>

namespace pixelexact::nektar
{
namespace
{
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
