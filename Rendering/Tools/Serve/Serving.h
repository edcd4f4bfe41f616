// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
struct RenderOptions;

/// Options of serve besides those of render.
struct ServingOptions
{
  std::string address; ///< empty: 127.0.0.1
  int port = 0;
  int views = 0;
  bool untilInputEnds = false; ///< the end of standard input is as SIGTERM
};

/// Reads the input, prints the page's address to stdout, and serves it until the process gets
/// SIGINT or SIGTERM, or its input ends. `words`: of the command line, from PrepareWords. Throws
/// UsageError and Error as render, and Error where it cannot listen, or the program was built
/// without the page.
void Serve(
  RenderOptions options, const ServingOptions& serving, const std::vector<std::string>& words);
} // namespace pixelexact
