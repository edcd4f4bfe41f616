// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace CLI
{
class App;
} // namespace CLI

// Texts that are generated from the options.
namespace pixelexact
{
/// The completion of a shell, "bash" or "zsh", the manual's page, "man", or the reference of
/// options, "markdown". Throws UsageError for another name.
std::string GeneratedText(const CLI::App& program, const std::string& what);
} // namespace pixelexact
