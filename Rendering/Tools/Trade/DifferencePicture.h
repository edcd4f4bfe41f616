// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Drawing/ImageFile.h"

#include "Trace/Compare/FieldDifference.h"

#include <array>
#include <span>
#include <string>

namespace pixelexact
{
class DifferenceOptions;
struct Shot;
struct ShotOptions;

/// The colours of a difference. The map extends equally to both sides of 0, for norms from their
/// minimum, unless range and map are given. Pixels in which only one solution has a value have
/// other colours, shown beside the bar.
class DifferencePicture
{
public:
  /// `size`: of the picture with its figure. `field`: the other one's name. Paints the frame.
  /// Throws Error as ShotAppearance.
  DifferencePicture(const ShotOptions& options, const Shot& shot, const std::string& field,
    FieldDifference& difference);

  [[nodiscard]] const std::array<double, 2>& Range() const { return range_; }

  /// The file's bytes, in the format of its suffix. Throws Error.
  [[nodiscard]] std::string Encode(
    const DifferenceOptions& difference, const PictureTexts& texts, const std::string& file) const;

private:
  const ShotOptions& Options;
  const Shot& Of;
  const FieldDifference& Shown;
  std::string Other;
  std::array<double, 2> range_{};
};

/// Writes values, bounds, sides, positions and elements of the pixels. `firstCells`, `secondCells`:
/// the elements' numbers for users. Throws Error.
void WriteDifference(const std::string& file, const FieldDifference& difference,
  std::span<const std::int64_t> firstCells, std::span<const std::int64_t> secondCells);
} // namespace pixelexact
