// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Scanner.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Core/Base/Quote.h"
#include "Formats/FileText.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace pixelexact::gmsh
{
namespace
{
/// Bytes that are searched at a time.
constexpr std::size_t kWindow = std::size_t{ 1 } << 22U;

bool IsBlank(char c)
{
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}
} // namespace

Scanner::Scanner(std::string fileName, std::string_view text, const FileText* file)
  : FileName(std::move(fileName))
  , Text(text)
  , Trace(file)
{
}

std::string_view Scanner::Peek()
{
  while (At < Text.size() && IsBlank(Text[At]))
  {
    ++At;
  }
  Trace.Passed(At);
  std::size_t end = At;
  while (end < Text.size() && !IsBlank(Text[end]))
  {
    ++end;
  }
  return Text.substr(At, end - At);
}

std::string_view Scanner::Word(const char* what)
{
  const std::string_view word = Peek();
  if (word.empty())
  {
    Fail(std::string("the file ends where ") + what + " should follow; it is cut short.");
  }
  At += word.size();
  return word;
}

std::string Scanner::Quoted(const char* what)
{
  if (!Peek().starts_with('"'))
  {
    Fail("found " + Quote(Peek()) + " where " + what + " should stand between quotation marks.");
  }
  const std::size_t end = Text.find_first_of("\"\n", At + 1);
  if (end == std::string_view::npos || Text[end] == '\n')
  {
    Fail(std::string("the quotation mark before ") + what + " is never closed.");
  }
  const std::string_view name = Text.substr(At + 1, end - At - 1);
  At = end + 1;
  return std::string(name);
}

std::string Scanner::QuotedOrLine(const char* what)
{
  if (Peek().empty() || Peek().front() == '"')
  {
    return Quoted(what);
  }
  const std::size_t begin = At;
  At = std::min(Text.find('\n', At), Text.size());
  std::string_view line = Text.substr(begin, At - begin);
  while (IsBlank(line.back()))
  {
    line.remove_suffix(1);
  }
  return std::string(line);
}

std::int64_t Scanner::TextInteger(const char* what)
{
  return Integer(Word(what), what);
}

std::int64_t Scanner::IntegerBeforeName(const char* what)
{
  const std::string_view word = Word(what);
  const std::size_t behind = word.size() - std::min(word.size(), word.find('"'));
  At -= behind;
  return Integer(word.substr(0, word.size() - behind), what);
}

std::int64_t Scanner::Integer(std::string_view word, const char* what) const
{
  std::int64_t value = 0;
  if (!ParseWhole(word, value))
  {
    Fail("found " + Quote(word) + " where " + what + " should stand; it is no whole number.");
  }
  return value;
}

std::size_t Scanner::TextCount(const char* what, std::size_t bytes)
{
  const std::int64_t value = TextInteger(what);
  if (value < 0)
  {
    Fail(std::string(what) + " is " + std::to_string(value) + "; the file is damaged.");
  }
  RequireCount(what, static_cast<std::uint64_t>(value), bytes);
  return static_cast<std::size_t>(value);
}

double Scanner::TextNumber(const char* what)
{
  const std::string_view word = Word(what);
  double value = 0.0;
  if (!ParseReal(word, value))
  {
    Fail("found " + Quote(word) + " where " + what + " should stand; it is no number.");
  }
  return value;
}

void Scanner::EndLine()
{
  while (At < Text.size() && Text[At] != '\n')
  {
    if (!IsBlank(Text[At]))
    {
      Fail("found " + Quote(Peek()) + " where the line should end; the file is damaged.");
    }
    ++At;
  }
  At = std::min(At + 1, Text.size());
}

template <class Number>
Number Scanner::Bytes(const char* what)
{
  char bytes[sizeof(Number)];
  if (Remaining() < sizeof(Number))
  {
    Fail(std::string("the file ends where ") + what + " should follow; it is cut short.");
  }
  std::memcpy(bytes, Text.data() + At, sizeof(Number));
  At += sizeof(Number);
  Trace.Passed(At);
  if (Data.swapped)
  {
    std::ranges::reverse(bytes);
  }
  Number value{};
  std::memcpy(&value, bytes, sizeof(Number));
  return value;
}

int Scanner::Int(const char* what)
{
  if (Data.binary)
  {
    return Bytes<std::int32_t>(what);
  }
  const std::int64_t value = TextInteger(what);
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
  {
    Fail(std::string(what) + " is " + std::to_string(value) + "; it should have 32 bits.");
  }
  return static_cast<int>(value);
}

double Scanner::Real(const char* what)
{
  return Data.binary ? Bytes<double>(what) : TextNumber(what);
}

std::uint64_t Scanner::Size(const char* what)
{
  if (Data.binary)
  {
    return Data.sizeBytes == 8 ? Bytes<std::uint64_t>(what) : Bytes<std::uint32_t>(what);
  }
  const std::int64_t value = TextInteger(what);
  if (value < 0)
  {
    Fail(std::string(what) + " is " + std::to_string(value) + "; the file is damaged.");
  }
  return static_cast<std::uint64_t>(value);
}

std::size_t Scanner::Count(const char* what, std::size_t items)
{
  const std::uint64_t count = Size(what);
  // A number takes at least a digit and a blank, or 4 bytes.
  RequireCount(what, count, items * (Data.binary ? 4 : 2));
  return static_cast<std::size_t>(count);
}

void Scanner::RequireCount(const char* what, std::uint64_t count, std::size_t bytes) const
{
  if (count > Remaining() / std::max<std::size_t>(bytes, 1) + 1)
  {
    Fail(std::string(what) + " is " + std::to_string(count) + ", but the file has only " +
      Counted(Remaining(), "more byte") + "; it is cut short or damaged.");
  }
}

void Scanner::SkipWords(std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    Word("a number");
  }
}

