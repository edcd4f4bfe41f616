// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <string>
#include <vector>

namespace pixelexact
{
struct PointTable
{
  std::vector<Vec3> points;
  std::size_t headerLine = 0;
  bool hasZ = true; ///< else z = 0 is all that there is
};

/// Reads the columns x, y and, where it exists, z of a CSV file, or of standard input ("-"), with a
/// header line; further columns are ignored. Other names of the columns are Points:0 to Points:2
/// (ParaView's data) and Points_0 to Points_2 (its spreadsheets), if x, y, z are incomplete. The
/// header determines the separator: comma, semicolon or tab. Accepts quoted fields, a byte-order
/// mark and CRLF, and skips empty lines. Throws Error naming the line where a number is missing or
/// invalid, or where there are more values than columns.
PointTable ReadPoints(const std::string& file);

/// Throws Error, naming the line, where the table has no z. For meshes that are not plane.
void RequireZ(const std::string& file, const PointTable& table);

/// A text as a field of a CSV file: quoted where it needs quotes.
std::string CsvField(const std::string& text);

/// 17 significant digits, which give back the same double; NaN is "nan".
void AppendNumber(std::string& line, double number);
} // namespace pixelexact
