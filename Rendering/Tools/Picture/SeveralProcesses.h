// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

// What several processes do not do together.
namespace pixelexact
{
struct RenderOptions;

/// Throws UsageError where there are several: `what` is for one process.
void RefuseSeveralProcesses(const std::string& what);

/// The same for options of render that ask for more of the mesh than surfaces meet.
void CheckForSeveralProcesses(const RenderOptions& options);
} // namespace pixelexact
