// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace pixelexact
{
// Files: see OutputFile.

/// The mark in pictures that names the program.
inline constexpr const char* kPictureMark = "PixelExact " PIXELEXACT_VERSION;

/// The bytes of a .vti with the frame's buffers, and with Contour where `contours` has verdicts.
/// Only those in `arrays`; all where it is empty. `file`: for messages. Throws Error where encoding
/// fails.
std::string EncodeBuffers(const std::string& file, const std::vector<std::string>& arrays,
  const Frame& frame, std::span<const std::int64_t> sourceCells,
  std::span<const std::uint8_t> contours);

/// Writes an image, compressed and inline. Throws Error when the file cannot be written.
void WriteImage(const std::string& file, vtkImageData* image);

/// Writes polylines, compressed and inline. Throws Error when the file cannot be written.
void WriteLines(const std::string& file, vtkPolyData* lines);
} // namespace pixelexact
