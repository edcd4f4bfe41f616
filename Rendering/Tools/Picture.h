// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Provenance.h"

#include "Trace/Frame.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkPolyData;

namespace pixelexact
{
/// In the files of WritePng, as the program that made them.
inline constexpr const char* kPictureMark = "PixelExact " PIXELEXACT_VERSION;

/// Files: see OutputFile. Writes RGB pixels, lower left first, and texts that describe them. Throws
/// Error when the file cannot be written.
void WritePng(const std::string& file, int width, int height, const std::vector<std::uint8_t>& rgb,
  const PictureTexts& texts = {});

/// Writes the buffers that the frame holds, and Contour, where `contours` has verdicts, of these
/// names; none: all. Throws Error when the file
/// cannot be written.
void WriteBuffers(const std::string& file, const std::vector<std::string>& arrays,
  const Frame& frame, std::span<const std::int64_t> sourceCells,
  std::span<const std::uint8_t> contours);

/// Writes polylines, compressed and inline. Throws Error when the file cannot be written.
void WriteLines(const std::string& file, vtkPolyData* lines);
} // namespace pixelexact
