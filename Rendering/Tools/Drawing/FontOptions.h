// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Views/TextImages.h"

namespace pixelexact
{
/// The letters of figures and labels: --font.
class FontOptions
{
public:
  void AddTo(CLI::App& command);

  /// Throws Error where the file is no font that FreeType reads.
  void Check() const;

  [[nodiscard]] const FontChoice& Choice() const { return Font; }

private:
  FontChoice Font;
};
} // namespace pixelexact
