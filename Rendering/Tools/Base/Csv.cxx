// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Csv.h"

#include "Base/FileOrPipe.h"
#include "Base/Numbers.h"
#include "Base/Output.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

namespace pixelexact
{
namespace
{
[[noreturn]] void RefuseLine(const std::string& file, std::size_t line, const std::string& why)
{
  throw Error("'" + file + "', line " + std::to_string(line) + ": " + why);
}

constexpr std::size_t kNoColumn = std::string::npos;
constexpr const char* kNeeded =
  "the columns x, y and z are needed, or Points:0, Points:1 and Points:2 as ParaView writes them, "
  "between commas, semicolons or tabs";

[[noreturn]] void RefuseHeader(const std::string& file, std::size_t line, const std::string& name)
{
  RefuseLine(file, line, "the header names no column '" + name + "'; " + kNeeded);
}

/// The names of a point's columns here, in ParaView's data and in its spreadsheets.
using PointNames = std::array<const char*, 3>;
constexpr std::array<PointNames, 3> kPointNames{ { { "x", "y", "z" },
  { "Points:0", "Points:1", "Points:2" }, { "Points_0", "Points_1", "Points_2" } } };

/// A header line and the columns of x, y and z; kNoColumn: missing.
struct Header
{
  char separator = ',';
  std::vector<std::string> fields;
  std::array<std::size_t, 3> columns{ kNoColumn, kNoColumn, kNoColumn };
  PointNames names = kPointNames.front();

  [[nodiscard]] bool Has(std::size_t d) const { return columns[d] != kNoColumn; }
  [[nodiscard]] std::ptrdiff_t Count() const { return 3 - std::ranges::count(columns, kNoColumn); }
  void Find(const PointNames& wanted)
  {
    names = wanted;
    std::ranges::transform(names, columns.begin(),
      [this](const char* name)
      {
        const auto named = [name](const std::string& title) { return Trim(title) == name; };
        const auto found = std::ranges::find_if(fields, named);
        return found == fields.end() ? kNoColumn : static_cast<std::size_t>(found - fields.begin());
      });
  }
};

/// Refuses lines with more fields than the header. A decimal comma shifts all fields after it.
void RefuseMore(const std::string& file, std::size_t line, const std::vector<std::string>& fields,
  std::size_t columns)
{
  const auto isThere = [](const std::string& field) { return !Trim(field).empty(); };
  if (fields.size() > columns &&
    std::any_of(fields.begin() + static_cast<std::ptrdiff_t>(columns), fields.end(), isThere))
  {
    RefuseLine(file, line,
      std::to_string(fields.size()) + " values under " + std::to_string(columns) +
        " columns; decimals are written with a point, and every column has a name");
  }
}

/// The remedy for a field that is not a number. Between semicolons it may contain a decimal comma.
std::string RemedyOf(const std::string& field)
{
  return field.find(',') == std::string::npos ? "" : "; decimals are written with a point";
}

/// Splits one line into fields. Returns false where a quote is left open or text follows a closing
/// one.
bool SplitLine(std::string_view line, char separator, std::vector<std::string>& fields)
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
    else if (c == separator)
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

void RequireOnce(const std::string& file, std::size_t line, const Header& header)
{
  for (const char* name : header.names)
  {
    const auto named = [name](const std::string& title) { return Trim(title) == name; };
    if (std::ranges::count_if(header.fields, named) > 1)
    {
      RefuseLine(file, line, std::string("the header names the column '") + name + "' twice");
    }
  }
}

/// Finds the separator and names of the columns: first a header with x, y and z, then one with x
/// and y. Commas and the names x, y, z come first.
Header ReadHeader(const std::string& file, std::size_t line, std::string_view text)
{
  std::vector<Header> read;
  for (const char separator : { ',', ';', '\t' })
  {
    Header header;
    header.separator = separator;
    for (const PointNames& names : kPointNames)
    {
      if (SplitLine(text, separator, header.fields))
      {
        header.Find(names);
        read.push_back(header);
      }
    }
  }
  if (read.empty())
  {
    RefuseLine(file, line, "a quoted field is not closed properly");
  }
  auto found = std::ranges::find_if(read, [](const Header& one) { return one.Count() == 3; });
  if (found == read.end())
  {
    found = std::ranges::find_if(read, [](const Header& one) { return one.Has(0) && one.Has(1); });
  }
  if (found == read.end())
  {
    RefuseHeader(file, line, read.front().names[read.front().Has(0) ? 1 : 0]);
  }
  RequireOnce(file, line, *found);
  return *found;
}
} // namespace

PointTable ReadPoints(const std::string& file)
{
  std::unique_ptr<std::istream> opened;
  if (!IsStandardStream(file))
  {
    opened = OpenFileOrPipe(file);
    if (!*opened || std::filesystem::is_directory(file))
    {
      throw Error("cannot open the points '" + file + "'; is the path right?");
    }
  }
  std::istream& stream = IsStandardStream(file) ? std::cin : *opened;
  PointTable table;
  std::optional<Header> header;
  std::vector<std::string> fields;
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
    // Empty fields between tabs are missing numbers, so such a line is not skipped.
    if (Trim(line).empty() && !(header && line.find(header->separator) != std::string::npos))
    {
      continue;
    }
    if (!header)
    {
      header = ReadHeader(file, number, line);
      table.headerLine = number;
      table.hasZ = header->Has(2);
      continue;
    }
    if (!SplitLine(line, header->separator, fields))
    {
      RefuseLine(file, number, "a quoted field is not closed properly");
    }
    RefuseMore(file, number, fields, header->fields.size());
    Vec3 point(0.0);
    for (std::size_t d = 0; d < (table.hasZ ? 3U : 2U); ++d)
    {
      const std::size_t column = header->columns[d];
      const std::string name = header->names[d];
      if (column >= fields.size())
      {
        RefuseLine(file, number, "there is no " + name);
      }
      if (!ParseNumber(fields[column], point[static_cast<int>(d)]))
      {
        RefuseLine(file, number,
          name + " is no number: '" + fields[column] + "'" + RemedyOf(fields[column]));
      }
    }
    table.points.push_back(point);
  }
  if (stream.bad())
  {
    throw Error("cannot read the points '" + file + "' to the end");
  }
  if (!header)
  {
    throw Error("the points '" + file + "' hold no header line; " + kNeeded);
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

std::string CsvField(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return quoted + '"';
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
