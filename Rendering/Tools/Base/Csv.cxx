// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Csv.h"

#include "Base/Numbers.h"
#include "Base/Output.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace pixelexact
{
namespace
{
[[noreturn]] void Refuse(const std::string& file, std::size_t line, const std::string& why)
{
  throw Error("'" + file + "', line " + std::to_string(line) + ": " + why);
}

constexpr std::size_t kNoColumn = std::string::npos;

[[noreturn]] void RefuseHeader(const std::string& file, std::size_t line, const std::string& name)
{
  Refuse(
    file, line, "the header names no column '" + name + "'; the columns x, y and z are needed");
}

/// Which columns hold x, y and z; kNoColumn: no z.
std::array<std::size_t, 3> FindColumns(
  const std::string& file, std::size_t line, const std::vector<std::string>& header)
{
  std::array<std::size_t, 3> columns{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    const std::string name(1, "xyz"[d]);
    const auto named = [&name](const std::string& title) { return Trim(title) == name; };
    const auto found = std::find_if(header.begin(), header.end(), named);
    if (found == header.end())
    {
      if (d < 2)
      {
        RefuseHeader(file, line, name);
      }
      columns[d] = kNoColumn;
      continue;
    }
    if (std::any_of(found + 1, header.end(), named))
    {
      Refuse(file, line, "the header names the column '" + name + "' twice");
    }
    columns[d] = static_cast<std::size_t>(found - header.begin());
  }
  return columns;
}

/// A comma that was meant as a decimal point moves all that stands behind it.
void RefuseMore(const std::string& file, std::size_t line, const std::vector<std::string>& fields,
  std::size_t columns)
{
  const auto isThere = [](const std::string& field) { return !Trim(field).empty(); };
  if (fields.size() > columns &&
    std::any_of(fields.begin() + static_cast<std::ptrdiff_t>(columns), fields.end(), isThere))
  {
    Refuse(file, line,
      std::to_string(fields.size()) + " values under " + std::to_string(columns) +
        " columns; decimals are written with a point, and every column has a name");
  }
}

/// The fields of one line; false where a quote is left open or text follows a closing one.
bool SplitLine(std::string_view line, std::vector<std::string>& fields)
{
  fields.assign(1, {});
  bool quoted = false;
  bool closed = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const char c = line[i];
    if (quoted)
    {
      if (c != '"')
      {
        fields.back() += c;
      }
      else if (i + 1 < line.size() && line[i + 1] == '"')
      {
        fields.back() += '"';
        ++i;
      }
      else
      {
        quoted = false;
        closed = true;
      }
    }
    else if (c == ',')
    {
      fields.emplace_back();
      closed = false;
    }
    else if (closed)
    {
      return false;
    }
    else if (c == '"' && fields.back().empty())
    {
      quoted = true;
    }
    else
    {
      fields.back() += c;
    }
  }
  return !quoted;
}
} // namespace

PointTable ReadPoints(const std::string& file)
{
  std::ifstream opened;
  if (!IsStandardStream(file))
  {
    opened.open(file, std::ios::binary);
    if (!opened || std::filesystem::is_directory(file))
    {
      throw Error("cannot open the points '" + file + "'; is the path right?");
    }
  }
  std::istream& stream = IsStandardStream(file) ? std::cin : opened;
  PointTable table;
  std::array<std::size_t, 3> columns{};
  std::vector<std::string> fields;
  std::size_t named = 0;
  bool header = true;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number)
  {
    if (number == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0)
    {
      line.erase(0, 3);
    }
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (Trim(line).empty())
    {
      continue;
    }
    if (!SplitLine(line, fields))
    {
      Refuse(file, number, "a quoted field is not closed properly");
    }
    if (header)
    {
      columns = FindColumns(file, number, fields);
      named = fields.size();
      table.headerLine = number;
      table.hasZ = columns[2] != kNoColumn;
      header = false;
      continue;
    }
    RefuseMore(file, number, fields, named);
    Vec3 point(0.0);
    for (int d = 0; d < (table.hasZ ? 3 : 2); ++d)
    {
      const std::size_t column = columns[static_cast<std::size_t>(d)];
      if (column >= fields.size())
      {
        Refuse(file, number, std::string("there is no ") + "xyz"[d]);
      }
      if (!ParseNumber(fields[column], point[d]))
      {
        Refuse(file, number, std::string(1, "xyz"[d]) + " is no number: '" + fields[column] + "'");
      }
    }
    table.points.push_back(point);
  }
  if (stream.bad())
  {
    throw Error("cannot read the points '" + file + "' to the end");
  }
  if (header)
  {
    throw Error("the points '" + file + "' hold no header line; the columns x, y and z are needed");
  }
  return table;
}

void RequireZ(const std::string& file, const PointTable& table)
{
  if (!table.hasZ)
  {
    RefuseHeader(file, table.headerLine, "z");
  }
}

void AppendNumber(std::string& line, double number)
{
  if (std::isnan(number))
  {
    line += "nan";
    return;
  }
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(
    buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::general, 17)
                     .ptr;
  line.append(buffer.data(), end);
}
} // namespace pixelexact
