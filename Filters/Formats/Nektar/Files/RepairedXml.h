// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact::nektar
{
/// A text that breaks the rules of XML, as Nektar++'s own parser (TinyXML) and its users take it.
struct RepairedXml
{
  std::string text;                 ///< XML of as many lines
  std::vector<std::string> repairs; ///< one sentence each, with the line; never empty
};

/// Repairs what TinyXML reads over, and end tags that Nektar++'s own sessions have wrong:
/// - "<" before anything but a letter, '_', '/', '?', "!--", "![CDATA[" and "!DOCTYPE" begins a tag
///   of no meaning, which ends at the first '>' (<!N VAR="u"/>, <--!I PROPERTY="x"/-->);
/// - an attribute's value without quotation marks ends at a blank, '/' or '>' (<P A=1/>);
/// - an end tag ends its element whatever stands behind its name (</F NAME="f">);
/// - <A/> within A, where the end tag of A is missing, is that end tag (<A>text<A/>).
/// None where nothing of this is in the text, or where its tags do not match all the same. The text
/// is in a code of one byte for each of XML's marks, such as UTF-8.
std::optional<RepairedXml> RepairXml(std::string_view text);
} // namespace pixelexact::nektar
