// SPDX-License-Identifier: BSD-3-Clause
#include "Base/FileOrPipe.h"

#include "Core/Base/Error.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace pixelexact
{
std::string MakeOutputFolder(
  const std::string& given, const std::string& input, const std::string& ending)
{
  const std::filesystem::path folder = given.empty()
    ? std::filesystem::path(std::filesystem::path(input).filename().stem().string() + ending)
    : std::filesystem::path(given);
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (!std::filesystem::is_directory(folder))
  {
    throw Error("--output: the folder '" + folder.string() + "' cannot be made" +
      (error ? ": " + error.message() : std::string()));
  }
  return folder.string();
}

std::unique_ptr<std::istream> OpenFileOrPipe(const std::string& path)
{
  constexpr int kPatience = 5000; // milliseconds
  std::error_code failure;
  struct pollfd waited
  {
    - 1, POLLIN, 0
  };
  if (std::filesystem::is_fifo(path, failure))
  {
    waited.fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  }
  if (waited.fd < 0)
  {
    return std::make_unique<std::ifstream>(path, std::ios::binary);
  }
  std::string text;
  const bool isWritten = poll(&waited, 1, kPatience) > 0;
  if (isWritten)
  {
    fcntl(waited.fd, F_SETFL, 0); // whoever writes may take their time
    std::array<char, 65536> some{};
    for (ssize_t got = 1; got > 0;)
    {
      got = read(waited.fd, some.data(), some.size());
      text.append(some.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    }
  }
  close(waited.fd);
  if (!isWritten)
  {
    throw InvalidData("nobody writes into the pipe '" + path + "'; name a file");
  }
  return std::make_unique<std::istringstream>(text);
}
} // namespace pixelexact
