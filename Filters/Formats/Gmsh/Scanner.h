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

/// The encoding of numbers in a file's data.
struct Encoding
{
  double version = 0.0;
  bool binary = false;
  bool swapped = false; ///< the other byte order
  int sizeBytes = 8;    ///< of counts and tags in version 4.1
};

/// Reads lines, words and numbers of a Gmsh file in order. Headers are always text; the encoding
/// determines whether numbers of the data are text or binary.
class Scanner
{
public:
  /// `file`: the owner of `text`, whose pages are released as they are read; may be null.
  Scanner(std::string fileName, std::string_view text, const FileText* file = nullptr);

  void SetEncoding(const Encoding& encoding) { Data = encoding; }
  [[nodiscard]] const Encoding& GetEncoding() const { return Data; }

  // Functions that read text.
  /// Returns the next word without taking it; empty at the end.
  std::string_view Peek();
  std::string_view Word(const char* what);
  /// Returns the text between the next pair of quotation marks on the same line.
  std::string Quoted(const char* what);
  /// The same. Where a program wrote no quotation marks, the rest of the line.
  std::string QuotedOrLine(const char* what);
  std::int64_t TextInteger(const char* what);
  /// Reads an integer that a name in quotation marks may follow without a blank.
  std::int64_t IntegerBeforeName(const char* what);
  std::size_t TextCount(const char* what, std::size_t bytes);
  double TextNumber(const char* what);
  /// Skips the rest of a line and its end. Binary data begin after it.
  void EndLine();

  // Functions that read data.
  int Int(const char* what);
  double Real(const char* what);
  /// Reads a count or tag of version 4.1.
  std::uint64_t Size(const char* what);
  /// Reads a count of items that each take at least `items` numbers.
  std::size_t Count(const char* what, std::size_t items);
  /// Skips numbers: integers, counts, reals.
  void SkipInts(std::size_t count);
  void SkipSizes(std::size_t count);
  void SkipReals(std::size_t count);

  /// Fails unless `$End<section>` follows, and takes it.
  void EndSection(std::string_view section);
  /// Moves to the end of the section's `$End<section>` from anywhere in it.
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
