// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Error.h"

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

/// Calls a function, and puts `where` before the message of an InvalidData or Unsupported that it
/// throws.
template <class Function>
decltype(auto) NameErrors(const std::string& where, Function&& function)
{
  try
  {
    return function();
  }
  catch (const Unsupported& error)
  {
    throw Unsupported(where + ": " + error.what());
  }
  catch (const InvalidData& error)
  {
    throw InvalidData(where + ": " + error.what());
  }
}
} // namespace pixelexact
