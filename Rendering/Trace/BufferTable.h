// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <limits>
#include <tuple>

// The properties of each buffer, for code that visits all of them: allocation, tiles, progressive
// frames, images for VTK, the tool. TileHits::WriteSheet writes the buffers.
namespace pixelexact
{
template <class T>
struct BufferRow
{
  Buffer buffer;
  const char* name; ///< of the point array in VTK images
  std::vector<T> SampleBuffers::*member;
  T nothing;  ///< value of samples that show nothing
  bool usual; ///< written to files by default
};
template <class T>
BufferRow(Buffer, const char*, std::vector<T> SampleBuffers::*, T, bool) -> BufferRow<T>;

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// In the order of the arrays of VTK images.
inline constexpr std::tuple kBufferTable{
  BufferRow{ Buffer::Value, "Value", &SampleBuffers::value, kNotANumber, true },
  BufferRow{ Buffer::Position, "Position", &SampleBuffers::position, Vec3(kNotANumber), true },
  BufferRow{ Buffer::Normal, "Normal", &SampleBuffers::normal, Vec3(kNotANumber), true },
  BufferRow{ Buffer::Xi, "Xi", &SampleBuffers::xi, Vec3(kNotANumber), true },
  BufferRow{ Buffer::Element, "Element", &SampleBuffers::element, std::int64_t{ -1 }, true },
  BufferRow{
    Buffer::Depth, "Depth", &SampleBuffers::depth, std::numeric_limits<double>::infinity(), true },
  BufferRow{ Buffer::Verdict, "Verdict", &SampleBuffers::verdict, kNothingPixel, true },
  BufferRow{ Buffer::Coverage, "Owners", &SampleBuffers::owners, std::int32_t{ -1 }, false },
  BufferRow{ Buffer::Coverage, "Coverage", &SampleBuffers::coverage, kNotCovered, false },
  BufferRow{ Buffer::Enclosure, "Value_lower", &SampleBuffers::valueLower, kNotANumber, false },
  BufferRow{ Buffer::Enclosure, "Value_upper", &SampleBuffers::valueUpper, kNotANumber, false },
  BufferRow{ Buffer::Layer, "Layer", &SampleBuffers::layer, kNoLayer, true },
  BufferRow{ Buffer::Piece, "Piece", &SampleBuffers::piece, std::int32_t{ -1 }, false },
  BufferRow{ Buffer::Piece, "Piece_u", &SampleBuffers::pieceU, 0.0, false },
  BufferRow{ Buffer::Piece, "Piece_v", &SampleBuffers::pieceV, 0.0, false },
  BufferRow{ Buffer::Jump, "Jump", &SampleBuffers::jump, kNotANumber, false },
  BufferRow{ Buffer::Volume, "VolumeColor", &SampleBuffers::volumeColor, Vec3(0.0), false },
  BufferRow{ Buffer::Volume, "VolumeOpacity", &SampleBuffers::volumeOpacity, 0.0, false },
  BufferRow{ Buffer::Volume, "VolumeBound", &SampleBuffers::volumeBound,
    std::numeric_limits<double>::infinity(), false },
};

/// Calls visit(row) for each row of the table.
template <class Visit>
constexpr void ForEachBuffer(const Visit& visit)
{
  std::apply([&](const auto&... row) { (visit(row), ...); }, kBufferTable);
}

/// The buffers that are written to files by default.
constexpr Buffer UsualBuffers()
{
  Buffer usual = Buffer::None;
  ForEachBuffer([&](const auto& row) { usual = row.usual ? usual | row.buffer : usual; });
  return usual;
}
} // namespace pixelexact
