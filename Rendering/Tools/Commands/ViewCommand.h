// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Command.h"

#include <functional>
#include <memory>

namespace pixelexact
{
struct RenderOptions;

/// The command view with render's options, for the tool and for the program of its window.
/// `perform` is done where the command line names it.
void AddViewOptions(CLI::App& program, const std::shared_ptr<RenderOptions>& options,
  Action& action, const Action& perform);
} // namespace pixelexact
