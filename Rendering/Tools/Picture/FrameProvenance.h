// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
struct CommonOptions;
struct RenderOptions;

/// What an animation's pictures are made of: the bytes of the inputs and of options' files, this
/// program, and the words that change pictures. Throws Error for a file that cannot be read.
std::string ProvenanceOf(const RenderOptions& options, const CommonOptions& common);
/// Of one of the pictures.
std::string HashOf(const std::string& provenance, int frame, int frames);
/// Whether a picture is there that says so.
bool IsThere(const std::string& file, const std::string& hash);
} // namespace pixelexact
