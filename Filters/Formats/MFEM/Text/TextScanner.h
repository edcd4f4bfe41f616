// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <string_view>
#include <vector>

namespace pixelexact::mfem
{
/// Reads words and numbers of an MFEM file in order, with their line. A word that begins with '#'
/// is a comment to the end of its line.
class TextScanner
{
public:
  explicit TextScanner(const NamedText& file);

  /// The next word without taking it; empty at the end.
  std::string_view Peek();
  /// Returns the next word; fails at the end. `what` names the expected word.
  std::string_view Word(const char* what);
  /// The rest of the current line, without blanks at its ends.
  std::string_view RestOfLine();
  /// A word that must be the given one.
  void Expect(std::string_view word);

  int Integer(const char* what);
  /// An integer in [low, high].
  int Integer(const char* what, int low, int high);
  /// A number of things that each take at least `bytes` bytes of the text that is left.
  int Count(const char* what, std::size_t bytes);
  double Number(const char* what);
  /// Appends the positions of `count` vertices, (x, y, z) each, z = 0 where the file has two
  /// coordinates (`dimension`). Memory is limited by the remaining text, because `count` may be
  /// wrong; fails where the text ends early.
  void Positions(int count, int dimension, std::vector<double>& positions);
  /// Takes the next word if it is a number.
  bool TryNumber(double& value);
  /// A word, or words between quotation marks.
  std::string QuotedWord(const char* what);

  [[nodiscard]] std::size_t Remaining() const { return Text.size() - At; }
  [[nodiscard]] const std::string& Name() const { return FileName; }

  /// Throws InvalidData or Unsupported: "<file>, line <n>: <problem>".
  [[noreturn]] void Fail(const std::string& problem) const;
  [[noreturn]] void FailUnsupported(const std::string& problem) const;
  /// Fails because the next word is not allowed at this place.
  [[noreturn]] void FailAtWord(const std::string& place);

private:
  void SkipBlanks();
  [[nodiscard]] std::string Place() const;

  std::string FileName;
  std::string_view Text;
  std::size_t At = 0;
  ReadingTrace Trace;
};
} // namespace pixelexact::mfem
