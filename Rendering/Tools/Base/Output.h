// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace pixelexact
{
/// Whether a file's name means standard input or output: "-".
bool IsStandardStream(const std::string& file);

/// Throws Error: `what` cannot be written, for the reason of the operating system (errno; 0: it
/// gave none).
[[noreturn]] void CannotWrite(const std::string& what, int reason);

/// A file's buffer that keeps the operating system's reason of the first failure, which streams
/// drop.
class WrittenBuffer final : public std::filebuf
{
public:
  /// The first failure's errno, of this one where it is the first; 0: there is none.
  int Noted(bool failed);

protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int sync() override;

private:
  int Failure = 0;
};

/// A file that is written, or standard output.
class OutputFile
{
public:
  /// Throws Error naming the file where it cannot be opened.
  explicit OutputFile(const std::string& file);

  [[nodiscard]] std::ostream& Stream();
  /// Throws Error where something of what was written is lost. To be called last.
  void Close();

private:
  std::string Name;
  WrittenBuffer Buffer;
  std::ostream File{ &Buffer };
};

/// Writes all of a file. Throws Error as OutputFile.
void WriteBytes(const std::string& file, const std::string& bytes);
/// Writes a file completely or not at all, even if the program ends: under another name first, then
/// renamed.
void WriteAtOnce(const std::string& file, const std::string& bytes);

/// Checks an output file before the work. Throws Error where it is a folder or its folder does not
/// exist, UsageError where it is an input.
void CheckOutput(const char* option, const std::string& file, std::vector<std::string> read);

/// Throws UsageError where two of `files`, or one and --json, are standard output.
void CheckStandardOutput(const std::vector<std::string>& files, bool json);
} // namespace pixelexact