void Scanner::SkipBytes(std::size_t count, std::size_t size)
{
  if (count > Remaining() / size)
  {
    Fail("the file ends among its data; it is cut short.");
  }
  At += count * size;
}

void Scanner::SkipInts(std::size_t count)
{
  Data.binary ? SkipBytes(count, 4) : SkipWords(count);
}

void Scanner::SkipSizes(std::size_t count)
{
  Data.binary ? SkipBytes(count, static_cast<std::size_t>(Data.sizeBytes)) : SkipWords(count);
}

void Scanner::SkipReals(std::size_t count)
{
  Data.binary ? SkipBytes(count, 8) : SkipWords(count);
}

void Scanner::EndSection(std::string_view section)
{
  const std::string end = "$End" + std::string(section);
  const std::string_view next = Word(end.c_str());
  if (next != end)
  {
    Fail("found " + Quote(next) + " where '" + end +
      "' should stand; a count is wrong or the file is damaged.");
  }
}

void Scanner::LeaveSection(std::string_view section)
{
  const std::string end = "$End" + std::string(section);
  const std::size_t begin = At;
  for (;;)
  {
    const std::size_t window = std::min(Text.size(), At + kWindow + end.size());
    const std::size_t found = Text.substr(0, window).find(end, At);
    if (found == std::string_view::npos && window < Text.size())
    {
      At = window - end.size(); // which may begin there
      Trace.Passed(At);
      continue;
    }
    if (found == std::string_view::npos)
    {
      At = begin;
      Fail("the section $" + std::string(section) + " has no end; the file is cut short.");
    }
    At = found + end.size();
    // Several writers put no line end between binary data and the section's end.
    const bool begins = Data.binary || found == 0 || Text[found - 1] == '\n';
    if (begins && (At == Text.size() || IsBlank(Text[At])))
    {
      return;
    }
  }
}

std::string Scanner::Place() const
{
  if (Data.binary)
  {
    return FileName + ", byte " + std::to_string(At) + ": ";
  }
  const auto line =
    1 + std::count(Text.begin(), Text.begin() + static_cast<std::ptrdiff_t>(At), '\n');
  return FileName + ", line " + std::to_string(line) + ": ";
}

void Scanner::Fail(const std::string& problem) const
{
  throw InvalidData(Place() + problem);
}

void Scanner::FailUnsupported(const std::string& problem) const
{
  throw Unsupported(Place() + problem);
}
} // namespace pixelexact::gmsh
