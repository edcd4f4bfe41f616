// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Provenance.h"
#include "Picture/RenderReport.h"

#include <string>

namespace pixelexact
{
/// The default name of an input's picture: the input's name, in the current folder. Throws
/// UsageError where the input's name gives none, or where a file of that name exists that this
/// program did not write.
std::string PictureNamedAfter(const std::string& input, const std::string& ending = {});

class DrawnShot;
class Stopwatch;
struct RenderOptions;
struct Shot;

/// Key of the text of DescribeFiles among a picture's texts.
inline constexpr const char* kSourceText = "Source";

/// The bytes of a picture's file, in the format of its suffix: the picture alone, or in a figure,
/// which names its sources. `texts`: further texts of the file; if kSourceText is among them, the
/// inputs are not read for their hashes. Stages: "provenance", "figure", "encode". Throws Error.
std::string EncodePicture(const RenderOptions& options, const DrawnShot& drawn,
  const std::string& file, const RepeatedCommand& command, Stopwatch& watch,
  const PictureTexts& texts = {});

/// The bytes of the file of --buffers. Throws as EncodeBuffers.
std::string EncodeBuffersOf(
  const RenderOptions& options, const Shot& shot, const DrawnShot& drawn, const std::string& file);
} // namespace pixelexact
