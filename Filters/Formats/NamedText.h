// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace pixelexact
{
class FileText;

/// A file's content with the name that messages give it.
struct NamedText
{
  std::string name;               ///< the file's path
  std::string_view text;          ///< kept alive by the caller
  const FileText* file = nullptr; ///< whose text it is, to be forgotten as it is read; may be null
};
} // namespace pixelexact
