// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// What the name of an Exodus II file tells: "out.e", "out.e-s003" (the third mesh of an adaptive
/// run), "out.e.4.0", "out.e-s003.4.0" (the first of four parts that a parallel run wrote).
struct ExodusName
{
  std::string first;      ///< of the first mesh, whole: "out.e"
  int mesh = 1;           ///< counted from 1, as names count
  std::string meshSuffix; ///< "-s003"
  int parts = 0;          ///< 0: one file holds all
  std::string partsText;  ///< as in the name
  std::size_t digits = 0; ///< of a part's number
};

/// None: it is no such name. Upper and lower case are the same.
std::optional<ExodusName> ParseExodusName(const std::string& file);

/// Whether the name's end is no suffix by itself, "-s003" or ".4.0".
bool IsExodusPart(const std::string& file);

/// The files of this mesh. Throws Error that names the parts that are not there.
std::vector<std::string> PartsOf(const ExodusName& name);
} // namespace pixelexact
