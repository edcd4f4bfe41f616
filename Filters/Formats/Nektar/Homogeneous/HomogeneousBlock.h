// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Files/Document.h"
#include "Formats/Nektar/Homogeneous/Homogeneous.h"

namespace pixelexact::nektar
{
/// "a,b,c", each without spaces around it.
std::vector<std::string> SplitAtCommas(std::string_view text);

struct HomogeneousBlock
{
  Homogeneous along;
  int strip = 0; ///< its number, where there are strips
};

/// Reads the homogeneous directions of an ELEMENTS block. `shape` is the elements' shape and `kind`
/// the text after it ("-HomogenousExp1D"); families of these directions are taken from the end of
/// the list. Throws InvalidData and Unsupported.
HomogeneousBlock ReadHomogeneousBlock(const Document& document, const pugi::xml_node& node,
  std::string_view shape, std::string_view kind, std::vector<std::string>& families);
} // namespace pixelexact::nektar
