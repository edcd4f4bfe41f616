// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
class DifferenceOptions;
struct CommonOptions;
struct ShotOptions;

/// compare --with: the picture of the difference of two solutions, or, with several, a folder with
/// one of each, and how they converge. `output`: picture or folder; empty: chosen. Throws
/// UsageError, Error.
void CompareSolutions(ShotOptions shot, const DifferenceOptions& difference,
  const std::string& output, const CommonOptions& common);
} // namespace pixelexact
