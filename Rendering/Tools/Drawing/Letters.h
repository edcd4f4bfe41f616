// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Views/TextImages.h"

#include <string>

namespace pixelexact
{
[[nodiscard]] bool IsAscii(const std::string& text);

/// A text as UTF-8; bytes that are none, which names of files and arrays may hold, become U+FFFD.
std::string ValidUtf8(const std::string& text);

/// The font that a text is written in: the one that was asked for, or, where that is one by name
/// and the text has letters beyond ASCII, the nearest file with these that fontconfig knows. Warns
/// once of a text with letters that the font lacks.
FontChoice FontWithLetters(const std::string& text, const FontChoice& asked);
} // namespace pixelexact
