// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Output.h"

#include "Base/Command.h"
#include "Base/Report.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace pixelexact
{
void CannotWrite(const std::string& what, int reason)
{
  if (reason == 0)
  {
    throw Error("cannot write " + what + "; does its folder exist and is there room?");
  }
  const bool isFull = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
  throw Error("cannot write " + what + ": " + std::generic_category().message(reason) +
    (isFull ? "; make room, or name another place" : ""));
}

namespace
{
std::string InQuotes(const std::string& file)
{
  return "'" + file + "'";
}
} // namespace

int WrittenBuffer::Noted(bool failed)
{
  Failure = failed && Failure == 0 ? errno : Failure;
  return Failure;
}

WrittenBuffer::int_type WrittenBuffer::overflow(int_type c)
{
  errno = 0;
  const int_type result = std::filebuf::overflow(c);
  Noted(traits_type::eq_int_type(result, traits_type::eof()));
  return result;
}

std::streamsize WrittenBuffer::xsputn(const char* bytes, std::streamsize count)
{
  errno = 0;
  const std::streamsize written = std::filebuf::xsputn(bytes, count);
  Noted(written < count);
  return written;
}

int WrittenBuffer::sync()
{
  errno = 0;
  const int result = std::filebuf::sync();
  Noted(result != 0);
  return result;
}

bool IsStandardStream(const std::string& file)
{
  return file == "-";
}

OutputFile::OutputFile(const std::string& file)
  : Name(file)
{
  errno = 0;
  if (!IsStandardStream(Name) && Buffer.open(Name, std::ios::out | std::ios::binary) == nullptr)
  {
    CannotWrite(InQuotes(Name), errno);
  }
}

std::ostream& OutputFile::Stream()
{
  return IsStandardStream(Name) ? std::cout : File;
}

void OutputFile::Close()
{
  if (IsStandardStream(Name))
  {
    FlushOutput();
    return;
  }
  errno = 0;
  const bool closed = Buffer.close() != nullptr;
  const int reason = Buffer.Noted(!closed);
  if (!closed || !File)
  {
    // Removes an incomplete file, which could be mistaken for a complete one.
    std::error_code ignored;
    if (std::filesystem::is_regular_file(std::filesystem::symlink_status(Name, ignored)))
    {
      std::filesystem::remove(Name, ignored);
    }
    CannotWrite(InQuotes(Name), reason);
  }
}

void WriteBytes(const std::string& file, const std::string& bytes)
{
  OutputFile output(file);
  output.Stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  output.Close();
}

void WriteAtOnce(const std::string& file, const std::string& bytes)
{
  const std::string beside = file + ".part";
  WriteBytes(beside, bytes);
  std::error_code failure;
  std::filesystem::rename(beside, file, failure);
  if (failure)
  {
    const int reason = failure.value();
    std::filesystem::remove(beside, failure);
    CannotWrite(InQuotes(file), reason);
  }
}

void CheckOutput(const char* option, const std::string& file, std::vector<std::string> read)
{
  if (file.empty() || IsStandardStream(file))
  {
    return;
  }
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
  {
    throw Error("cannot write '" + file + "': there is no folder '" + folder.string() + "'");
  }
  if (std::filesystem::is_directory(file, ignored))
  {
    throw Error("cannot write '" + file + "': it is a folder; name a file");
  }
  if (std::ranges::any_of(read,
        [&](const std::string& one) { return std::filesystem::equivalent(file, one, ignored); }))
  {
    throw UsageError(std::string(option) + ": '" + file + "' is read, and would be overwritten");
  }
}

void CheckStandardOutput(const std::vector<std::string>& files, bool json)
{
  const auto uses = std::ranges::count_if(files, IsStandardStream);
  if (uses > 1)
  {
    throw UsageError("two files cannot both be standard output, -; name a file for one");
  }
  if (uses == 1 && json)
  {
    throw UsageError("--json prints its summary on standard output, where a file '-' goes; name a "
                     "file, or leave out --json");
  }
}
} // namespace pixelexact
