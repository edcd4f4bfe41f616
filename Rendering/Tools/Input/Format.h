// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Input.h"

#include <array>
#include <span>

namespace pixelexact
{
/// A suffix of a format's files and the function that reads them: a row of
/// Rendering/Settings/formats.json.
struct Format
{
  const char* suffix;
  const char* name;
  bool hasMesh = false; ///< false: the files hold fields without a mesh, and `read` refuses them
  bool mayBeFolder = false;
  InputGrid (*read)(const InputRequest&) = nullptr; ///< throws as ReadInput
  const char* remedy = nullptr;                     ///< of formats that are not read
  std::array<const char*, 2> marks{}; ///< at the beginning of files; null: there are no more
};

/// All rows, in the order in which messages list the suffixes. FormatTable.cxx defines it: that
/// file alone includes all readers.
[[nodiscard]] std::span<const Format> Formats();
} // namespace pixelexact
