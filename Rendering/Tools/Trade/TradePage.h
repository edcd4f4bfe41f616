// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
/// The contents of report.html. Pictures are data URLs.
struct TradePage
{
  struct Pictures
  {
    std::string name;
    std::string picture;
    std::string errors;
  };
  std::string facts; ///< these are HTML
  std::string table;
  std::string orders;
  std::string recommendation; ///< these are text
  std::string command;
  std::string pareto;
  std::string convergence;
  std::string truth;
  std::vector<Pictures> pictures;
};

/// A page that needs no other file and no network.
[[nodiscard]] std::string ToHtml(const TradePage& page);

[[nodiscard]] std::string ForHtml(const std::string& text);
/// The data URL of a file, "data:image/png;base64,...". Throws Error where it cannot be read.
[[nodiscard]] std::string DataAddressOf(const std::string& file);
} // namespace pixelexact
