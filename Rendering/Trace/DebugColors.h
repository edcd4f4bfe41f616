// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Validity.h"
#include "Trace/ColorMapping.h"

#include <span>
#include <string_view>

// Pictures of the mesh's and the answers' soundness in the place of the field's. Fixed colours that
// stay apart for the colour-blind (M. Okabe, K. Ito, Color Universal Design, 2008).
namespace pixelexact
{
using Rgba = std::array<std::uint8_t, 4>;

/// What a colour stands for.
struct ColorMeaning
{
  std::string_view meaning;
  std::string_view name;
  Rgba color;
};

/// Each pixel by how often the mesh covers the point seen: no element, once, twice, more often,
/// undecided. Pixels without a hit within the mesh's bounds stay transparent.
class CoverageColors final : public FrameModule
{
public:
  static std::span<const ColorMeaning> Legend();
  [[nodiscard]] SampleNeeds Needs() const override;
  void Process(Frame& frame) const override;
};

/// Each pixel by its element's verdict: valid, inverted, undecided; Unknown pixels as in
/// ColorMapping.
class ValidityColors final : public FrameModule
{
public:
  static std::span<const ColorMeaning> Legend();
  /// One verdict per element of the mesh; those of elements that are not seen do not matter.
  explicit ValidityColors(std::vector<Validity> verdicts);
  [[nodiscard]] SampleNeeds Needs() const override;
  void Process(Frame& frame) const override;

private:
  std::vector<Validity> Verdicts;
};

/// Paints over a frame that has its colours: exact pixels whose enclosure does not decide their
/// colour, that is, whose value and both ends `map` does not give one and the same. The map must
/// lead growing values through colours without coming back to one. Values that are no finite
/// numbers are left as they are.
class UndecidedColors final : public FrameModule
{
public:
  UndecidedColors(ColorMap map, const Rgba& color);
  [[nodiscard]] SampleNeeds Needs() const override;
  void Process(Frame& frame) const override;

  /// Which pixels these are, one flag per pixel.
  [[nodiscard]] std::vector<std::uint8_t> Find(const Frame& frame) const;

private:
  ColorMap Map;
  Rgba Color;
};
} // namespace pixelexact
