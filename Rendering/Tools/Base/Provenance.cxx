// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Provenance.h"

#include "Core/Base/Error.h"
#include "Files/TimeSeries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

namespace pixelexact
{
namespace
{
/// Quotes a word for a shell.
std::string Quoted(const std::string& word)
{
  constexpr std::string_view kPlain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
    "_-./,=:%+@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos)
  {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}
} // namespace

std::vector<std::string> RepeatedCommand::Words() const
{
  std::vector<std::string> words{ "pixelexact" };
  words.insert(words.end(), given.begin(), given.end());
  // Words after "--" are not options.
  words.insert(std::ranges::find(words, "--"), chosen.begin(), chosen.end());
  return words;
}

std::string RepeatedCommand::Text() const
{
  std::vector<std::string> words = Words();
  std::ranges::transform(words, words.begin(), Quoted);
  return fmt::format("{}", fmt::join(words, " "));
}

std::string DescribeFiles(const std::vector<std::string>& files)
{
  constexpr std::size_t kBlock = std::size_t{ 1 } << 20;
  std::string text;
  std::vector<char> block(kBlock);
  for (const std::string& file : files)
  {
    const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(
      XXH3_createState(), &XXH3_freeState);
    XXH3_64bits_reset(state.get());
    std::ifstream stream(file, std::ios::binary);
    std::size_t size = 0;
    while (stream.read(block.data(), static_cast<std::streamsize>(kBlock)) || stream.gcount() > 0)
    {
      const auto count = static_cast<std::size_t>(stream.gcount());
      XXH3_64bits_update(state.get(), block.data(), count);
      size += count;
    }
    if (!stream.eof())
    {
      throw Error("cannot read '" + file + "' once more, for the picture's metadata");
    }
    text += fmt::format("{}{}: {} bytes, xxh3 {:016x}", text.empty() ? "" : "\n",
      std::filesystem::path(file).filename().string(), size, XXH3_64bits_digest(state.get()));
  }
  return text;
}

std::vector<std::string> WithFilesBehind(const std::vector<std::string>& files)
{
  std::vector<std::string> all;
  for (const std::string& file : files)
  {
    all.push_back(file);
    std::vector<GridPart> parts;
    if (const std::string suffix = LowerSuffix(file); suffix == ".pvd")
    {
      for (const TimeStep& step : ReadCollection(file))
      {
        parts.insert(parts.end(), step.parts.begin(), step.parts.end());
      }
    }
    else if (suffix == ".pvtu")
    {
      parts = ReadPieces({ file, {} });
    }
    for (const GridPart& part : parts)
    {
      const std::vector<std::string> behind = WithFilesBehind({ part.file });
      all.insert(all.end(), behind.begin(), behind.end());
    }
  }
  return all;
}

std::string LinesOf(const PictureTexts& texts)
{
  std::string all;
  for (const auto& [key, text] : texts)
  {
    all.append(all.empty() ? "" : "\n").append(key).append(": ").append(text);
  }
  return all;
}
} // namespace pixelexact
