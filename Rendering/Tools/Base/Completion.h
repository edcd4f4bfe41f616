// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace CLI
{
class App;
} // namespace CLI

// Texts that are made of the options that there are.
namespace pixelexact
{
/// The completion of a shell, "bash" or "zsh", or the manual's page, "man". Throws UsageError for
/// another name.
std::string GeneratedText(const CLI::App& program, const std::string& what);
} // namespace pixelexact
