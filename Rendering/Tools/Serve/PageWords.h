// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

// Changes of a command line by a page. No option whose value names a file can be changed.
namespace pixelexact
{
/// The words of serve that describe the picture: without those of the server and of files that
/// render writes. `words`: from PrepareWords.
[[nodiscard]] std::vector<std::string> WordsOfPicture(const std::vector<std::string>& words);

/// The words without those that only a saved figure has, as its title.
[[nodiscard]] std::vector<std::string> WithoutFigure(const std::vector<std::string>& words);

/// Replaces the option, or removes it where there is no value; of an option that may be repeated,
/// the first one is replaced. A surface replaces the first one of its kind; where there is none, it
/// replaces all surfaces and the settings of layers. Throws UsageError for an option that pages
/// cannot change, and for a value that is a file or too costly.
[[nodiscard]] std::vector<std::string> WithOption(const std::vector<std::string>& words,
  const std::string& option, const std::optional<std::string>& value);

/// Options and values of the words, for a page: text, or true for a flag. Of several, the first.
[[nodiscard]] nlohmann::ordered_json OptionsOf(const std::vector<std::string>& words);
} // namespace pixelexact
