// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Sample.h"
#include "Core/Math/Vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pixelexact
{
/// The buffers that a frame may hold; a set is a bitwise OR.
enum class Buffer : std::uint32_t
{
  None = 0,
  Value = 1U << 0,
  Position = 1U << 1,
  Normal = 1U << 2,
  Xi = 1U << 3,
  Element = 1U << 4,
  Depth = 1U << 5,
  Verdict = 1U << 6,
  Color = 1U << 7,
  Coverage = 1U << 8,  ///< Owners and Coverage together
  Enclosure = 1U << 9, ///< the value's lower and upper bound
  Layer = 1U << 10,
  Piece = 1U << 11, ///< of surfaces made of pieces: the piece and its parameters
  Jump = 1U << 12,  ///< of values, where the surface crosses from element to element
  Volume = 1U << 13 ///< colour, opacity and error bound of a pixel with a volume
};
constexpr Buffer operator|(Buffer a, Buffer b)
{
  return static_cast<Buffer>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr Buffer Without(Buffer set, Buffer less)
{
  return static_cast<Buffer>(static_cast<std::uint32_t>(set) & ~static_cast<std::uint32_t>(less));
}
constexpr bool Has(Buffer set, Buffer wanted)
{
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(wanted)) != 0;
}

/// A pixel's verdict. It differs from a point's: a ray may hit nothing.
enum class PixelVerdict : std::uint8_t
{
  Nothing = 0, ///< no surface hit, or every hit proven outside the mesh
  Exact = 1,
  Unknown = 2
};

/// The verdicts as the buffer holds them.
inline constexpr auto kNothingPixel = static_cast<std::uint8_t>(PixelVerdict::Nothing);
inline constexpr auto kExactPixel = static_cast<std::uint8_t>(PixelVerdict::Exact);
inline constexpr auto kUnknownPixel = static_cast<std::uint8_t>(PixelVerdict::Unknown);

/// Coverage of samples without a hit within the mesh's bounds.
inline constexpr std::uint8_t kNotCovered = 255;
/// Layer of samples that show nothing.
inline constexpr std::uint8_t kNoLayer = 255;

/// Samples at the pixels' centres, at their corners, or elsewhere. Samples of a lattice are stored
/// row by row, lower-left first. Only requested buffers are allocated; the others are empty. A new
/// buffer needs a flag above, a member here, a row of BufferTable.h and a line of
/// TileHits::WriteSheet.
struct SampleBuffers
{
  int width = 0;
  int height = 0;
  std::vector<double> value;         ///< NaN where the verdict is not Exact
  std::vector<Vec3> position;        ///< NaN where the verdict is Nothing
  std::vector<Vec3> normal;          ///< of the cut-surface; NaN where the verdict is Nothing
  std::vector<Vec3> xi;              ///< NaN where the verdict is not Exact
  std::vector<std::int64_t> element; ///< mesh element, -1 none
  std::vector<double> depth;         ///< distance along the unit ray; infinite: nothing
  std::vector<std::uint8_t> verdict; ///< PixelVerdict
  /// Count of the hit's preimages in all elements, for the visible hit or else the last hit within
  /// the mesh's bounds; -1 if there is none. Only of the nearest sheet.
  std::vector<std::int32_t> owners;
  std::vector<std::uint8_t> coverage; ///< Coverage of the same hit, or kNotCovered
  /// An interval that is proven to contain the field's value at the position, including the error
  /// of the inverse map; infinite if nothing is proven, NaN if the verdict is not Exact.
  std::vector<double> valueLower;
  std::vector<double> valueUpper;
  std::vector<std::uint8_t> layer; ///< number of the scene's layer, or kNoLayer
  /// Piece and parameters that the surface reports (SurfacePoint); -1 and 0 if it reports none.
  std::vector<std::int32_t> piece;
  std::vector<double> pieceU;
  std::vector<double> pieceV;
  /// Written only by FindCutJumps; NaN where there is no jump.
  std::vector<double> jump;
  /// RGBA per sample, with straight alpha that includes the layer's opacity. Written by a
  /// pipeline's colours; 0 where nothing is drawn.
  std::vector<std::uint8_t> color;
  std::vector<Vec3> volumeColor;     ///< with the surfaces, premultiplied, 0 to 1
  std::vector<double> volumeOpacity; ///< 0 to 1
  /// Bounds the error of each of these four numbers, in levels of a byte; infinite: not proven.
  std::vector<double> volumeBound;
  /// The sheets behind the nearest one, seen through translucent layers, in order.
  std::vector<SampleBuffers> behind;

  /// Allocates the buffers `wanted`, in existing memory if possible, and frees all other buffers.
  void Allocate(Buffer wanted, int newWidth, int newHeight);
  /// There are samples, and they have all buffers of the set.
  [[nodiscard]] bool Holds(Buffer wanted) const;
  [[nodiscard]] std::size_t Size() const
  {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Counts of a frame's work, for reports and tests.
struct FrameCounters
{
  std::int64_t rays = 0;
  std::int64_t surfaceHits = 0; ///< that rays reached, on all sheets, also outside the mesh
  std::int64_t nothing = 0;     ///< centre samples by verdict
  std::int64_t exact = 0;
  std::int64_t unknown = 0;
  std::int64_t nonFinite = 0; ///< exact samples whose value is NaN or infinite
  /// Visible hits on all sheets with this HitStatus.
  std::int64_t numericHits = 0;
  std::int64_t undecidedHits = 0;
  std::int64_t cutOff = 0;   ///< rays with more than Sheets::kMax sheets
  PrecisionCheck floatCheck; ///< of centres and corners; empty if values are doubles
  double seconds = 0.0;
};

struct Frame
{
  int width = 0;
  int height = 0;
  SampleBuffers centres;           ///< width x height
  SampleBuffers corners;           ///< (width + 1) x (height + 1), if requested
  std::vector<std::uint8_t> color; ///< RGBA per pixel; empty: the centres' colours are the image
  FrameCounters counters;

  /// The image: RGBA per pixel, with straight alpha; empty without colours.
  [[nodiscard]] const std::vector<std::uint8_t>& Image() const
  {
    return color.empty() ? centres.color : color;
  }
};
} // namespace pixelexact
