// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Provenance.h"
#include "Picture/RenderReport.h"

#include <string>

namespace pixelexact
{
/// The picture of an input where none is named: as the input, in the current folder. Throws
/// UsageError where the input's name tells none, or where a file of that name is there that this
/// program did not write.
std::string PictureNamedAfter(const std::string& input, const std::string& ending = {});

class DrawnShot;
class Stopwatch;
struct RenderOptions;
struct Shot;

/// What DescribeFiles tells of the inputs, among a picture's texts.
inline constexpr const char* kSourceText = "Source";

/// The bytes of a picture's file, of the format that its name says: the picture alone, or with a
/// figure around it, which says where it comes from. `told`: what else it says of itself; with
/// kSourceText the inputs are not read for it. Stages: "provenance", "figure", "encode". Throws
/// Error.
std::string EncodePicture(const RenderOptions& options, const DrawnShot& drawn,
  const std::string& file, const RepeatedCommand& command, Stopwatch& watch,
  const PictureTexts& told = {});

/// The bytes of the file of --buffers. Throws as EncodeBuffers.
std::string EncodeBuffersOf(
  const RenderOptions& options, const Shot& shot, const DrawnShot& drawn, const std::string& file);
} // namespace pixelexact
