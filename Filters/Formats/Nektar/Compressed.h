// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact::nektar
{
/// The bytes behind base64 text of a zlib stream. Throws InvalidData, beginning with `where`, for
/// text that is no base64, a damaged or truncated stream, and one that gives more than `most`
/// bytes.
std::vector<std::byte> Decompress(
  std::string_view base64, std::size_t most, const std::string& where);
} // namespace pixelexact::nektar
