// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>
#include <zlib.h>

namespace pixelexact::nektar
{
inline constexpr std::string_view kBase64Digits =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The bytes behind base64 text of a zlib stream, some at a time.
class Decompressor
{
public:
  /// `base64` is kept alive by the caller; messages begin with `where`. Where it is a part of
  /// `file`'s text, which may be null, it is forgotten as it is read: nobody reads it again.
  Decompressor(
    std::string_view base64, std::size_t most, std::string where, const FileText* file = nullptr);
  ~Decompressor();
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  /// Fills `bytes`; says how many they are, fewer only at the end. Throws InvalidData for text that
  /// is no base64, a damaged or truncated stream, and one that gives more than `most` bytes.
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
} // namespace pixelexact::nektar
