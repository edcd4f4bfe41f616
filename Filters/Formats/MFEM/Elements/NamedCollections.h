// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/CollectionName.h"

#include <optional>
#include <string>

// MFEM's collections with names of their own: those of fixed order, and those that are not read.
namespace pixelexact::mfem
{
/// Throws Unsupported: the collection in quotes, and why.
[[noreturn]] void RefuseCollection(const std::string& text, const std::string& reason);

/// For messages: in quotes, shortened, without control characters.
std::string QuoteName(const std::string& text);

/// Throws Unsupported: of elements of another dimension than the mesh's.
[[noreturn]] void RefuseDimension(const std::string& text, int dimension, int wanted);

/// A collection of fixed order, of elements of that dimension. Throws Unsupported for those of
/// others.
std::optional<CollectionName> FixedCollection(const std::string& text, int dimension);

/// Throws for names of collections that are not read.
void RefuseOtherCollections(const std::string& text);
} // namespace pixelexact::mfem
