// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Output.h"

#include "Base/Command.h"
#include "Base/Report.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace pixelexact
{
namespace
{
[[noreturn]] void CannotWrite(const std::string& file)
{
  throw Error("cannot write '" + file + "'; does its folder exist and is there room?");
}
} // namespace

bool IsStandardStream(const std::string& file)
{
  return file == "-";
}

OutputFile::OutputFile(const std::string& file)
  : Name(file)
{
  if (!IsStandardStream(Name))
  {
    File.open(Name, std::ios::binary);
    if (!File)
    {
      CannotWrite(Name);
    }
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
  File.close();
  if (!File)
  {
    // A part of a file would be taken for the whole.
    std::error_code ignored;
    if (std::filesystem::is_regular_file(std::filesystem::symlink_status(Name, ignored)))
    {
      std::filesystem::remove(Name, ignored);
    }
    CannotWrite(Name);
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
    std::filesystem::remove(beside, failure);
    CannotWrite(file);
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
