// SPDX-License-Identifier: BSD-3-Clause
#ifndef MessageWords_h
#define MessageWords_h

#include "PixelExactDataModelModule.h"

#include <string>
#include <vector>

// Messages name C++ classes and functions. A program whose users know other names, as ParaView's
// do, replaces them in all messages of filters, mappers and representations.
namespace pixelexact
{
struct MessageWord
{
  std::string name; ///< in messages
  std::string word; ///< shown in its place
};

/// Sets the replacements of this process; of two names that begin at one place the one that stands
/// first in the list counts. Not thread-safe: call it while libraries are loaded.
PIXELEXACTDATAMODEL_EXPORT void SetMessageWords(std::vector<MessageWord> words);

/// Returns the text with the replacements; without any, the text itself.
[[nodiscard]] PIXELEXACTDATAMODEL_EXPORT std::string Worded(const std::string& text);
} // namespace pixelexact
#endif
