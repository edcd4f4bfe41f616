// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact::nektar
{
inline constexpr std::string_view kBase64Digits =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Decompresses base64 text of a zlib stream in portions.
class Decompressor
{
public:
  /// `base64` must outlive this object; messages begin with `where`. If it is a part of the text of
  /// `file`, which may be null, its pages are released as they are read and must not be read again.
  Decompressor(
    std::string_view base64, std::size_t most, std::string where, const FileText* file = nullptr);
  ~Decompressor();
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  /// Fills `bytes`. Returns their number, which is smaller only at the end. Throws InvalidData
  /// where the text is not base64, the stream is damaged or truncated, or the result has more than
  /// `most` bytes.
  std::size_t Read(std::span<std::byte> bytes);
  /// All that were given.
  [[nodiscard]] std::size_t Given() const { return Total; }

private:
  void Decode();

  std::string_view Text; ///< what is left of it
  std::size_t Most;
  std::string Where;
  const char* Begin = nullptr; ///< of the file's text
  ReadingTrace Trace;
  std::vector<unsigned char> Packed;
  z_stream Stream{};
  int State = 0;
  std::size_t Total = 0;
  unsigned Bits = 0; ///< decoded, and how many
  unsigned Count = 0;
};

/// XML with marks that replace long blocks of base64, with the same number of lines.
struct ShortXml
{
  std::string text;
  std::vector<std::string_view> blocks; ///< in the file's text
};

/// An XML parser goes through all of a text, which is in memory then: so the blocks, which are
/// decoded piece by piece, are kept from it. None where they are not most of a mapped file.
std::optional<ShortXml> WithoutLongBlocks(const FileText& file);

/// The number of the block that the text of an element marks; none where it is not a mark.
std::optional<std::size_t> BlockAt(std::string_view text);

// Numbers as elements of Nektar++'s compressed XML: base64 of a zlib stream.

inline constexpr const char* kBlockAttributes = "COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"";

/// Base64 of a zlib stream that holds the bytes as they are.
std::string StoredBlock(std::span<const std::byte> bytes);

/// An element that holds the numbers; empty without any.
std::string Block(const std::string& tag, const std::vector<std::int64_t>& numbers);

/// Points' records, each a number and three coordinates, as bits.
std::vector<std::int64_t> PointRecords(
  const std::vector<std::int64_t>& ids, const std::vector<double>& places);
} // namespace pixelexact::nektar
