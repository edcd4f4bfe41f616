// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Sample.h"
#include "Core/Math/Vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pixelexact
{
/// The buffers that a frame may hold; a set of them is an OR.
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
  Piece = 1U << 11, ///< of a surface that is made of pieces: which one, and where on it
  Jump = 1U << 12   ///< of the values, where the surface crosses between elements
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
  Nothing = 0, ///< no surface hit, or every hit proven outside of the mesh
  Exact = 1,
  Unknown = 2
};

/// The same as the verdict buffer holds them.
inline constexpr auto kNothingPixel = static_cast<std::uint8_t>(PixelVerdict::Nothing);
inline constexpr auto kExactPixel = static_cast<std::uint8_t>(PixelVerdict::Exact);
inline constexpr auto kUnknownPixel = static_cast<std::uint8_t>(PixelVerdict::Unknown);

/// In the coverage buffer: no hit within the mesh's bounds.
inline constexpr std::uint8_t kNotCovered = 255;
/// In the layer buffer: nothing seen.
inline constexpr std::uint8_t kNoLayer = 255;

/// What is seen at some samples: the pixels' centres, their corners, or others. Those of a lattice
/// lie lower-left first, row by row. Only the buffers asked for are allocated; the others are
/// empty. A new buffer is a flag above, a member here, a row of BufferTable.h
/// and a line of TileHits::WriteSheet.
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
  /// Preimages of the hit in all elements: of the hit that is seen, where none is, of the last one
  /// within the mesh's bounds; -1 where there is none. Of the nearest sheet alone.
  std::vector<std::int32_t> owners;
  std::vector<std::uint8_t> coverage; ///< Coverage of the same hit, or kNotCovered
  /// An interval that is proven to hold the field's value at the position, the error of the inverse
  /// map included; infinite where nothing is proven, NaN where the verdict is not Exact.
  std::vector<double> valueLower;
  std::vector<double> valueUpper;
  std::vector<std::uint8_t> layer; ///< number of the scene's layer, or kNoLayer
  /// What the surface tells (SurfacePoint::piece, parameters): -1 and 0 where it tells nothing.
  std::vector<std::int32_t> piece;
  std::vector<double> pieceU;
  std::vector<double> pieceV;
  /// Written by FindCutJumps alone; NaN where there is none.
  std::vector<double> jump;
  /// RGBA per sample, straight alpha, its layer's opacity included; made by the colours of a
  /// pipeline, 0 where nothing is drawn.
  std::vector<std::uint8_t> color;
  /// What is seen through translucent layers: the next samples of the rays, sheet by sheet.
  std::vector<SampleBuffers> behind;

  /// In the memory that is there, as far as it goes; that of other buffers is given back.
  void Allocate(Buffer wanted, int newWidth, int newHeight);
  /// Whether there are samples, with all buffers of the set.
  [[nodiscard]] bool Holds(Buffer wanted) const;
  [[nodiscard]] std::size_t Size() const
  {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// What a frame did, for reports and tests.
struct FrameCounters
{
  std::int64_t rays = 0;
  std::int64_t surfaceHits = 0; ///< that rays came to, outside of the mesh and on all sheets, too
  std::int64_t nothing = 0;     ///< centre samples by verdict
  std::int64_t exact = 0;
  std::int64_t unknown = 0;
  std::int64_t nonFinite = 0; ///< exact samples whose value is NaN or infinite
  /// Hits seen, on all sheets, of which the surface says so (HitStatus).
  std::int64_t numericHits = 0;
  std::int64_t undecidedHits = 0;
  std::int64_t cutOff = 0;   ///< rays with more sheets than are kept
  PrecisionCheck floatCheck; ///< of centres and corners; no points where values are doubles
  double seconds = 0.0;
};

struct Frame
{
  int width = 0;
  int height = 0;
  SampleBuffers centres;           ///< width x height
  SampleBuffers corners;           ///< (width + 1) x (height + 1), where asked for
  std::vector<std::uint8_t> color; ///< RGBA per pixel; empty where the centres' is the image
  FrameCounters counters;

  /// The image: RGBA per pixel, straight alpha; empty where nothing gave it colours.
  [[nodiscard]] const std::vector<std::uint8_t>& Image() const
  {
    return color.empty() ? centres.color : color;
  }
};
} // namespace pixelexact
