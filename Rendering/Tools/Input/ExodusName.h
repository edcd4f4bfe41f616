// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The parts of an Exodus II file's name: "out.e", "out.e-s003" (the third mesh of an adaptive
/// run), "out.e.4.0", "out.e-s003.4.0" (the first of four parts that a parallel run wrote).
struct ExodusName
{
  std::string first;      ///< of the first mesh, whole: "out.e"
  int mesh = 1;           ///< counted from 1, as in names
  std::string meshSuffix; ///< "-s003"
  int parts = 0;          ///< 0: one file contains everything
  std::string partsText;  ///< text of the number of parts in the name
  std::size_t digits = 0; ///< of a part's number
};

/// Parses a name; none where it has another form. Upper and lower case are equivalent.
std::optional<ExodusName> ParseExodusName(const std::string& file);

/// Whether the name ends with "-s003" or ".4.0", which is not a suffix by itself.
bool IsExodusPart(const std::string& file);

/// The files of this mesh. Throws Error with the names of missing parts.
std::vector<std::string> PartsOf(const ExodusName& name);
} // namespace pixelexact
