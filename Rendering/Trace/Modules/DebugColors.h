// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Validity.h"
#include "Trace/Modules/ColorMapping.h"

#include <span>
#include <string_view>

// Pictures of the mesh's and the answers' soundness in the place of the field's. Fixed colours that
// stay apart for the colour-blind (M. Okabe, K. Ito, Color Universal Design, 2008).
namespace pixelexact
{
/// What a colour stands for.
struct ColorMeaning
{
  std::string_view meaning;
  std::string_view name;
  Rgba color;
};

/// Each sample by how often the mesh covers the point seen: no element, once, twice, more often,
/// undecided. Samples without a hit within the mesh's bounds stay transparent.
class CoverageColors final : public SampleColors
{
public:
  static std::span<const ColorMeaning> Legend();
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;
};

/// Each sample by its element's verdict: valid, inverted, undecided; Unknown ones as in
/// ColorMapping.
class ValidityColors final : public SampleColors
{
public:
  static std::span<const ColorMeaning> Legend();
  /// One verdict per element of the mesh; those of elements that are not seen do not matter.
  explicit ValidityColors(std::vector<Validity> verdicts);
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

private:
  std::vector<Validity> Verdicts;
};

/// Each sample by the jump between its element and the next ones (FindCutJumps): pale grey where
/// there is no element's face, light blue where the values are continuous, else from yellow for
/// small jumps to dark purple for the largest; Unknown ones as in ColorMapping.
class JumpColors final : public SampleColors
{
public:
  static std::span<const ColorMeaning> Legend();
  /// `largest`: the jump with the last colour.
  explicit JumpColors(double largest)
    : Largest(largest)
  {
  }
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

private:
  [[nodiscard]] Rgba ColorOf(double jump) const;

  double Largest;
};

/// Paints over samples that have their colours: exact ones whose enclosure does not decide their
/// colour, that is, whose value and both ends the layer's map does not give one and the same. Maps
/// must lead growing values through colours without coming back to one. Values that are no finite
/// numbers are left as they are. Belongs after lights.
class UndecidedColors final : public SampleColors
{
public:
  /// `maps`: by layer, as many as the scene has, or one for all.
  UndecidedColors(std::vector<ColorMap> maps, const Rgba& color);
  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

  /// How many of the samples were painted.
  [[nodiscard]] std::int64_t Count(const SampleBuffers& samples) const;

private:
  /// visit(i) for each sample of [begin, end) whose colour is not decided.
  template <class Visit>
  void Find(
    const SampleBuffers& samples, std::size_t begin, std::size_t end, const Visit& visit) const;

  std::vector<ColorMap> Maps;
  Rgba Color;
};
} // namespace pixelexact
