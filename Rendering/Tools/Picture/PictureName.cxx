// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/PictureName.h"

#include "Base/Command.h"
#include "Drawing/Picture.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace pixelexact
{
namespace
{
/// Whether WritePng left its mark near the file's beginning.
bool IsOurs(const std::filesystem::path& file)
{
  std::array<char, 4096> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  const std::string_view text(begin.data(), static_cast<std::size_t>(stream.gcount()));
  return text.find(kPictureMark) != std::string_view::npos;
}
} // namespace

std::string PictureNamedAfter(const std::string& input, const std::string& ending)
{
  std::filesystem::path name = std::filesystem::path(input).filename();
  if (name.extension() == ".gz")
  {
    name = name.stem();
  }
  name = name.stem();
  if (name.empty() || name == "-" || name == "." || name == "..")
  {
    throw UsageError("'" + input + "' tells no name for the picture; give one, --output cut.png");
  }
  name += ending + ".png";
  if (std::filesystem::exists(name) && !IsOurs(name))
  {
    throw UsageError("'" + name.string() +
      "' is there and was not made by pixelexact; to write over it name it, --output " +
      name.string());
  }
  return name.string();
}
} // namespace pixelexact
