// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Text/TextScanner.h"

// What stands around the data in a GLVis stream.
namespace pixelexact::mfem
{
/// Which of how many processes a stream comes from.
struct StreamRank
{
  int processes = 1;
  int number = 0;
};

/// Whether a file that begins so is a stream, by its first word.
bool IsStream(std::string_view head);

/// Takes "parallel n i". `processes`: those of the streams before, 0 where there was none. Throws
/// InvalidData where they differ.
StreamRank ReadStreamRank(TextScanner& scanner, int processes);

/// Takes the word before the mesh and says whether a grid function follows the mesh. Throws
/// Unsupported for quadrature functions, InvalidData for what is no stream.
bool ReadStreamKeyword(TextScanner& scanner);

/// Takes what follows the data: commands to GLVis, up to the stream of another process where
/// `toNextProcess`. Throws Unsupported where another mesh or grid function follows, InvalidData for
/// numbers.
void SkipCommands(TextScanner& scanner, bool toNextProcess = false);
} // namespace pixelexact::mfem
