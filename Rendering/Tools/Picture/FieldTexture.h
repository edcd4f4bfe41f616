// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Trace/Frame.h"
#include "Trace/Pipeline.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pixelexact
{
struct Shot;

/// The texture of a picture.
struct FoundTexture
{
  std::string field;
  std::int64_t pixels = 0;  ///< that have it
  std::int64_t samples = 0; ///< number of evaluated vectors
  /// Darkens the colours of the surfaces that are nearest to the viewer. Belongs after lights.
  std::shared_ptr<const SampleColors> colors;
};

/// A texture of a vector field's directions over the colours of the visible surfaces, by line
/// integral convolution: --lic. Of translucent surfaces the nearest ones have it.
class FieldTexture
{
public:
  void AddTo(CLI::App& command);
  [[nodiscard]] bool IsAsked() const { return !Name.empty(); }
  [[nodiscard]] const std::string& Field() const { return Name; }
  /// The buffers of centres that Find reads.
  [[nodiscard]] Buffer Needs() const;

  /// Throws Error where the model has no such field, or it has neither 2 nor 3 components.
  [[nodiscard]] FoundTexture Find(const Shot& shot, const Frame& frame) const;

private:
  std::string Name;
  int HalfLength = 0;
  double Strength = 0.0;
};
} // namespace pixelexact
