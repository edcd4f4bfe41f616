// SPDX-License-Identifier: BSD-3-Clause
#include "Base/OutputFolder.h"

#include "Core/Base/Error.h"

#include <filesystem>

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
} // namespace pixelexact
