// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/PaperRuns.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace pixelexact
{
/// Writes paper.csv, errors.csv where there are errors, and a plot of each figure into a folder,
/// which it makes. Throws Error where that is not possible.
void WritePaper(const std::string& folder, const PaperResults& results);

/// Prints all results with the numbers in the paper's text and captions.
void PrintPaper(const PaperResults& results);
nlohmann::ordered_json ToJson(const PaperResults& results);
} // namespace pixelexact
