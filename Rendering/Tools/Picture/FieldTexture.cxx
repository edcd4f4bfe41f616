// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FieldTexture.h"

#include "Scene/Shot.h"

#include "Trace/Modules/LineConvolution.h"

#include <cmath>

namespace pixelexact
{
void FieldTexture::AddTo(CLI::App& command)
{
  Bind(command, "--lic", Name);
  Bind(command, "--lic-length", HalfLength);
  Bind(command, "--lic-strength", Strength);
}

FoundTexture FieldTexture::Apply(const Shot& shot, Frame& frame) const
{
  const pixelexact::Field& field = VectorField(*shot.input.model, "--lic", Name);
  const ConvolvedNoise noise =
    ConvolveNoise(shot.scene, shot.view, frame.width, frame.height, field, HalfLength);
  FoundTexture found{ field.name, 0, noise.samples };
  std::vector<std::uint8_t>& image = frame.color.empty() ? frame.centres.color : frame.color;
  for (std::size_t i = 0; i < noise.values.size(); ++i)
  {
    if (std::isnan(noise.values[i]))
    {
      continue;
    }
    ++found.pixels;
    const double part = 1.0 - Strength * (1.0 - noise.values[i]);
    for (std::size_t c = 0; c < 3; ++c)
    {
      image[4 * i + c] = static_cast<std::uint8_t>(std::lround(part * image[4 * i + c]));
    }
  }
  return found;
}
} // namespace pixelexact
