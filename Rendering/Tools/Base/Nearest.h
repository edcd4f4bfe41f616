// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
/// The name that a word was meant to be: one that goes on from it, or differs in a third of its
/// letters at most. Empty: none.
std::string NearestOf(const std::vector<std::string>& names, const std::string& word);

/// "; did you mean NAME?", or nothing.
std::string Suggestion(const std::vector<std::string>& names, const std::string& word);
} // namespace pixelexact
