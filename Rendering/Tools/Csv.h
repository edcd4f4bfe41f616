// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// The columns x, y and z of a CSV file, or of standard input ("-"), with a header line; further
/// columns are ignored. Accepts quoted fields, a byte-order mark, CRLF, and empty lines, which it
/// skips. Throws Error naming the line where a number is missing or none.
std::vector<Vec3> ReadPoints(const std::string& file);

/// 17 significant digits, which give back the same double; NaN is "nan".
void AppendNumber(std::string& line, double number);
} // namespace pixelexact
