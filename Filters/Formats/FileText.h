// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Error.h"

#include <cstddef>
#include <deque>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact
{
class FileText;

/// A file's content with the name that messages give it.
struct NamedText
{
  std::string name;               ///< the file's path
  std::string_view text;          ///< kept alive by the caller
  const FileText* file = nullptr; ///< whose text it is, to be forgotten as it is read; may be null
};

/// Calls a function, and puts `where` before the message of an InvalidData or Unsupported that it
/// throws.
template <class Function>
decltype(auto) NameErrors(const std::string& where, Function&& function)
{
  try
  {
    return function();
  }
  catch (const Unsupported& error)
  {
    throw Unsupported(where + ": " + error.what());
  }
  catch (const InvalidData& error)
  {
    throw InvalidData(where + ": " + error.what());
  }
}

/// Parses as ParseWhole. Numbers beyond the range of doubles become zero or infinite, as in the C
/// library.
bool ParseReal(std::string_view word, double& value);

/// Whether a path leads to something that cannot be read twice, and may be waited for without an
/// end: a pipe (FIFO), a socket or a device.
bool IsPipeOrDevice(const std::string& path);
inline constexpr const char* kPipeRemedy =
  "it is a pipe or a device; write its content into a file, and name that";

/// Throws InvalidData for those, for folders, and where there is no such file.
void RequireRegularFile(const std::string& path);

/// A file's whole content, gunzipped where it is compressed. Throws InvalidData (no such file, a
/// folder, unreadable, damaged, or decompressing to more than 200 times its size).
std::string ReadFileText(const std::string& path);

/// The first `bytes` of a file, gunzipped where it is compressed, fewer where it is shorter. Empty
/// where it is not a regular file or cannot be read.
std::string ReadFileHead(const std::string& path, std::size_t bytes);

/// The same as ReadFileText for parsers that read a large file once, forward: the file is mapped,
/// so that what they have passed need not stay in memory. Small and compressed files are read.
class FileText
{
public:
  /// Throws as ReadFileText.
  explicit FileText(const std::string& path);
  ~FileText();
  FileText(const FileText&) = delete;
  FileText& operator=(const FileText&) = delete;

  [[nodiscard]] std::string_view Get() const { return Text; }

  /// The same to be written into by one parser, and what it wrote forgotten with the text; empty
  /// where the text is not mapped.
  [[nodiscard]] std::span<char> Own() const;

  /// Releases the memory of the text from `begin` to `end`; later accesses read the file. Throws
  /// InvalidData where the file has changed its size since.
  void Forget(std::size_t begin, std::size_t end) const;

private:
  void RequireSameSize() const;

  std::string Path;
  std::string Held; ///< what is not mapped
  int File = -1;    ///< of what is mapped
  std::string_view Text;
};

/// The contents of several files as the parsers take them.
class FileTexts
{
public:
  /// Throws as ReadFileText.
  explicit FileTexts(const std::vector<std::string>& files) { this->Add(files); }
  void Add(const std::vector<std::string>& files);

  std::vector<NamedText> Named; ///< in the files' order

private:
  std::deque<FileText> Storage; ///< which stay where they are
};

/// Releases the pages of a text after a reader that moves forward.
class ReadingTrace
{
public:
  ReadingTrace() = default;
  /// `file` may be null; `from`: where reading begins.
  explicit ReadingTrace(const FileText* file, std::size_t from = 0)
    : File(file)
    , From(from)
    , Next(file != nullptr ? from + kStep : kNever)
  {
  }

  /// Must be called often.
  void Passed(std::size_t at)
  {
    if (at >= Next)
    {
      Forget(at);
    }
  }
  /// Reading goes on at another place.
  void MoveTo(std::size_t at);

private:
  static constexpr std::size_t kStep = std::size_t{ 1 } << 23U;
  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

  void Forget(std::size_t at);

  const FileText* File = nullptr;
  std::size_t From = 0;
  std::size_t Next = kNever;
};
} // namespace pixelexact
