// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Validity.h"
#include "Trace/Modules/ColorMapping.h"

#include <span>
#include <string_view>

// Pictures of the mesh's validity and of the results' reliability in place of the field. The fixed
// colours differ for colour-blind readers (M. Okabe, K. Ito, Color Universal Design, 2008).
namespace pixelexact
{
/// Legend entry of a colour.
struct ColorMeaning
{
  std::string_view meaning;
  std::string_view name;
  Rgba color;
};

/// Colours each sample by the number of elements that contain its point: none, one, two, more,
/// undecided. Samples without a hit within the mesh's bounds stay transparent.
class CoverageColors final : public SampleColors
{
public:
  static std::span<const ColorMeaning> Legend();
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;
};

/// Colours each sample by its element's verdict: valid, inverted, undecided; Unknown samples as in
/// ColorMapping.
class ValidityColors final : public SampleColors
{
public:
  static std::span<const ColorMeaning> Legend();
  /// One verdict per element of the mesh; verdicts of invisible elements are not read.
  explicit ValidityColors(std::vector<Validity> verdicts);
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

private:
  std::vector<Validity> Verdicts;
};

/// Colours each sample by the jump between its element and neighbours (FindCutJumps): pale grey off
/// elements' faces, light blue where values are continuous, else from yellow for small jumps to
/// dark purple for the largest; Unknown samples as in ColorMapping.
class JumpColors final : public SampleColors
{
public:
  static std::span<const ColorMeaning> Legend();
  /// `largest`: the jump that gets the last colour.
  explicit JumpColors(double largest)
    : Largest(largest)
  {
  }
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

  /// The colours of jumps from 0 to the largest.
  [[nodiscard]] ColorMap Map() const;

private:
  [[nodiscard]] Rgba ColorOf(double jump) const;

  double Largest;
};

/// Paints over exact samples whose colour their enclosure does not prove: the layer's map gives the
/// value and both ends of the enclosure more than one colour. Along growing values, maps must not
/// return to an earlier colour. Values that are not finite are not painted. Belongs after lights.
class UndecidedColors final : public SampleColors
{
public:
  /// `maps`: by layer, one for each layer of the scene, or one for all.
  UndecidedColors(std::vector<ColorMap> maps, const Rgba& color);
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

  /// Count of painted samples.
  [[nodiscard]] std::int64_t Count(const SampleBuffers& samples) const;

private:
  /// Calls visit(i) for each sample of [begin, end) whose colour is not proven.
  template <class Visit>
  void Find(
    const SampleBuffers& samples, std::size_t begin, std::size_t end, const Visit& visit) const;

  std::vector<ColorMap> Maps;
  Rgba Color;
};
} // namespace pixelexact
