// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <pugixml.hpp>
#include <string>
#include <vector>

namespace pixelexact::nektar
{
/// Reads a file's text, in place where it is a FileText's, into `xml`: UTF-8, UTF-16, UTF-32 or,
/// where it is declared, Latin-1. A document type is left out, as by Nektar++'s own parser, and
/// like there entities beyond XML's five stand for themselves. What that parser reads over although
/// it is no XML is repaired, with a line in `notes` each. What that parser ends at,
/// and what would be dropped without a word, is refused: text outside of elements, attributes that
/// are there twice, declarations within a document type. Throws InvalidData
/// ("<file>, line <n>: ...") and, for HDF5, Unsupported. Returns the long blocks that marks stand
/// for (XmlBlocks.h).
std::vector<std::string_view> LoadXml(
  const NamedText& file, pugi::xml_document& xml, std::vector<std::string>& notes);
} // namespace pixelexact::nektar
