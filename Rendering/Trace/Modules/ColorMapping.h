// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Pipeline.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace pixelexact
{
using Rgba = std::array<std::uint8_t, 4>;

/// Maps values, including NaN, to straight RGBA bytes. Called from several threads at once.
using ColorMap = std::function<void(std::span<const double> values, std::uint8_t* rgba)>;

/// One colour for every value.
[[nodiscard]] ColorMap SolidColor(const Rgba& color);

/// Divides the range into `bands` (at least 1) parts of equal width or, with `logarithmic`, of
/// equal ratio. All values of a part get the colour of its middle. Values outside the range get the
/// colour of the first or last part. Values that are not finite, or have no logarithm, get their
/// colour from `map`.
[[nodiscard]] ColorMap InBands(
  ColorMap map, const std::array<double, 2>& range, int bands, bool logarithmic);

/// A colour table that applies to any range of values.
class ColorTable
{
public:
  virtual ~ColorTable() = default;

  /// Throws Error for an invalid range.
  [[nodiscard]] virtual ColorMap Over(const std::array<double, 2>& range) const = 0;
  /// Colours depend on the logarithm of values, which must be positive.
  [[nodiscard]] virtual bool IsLogarithmic() const = 0;
  /// All colours are opaque.
  [[nodiscard]] virtual bool IsOpaque() const = 0;
  /// The range of a rule that finds no values.
  [[nodiscard]] virtual std::array<double, 2> RangeOfNothing() const = 0;
  /// Both tables give the same colours.
  [[nodiscard]] virtual bool IsSame(const ColorTable& other) const = 0;
};

/// Colours of a layer.
struct LayerColors
{
  ColorMap map;
  Rgba unknown{ 255, 0, 255, 255 }; ///< of samples whose verdict is Unknown
  double opacity = 1.0;             ///< of the layer, 0 to 1
  /// False: the map gives one colour, so values need not be computed.
  bool readsValues = true;
};

/// The colour mapping module (paper, section 5.2): an exact sample gets the colour of its value, an
/// Unknown one the colour `unknown`; others stay transparent.
class ColorMapping final : public SampleColors
{
public:
  /// One appearance for all layers.
  explicit ColorMapping(ColorMap map, const Rgba& unknown = { 255, 0, 255, 255 });
  /// One entry per layer of the scene.
  explicit ColorMapping(std::vector<LayerColors> layers);

  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

private:
  /// Paints consecutive samples with one verdict on one layer.
  void PaintRun(SampleBuffers& samples, std::size_t begin, std::size_t end) const;
  static void PaintExact(
    const LayerColors& layer, SampleBuffers& samples, std::size_t begin, std::size_t count);

  std::vector<LayerColors> Layers;
};
} // namespace pixelexact
