// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/HitResults.h"

#include <limits>
#include <tuple>

// What there is to know of each buffer, for all who go through them: allocation, tiles, progressive
// frames, images for VTK, the tool.
namespace pixelexact
{
/// Which samples have an entry that is not `nothing`.
enum class Written
{
  Inside, ///< those whose verdict is Exact
  Held,   ///< these and the Unknown ones
  Apart   ///< written by who counts owners
};

template <class T, class Of>
struct BufferRow
{
  Buffer buffer;
  const char* name; ///< of the point array in images
  std::vector<T> SampleBuffers::*member;
  T nothing;
  Written written;
  bool usual; ///< among what is written to a file unasked
  Of of;      ///< of (results, i), where it is not written apart
};
template <class T, class Of>
BufferRow(Buffer, const char*, std::vector<T> SampleBuffers::*, T, Written, bool, Of)
  -> BufferRow<T, Of>;

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr auto kWrittenApart = [](const HitResults&, std::size_t) { return 0; };

/// In the order of an image's arrays.
inline constexpr std::tuple kBufferTable{
  BufferRow{ Buffer::Value, "Value", &SampleBuffers::value, kNotANumber, Written::Inside, true,
    [](const HitResults& hits, std::size_t i) { return hits.value[i]; } },
  BufferRow{ Buffer::Position, "Position", &SampleBuffers::position, Vec3(kNotANumber),
    Written::Held, true, [](const HitResults& hits, std::size_t i) { return hits.Position(i); } },
  BufferRow{ Buffer::Normal, "Normal", &SampleBuffers::normal, Vec3(kNotANumber), Written::Held,
    true, [](const HitResults& hits, std::size_t i) { return hits.Normal(i); } },
  BufferRow{ Buffer::Xi, "Xi", &SampleBuffers::xi, Vec3(kNotANumber), Written::Inside, true,
    [](const HitResults& hits, std::size_t i) { return hits.xi[i]; } },
  BufferRow{ Buffer::Element, "Element", &SampleBuffers::element, std::int64_t{ -1 }, Written::Held,
    true, [](const HitResults& hits, std::size_t i) { return std::int64_t{ hits.element[i] }; } },
  BufferRow{ Buffer::Depth, "Depth", &SampleBuffers::depth, std::numeric_limits<double>::infinity(),
    Written::Held, true, [](const HitResults& hits, std::size_t i) { return hits.t[i]; } },
  BufferRow{ Buffer::Verdict, "Verdict", &SampleBuffers::verdict,
    static_cast<std::uint8_t>(PixelVerdict::Nothing), Written::Held, true,
    [](const HitResults& hits, std::size_t i)
    {
      return static_cast<std::uint8_t>(
        hits.verdict[i] == Verdict::Inside ? PixelVerdict::Exact : PixelVerdict::Unknown);
    } },
  BufferRow{ Buffer::Coverage, "Owners", &SampleBuffers::owners, std::int32_t{ -1 }, Written::Apart,
    false, kWrittenApart },
  BufferRow{ Buffer::Coverage, "Coverage", &SampleBuffers::coverage, kNotCovered, Written::Apart,
    false, kWrittenApart },
  BufferRow{ Buffer::Enclosure, "Value_lower", &SampleBuffers::valueLower, kNotANumber,
    Written::Inside, false, [](const HitResults& hits, std::size_t i) { return hits.lower[i]; } },
  BufferRow{ Buffer::Enclosure, "Value_upper", &SampleBuffers::valueUpper, kNotANumber,
    Written::Inside, false, [](const HitResults& hits, std::size_t i) { return hits.upper[i]; } },
  BufferRow{ Buffer::Layer, "Layer", &SampleBuffers::layer, kNoLayer, Written::Held, true,
    [](const HitResults& hits, std::size_t) { return hits.layerNumber; } },
  BufferRow{ Buffer::Piece, "Piece", &SampleBuffers::piece, std::int32_t{ -1 }, Written::Inside,
    false, [](const HitResults& hits, std::size_t i) { return hits.Point(i).piece; } },
  BufferRow{ Buffer::Piece, "Piece_u", &SampleBuffers::pieceU, 0.0, Written::Inside, false,
    [](const HitResults& hits, std::size_t i) { return hits.Point(i).parameters[0]; } },
  BufferRow{ Buffer::Piece, "Piece_v", &SampleBuffers::pieceV, 0.0, Written::Inside, false,
    [](const HitResults& hits, std::size_t i) { return hits.Point(i).parameters[1]; } },
  BufferRow{
    Buffer::Jump, "Jump", &SampleBuffers::jump, kNotANumber, Written::Apart, false, kWrittenApart },
};

/// visit(row) for each row of the table.
template <class Visit>
constexpr void ForEachBuffer(const Visit& visit)
{
  std::apply([&](const auto&... row) { (visit(row), ...); }, kBufferTable);
}

/// What is written to a file unasked.
constexpr Buffer UsualBuffers()
{
  Buffer usual = Buffer::None;
  ForEachBuffer([&](const auto& row) { usual = row.usual ? usual | row.buffer : usual; });
  return usual;
}
} // namespace pixelexact
