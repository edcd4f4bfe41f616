// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
/// The picture of an input where none is named: as the input, in the current folder. Throws
/// UsageError where the input's name tells none, or where a file of that name is there that this
/// program did not write.
std::string PictureNamedAfter(const std::string& input, const std::string& ending = {});
} // namespace pixelexact
