// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pixelexact::gmsh
{
/// The version of $MeshFormat whose sections have entities.
inline constexpr double kNew = 4.1;

/// How numbers lie in a file's data.
struct Encoding
{
  double version = 0.0;
  bool binary = false;
  bool swapped = false; ///< the other byte order
  int sizeBytes = 8;    ///< of counts and tags in version 4.1
};

/// Lines, words and numbers of a Gmsh file, one after the other. Headers are always text; numbers
/// of the data are text or bytes, as the encoding says.
class Scanner
{
public:
  /// `file`: whose text it is, to be forgotten as it is read; may be null.
  Scanner(std::string fileName, std::string_view text, const FileText* file = nullptr);

  void SetEncoding(const Encoding& encoding) { Data = encoding; }
  [[nodiscard]] const Encoding& GetEncoding() const { return Data; }

  // Text.
  /// The next word without taking it; empty at the end.
  std::string_view Peek();
  std::string_view Word(const char* what);
  /// What is between the next pair of quotation marks, on the same line.
  std::string Quoted(const char* what);
  /// The same; some programs write no quotation marks: all of the line, then.
  std::string QuotedOrLine(const char* what);
  std::int64_t TextInteger(const char* what);
  /// The same where a name in quotation marks may follow without a blank.
  std::int64_t IntegerBeforeName(const char* what);
  std::size_t TextCount(const char* what, std::size_t bytes);
  double TextNumber(const char* what);
  /// Takes what is left of a line, with its end; binary data begin behind it.
  void EndLine();

  // Data.
  int Int(const char* what);
  double Real(const char* what);
  /// A count or tag of version 4.1.
  std::uint64_t Size(const char* what);
  /// A number of things that each take at least `items` numbers.
  std::size_t Count(const char* what, std::size_t items);
  /// Passes over numbers: integers, counts, reals.
  void SkipInts(std::size_t count);
  void SkipSizes(std::size_t count);
  void SkipReals(std::size_t count);

  /// Fails unless `$End<section>` follows, and takes it.
  void EndSection(std::string_view section);
  /// Moves behind the section's `$End<section>`, whatever stands before it.
  void LeaveSection(std::string_view section);

  [[nodiscard]] std::size_t Remaining() const { return Text.size() - At; }
  [[nodiscard]] std::size_t Position() const { return At; }
  void MoveTo(std::size_t position)
  {
    Trace.MoveTo(position);
    At = position;
  }
  [[nodiscard]] const std::string& Name() const { return FileName; }

  /// Throw InvalidData or Unsupported: "<file>, line <n>: <problem>"; in binary files the byte.
  [[noreturn]] void Fail(const std::string& problem) const;
  [[noreturn]] void FailUnsupported(const std::string& problem) const;

private:
  std::int64_t Integer(std::string_view word, const char* what) const;
  template <class Number>
  Number Bytes(const char* what);
  void SkipWords(std::size_t count);
  void SkipBytes(std::size_t count, std::size_t size);
  void RequireCount(const char* what, std::uint64_t count, std::size_t bytes) const;
  [[nodiscard]] std::string Place() const;

  std::string FileName;
  std::string_view Text;
  std::size_t At = 0;
  ReadingTrace Trace;
  Encoding Data;
};
} // namespace pixelexact::gmsh
