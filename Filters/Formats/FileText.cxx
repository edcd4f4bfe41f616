// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/FileText.h"

#include "Core/Base/Error.h"

#include <zlib.h>

#include <filesystem>
#include <memory>

namespace pixelexact
{
namespace
{
/// Text of numbers is compressed to a third or so; much more than that is no text of numbers.
constexpr std::uintmax_t kLargestExpansion = 200;
constexpr std::size_t kBlock = std::size_t{ 1 } << 20U;

struct CloseFile
{
  void operator()(gzFile file) const { gzclose_r(file); }
};
} // namespace

std::string ReadFileText(const std::string& path)
{
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status))
  {
    throw InvalidData("there is no file '" + path + "'; check its name.");
  }
  if (std::filesystem::is_directory(status))
  {
    throw InvalidData("'" + path + "' is a folder; name a file.");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  const std::unique_ptr<gzFile_s, CloseFile> file(gzopen(path.c_str(), "rb"));
  if (failure || !file)
  {
    throw InvalidData("'" + path + "' cannot be opened; check its permissions.");
  }
  std::string text;
  text.reserve(size + kBlock); // what is read next must fit, too: a copy would double the memory
  for (;;)
  {
    const std::size_t begin = text.size();
    text.resize(begin + kBlock);
    const int got = gzread(file.get(), text.data() + begin, kBlock);
    text.resize(begin + static_cast<std::size_t>(got < 0 ? 0 : got));
    int state = Z_OK;
    const char* message = gzerror(file.get(), &state);
    // A stream cut short is no error of gzread, only Z_BUF_ERROR.
    if (got < 0 || state != Z_OK)
    {
      throw InvalidData("'" + path + "' is damaged (" + message + "); copy it anew.");
    }
    if (got == 0)
    {
      return text;
    }
    if (text.size() > kLargestExpansion * (size + 1))
    {
      throw InvalidData("'" + path + "' expands to more than " + std::to_string(kLargestExpansion) +
        " times its size; gunzip it if that is right.");
    }
  }
}
} // namespace pixelexact
