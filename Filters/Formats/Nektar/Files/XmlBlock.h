// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

// Numbers as elements of Nektar++'s compressed XML: base64 of a zlib stream.
namespace pixelexact::nektar
{
inline constexpr const char* kBlockAttributes = "COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"";

/// Base64 of a zlib stream that holds the bytes as they are.
std::string StoredBlock(std::span<const std::byte> bytes);

/// An element that holds the numbers; empty without any.
std::string Block(const std::string& tag, const std::vector<std::int64_t>& numbers);

/// Points' records, each a number and three coordinates, as bits.
std::vector<std::int64_t> PointRecords(
  const std::vector<std::int64_t>& ids, const std::vector<double>& places);
} // namespace pixelexact::nektar
