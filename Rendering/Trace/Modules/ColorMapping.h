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

/// Values to straight RGBA bytes. Called from several threads at once, with NaN among the values.
using ColorMap = std::function<void(std::span<const double> values, std::uint8_t* rgba)>;

/// One colour for every value.
[[nodiscard]] ColorMap SolidColor(const Rgba& color);

/// Divides the range into `bands` (at least 1) parts of equal width, with `logarithmic` of equal
/// ratio, and gives all values of a part the colour of its middle. Values outside of the range get
/// the colours of the first and the last part; values that are not finite, or have no logarithm,
/// those of `map`.
[[nodiscard]] ColorMap InBands(
  ColorMap map, const std::array<double, 2>& range, int bands, bool logarithmic);

/// The colours of values, for any range of them.
class ColorTable
{
public:
  virtual ~ColorTable() = default;

  /// Throws Error for a range that the table cannot have.
  [[nodiscard]] virtual ColorMap Over(const std::array<double, 2>& range) const = 0;
  /// Whether colours are by the logarithm of values, which are above 0 then.
  [[nodiscard]] virtual bool IsLogarithmic() const = 0;
  /// Whether all of its colours are opaque.
  [[nodiscard]] virtual bool IsOpaque() const = 0;
  /// The range where a rule is of values and none are seen.
  [[nodiscard]] virtual std::array<double, 2> RangeOfNothing() const = 0;
  /// Whether the other one gives the same colours.
  [[nodiscard]] virtual bool IsSame(const ColorTable& other) const = 0;
};

/// How a layer is coloured.
struct LayerColors
{
  ColorMap map;
  Rgba unknown{ 255, 0, 255, 255 }; ///< of samples whose verdict is Unknown
  double opacity = 1.0;             ///< of all of it, 0 to 1
  /// False: the map gives one colour, and there need be no values.
  bool readsValues = true;
};

/// The colour mapping module (paper, section 5.2): each exact sample gets the colour of its own
/// value; those whose verdict is Unknown the unknown one; the rest stays transparent.
class ColorMapping final : public SampleColors
{
public:
  /// All layers alike.
  explicit ColorMapping(ColorMap map, const Rgba& unknown = { 255, 0, 255, 255 });
  /// Layer by layer, as many as the scene has.
  explicit ColorMapping(std::vector<LayerColors> layers);

  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

private:
  /// Of samples with the same verdict, on the same layer.
  void PaintRun(SampleBuffers& samples, std::size_t begin, std::size_t end) const;
  static void PaintExact(
    const LayerColors& layer, SampleBuffers& samples, std::size_t begin, std::size_t count);

  std::vector<LayerColors> Layers;
};
} // namespace pixelexact
