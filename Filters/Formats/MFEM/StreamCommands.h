// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/TextScanner.h"

// What stands around the data in a GLVis stream.
namespace pixelexact::mfem
{
/// Takes the word before the mesh and says whether a grid function follows the mesh. Throws
/// Unsupported for streams of several processes and quadrature functions, InvalidData for what is
/// no stream.
bool ReadStreamKeyword(TextScanner& scanner);

/// Takes what follows the data: commands to GLVis. Throws Unsupported where another mesh or grid
/// function follows, InvalidData for numbers.
void SkipCommands(TextScanner& scanner);
} // namespace pixelexact::mfem
