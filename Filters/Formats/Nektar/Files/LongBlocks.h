// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact
{
class FileText;
}

namespace pixelexact::nektar
{
/// XML with marks in place of long blocks of base64, as many lines as it had.
struct ShortXml
{
  std::string text;
  std::vector<std::string_view> blocks; ///< in the file's text
};

/// An XML parser goes through all of a text, which is in memory then: so the blocks, which are
/// decoded piece by piece, are kept from it. None where they are not most of a mapped file.
std::optional<ShortXml> WithoutLongBlocks(const FileText& file);

/// Which block the text of an element is; none: it is none.
std::optional<std::size_t> BlockAt(std::string_view text);
} // namespace pixelexact::nektar
