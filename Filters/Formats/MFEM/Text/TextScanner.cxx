// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Text/TextScanner.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Core/Base/Quote.h"
#include "Formats/FileText.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}
} // namespace

TextScanner::TextScanner(const NamedText& file)
  : FileName(file.name)
  , Text(file.text)
  , Trace(file.file)
{
}

void TextScanner::SkipBlanks()
{
  while (At < Text.size() && (IsBlank(Text[At]) || Text[At] == '#'))
  {
    At = Text[At] == '#' ? std::min(Text.find('\n', At), Text.size()) : At + 1;
  }
}

std::string_view TextScanner::Peek()
{
  SkipBlanks();
  Trace.Passed(At);
  std::size_t end = At;
  while (end < Text.size() && !IsBlank(Text[end]))
  {
    ++end;
  }
  return Text.substr(At, end - At);
}

std::string_view TextScanner::Word(const char* what)
{
  const std::string_view word = Peek();
  if (word.empty())
  {
    Fail(std::string("the file ends where ") + what + " should follow; it is cut short.");
  }
  At += word.size();
  return word;
}

std::string_view TextScanner::RestOfLine()
{
  const std::size_t end = std::min(Text.find('\n', At), Text.size());
  std::string_view line = Text.substr(At, end - At);
  At = end;
  while (!line.empty() && IsBlank(line.front()))
  {
    line.remove_prefix(1);
  }
  while (!line.empty() && IsBlank(line.back()))
  {
    line.remove_suffix(1);
  }
  return line;
}

void TextScanner::Expect(std::string_view word)
{
  const std::string_view next = Word(("'" + std::string(word) + "'").c_str());
  if (next != word)
  {
    Fail("found " + Quote(next) + " where '" + std::string(word) +
      "' should stand; the file is damaged or of another format.");
  }
}

int TextScanner::Integer(const char* what)
{
  const std::string_view word = Word(what);
  int value = 0;
  if (!ParseWhole(word, value))
  {
    Fail("found " + Quote(word) + " where " + what + " should stand; it is no whole number.");
  }
  return value;
}

int TextScanner::Integer(const char* what, int low, int high)
{
  const int value = Integer(what);
  if (value < low || value > high)
  {
    Fail(std::string(what) + " is " + std::to_string(value) + ", not between " +
      std::to_string(low) + " and " + std::to_string(high) + "; the file contradicts itself.");
  }
  return value;
}

int TextScanner::Count(const char* what, std::size_t bytes)
{
  const int value = Integer(what);
  if (value < 0 || static_cast<std::size_t>(value) > Remaining() / bytes + 1)
  {
    Fail(std::string(what) + " is " + std::to_string(value) + ", but the file has only " +
      Counted(Remaining(), "more byte") + "; it is cut short or damaged.");
  }
  return value;
}

double TextScanner::Number(const char* what)
{
  const std::string_view word = Word(what);
  double value = 0.0;
  if (!ParseReal(word, value))
  {
    Fail("found " + Quote(word) + " where " + what + " should stand; it is no number.");
  }
  return value;
}

void TextScanner::Positions(int count, int dimension, std::vector<double>& positions)
{
  positions.reserve(
    positions.size() + std::min(3 * static_cast<std::size_t>(count), Remaining() / 2));
  for (int i = 0; i < count; ++i)
  {
    for (int d = 0; d < 3; ++d)
    {
      positions.push_back(d < dimension ? Number("a vertex coordinate") : 0.0);
    }
  }
}

bool TextScanner::TryNumber(double& value)
{
  const std::string_view word = Peek();
  if (word.empty() || !ParseReal(word, value))
  {
    return false;
  }
  At += word.size();
  return true;
}

std::string TextScanner::QuotedWord(const char* what)
{
  if (!Peek().starts_with('"'))
  {
    return std::string(Word(what));
  }
  const std::size_t end = Text.find('"', At + 1);
  if (end == std::string_view::npos)
  {
    Fail(std::string("the quotation mark before ") + what + " is never closed.");
  }
  const std::string_view name = Text.substr(At + 1, end - At - 1);
  At = end + 1;
  return std::string(name);
}

std::string TextScanner::Place() const
{
  const auto line =
    1 + std::count(Text.begin(), Text.begin() + static_cast<std::ptrdiff_t>(At), '\n');
  return FileName + ", line " + std::to_string(line) + ": ";
}

void TextScanner::Fail(const std::string& problem) const
{
  throw InvalidData(Place() + problem);
}

void TextScanner::FailAtWord(const std::string& place)
{
  Fail("found " + Quote(Peek()) + " " + place + ", where nothing of that kind should stand; the " +
    "file is damaged or of another format.");
}

void TextScanner::FailUnsupported(const std::string& problem) const
{
  throw Unsupported(Place() + problem);
}
} // namespace pixelexact::mfem
