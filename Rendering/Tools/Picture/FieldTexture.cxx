// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FieldTexture.h"

#include "Scene/Shot.h"

#include "Trace/Modules/LineConvolution.h"
#include "Trace/Projection.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
/// Samples farther than this many pixels from the surface point of their pixel belong to another
/// surface.
constexpr double kSameSurface = 6.0;

/// Darkens samples by the texture of the pixel in which they are.
class TextureColors final : public SampleColors
{
public:
  TextureColors(const Shot& shot, const Frame& frame, std::vector<float> noise, double strength)
    : Pixels(shot.view, frame.width, frame.height)
    , Forward(AxesOf(shot.view).forward)
    , Eye(shot.view.position)
    , Width(frame.width)
    , Height(frame.height)
    , Places(frame.centres.position)
    , Noise(std::move(noise))
    , Strength(strength)
  {
  }

  [[nodiscard]] Buffer Needs() const override { return Buffer::Position | Buffer::Verdict; }

  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      // Values without a number keep the colour that says so.
      const bool hasColor = samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
        (samples.value.empty() || !std::isnan(samples.value[i]));
      if (const float noise = hasColor ? NoiseAt(samples.position[i]) : 1.0F; noise < 1.0F)
      {
        const double part = 1.0 - Strength * (1.0 - noise);
        for (std::size_t c = 0; c < 3; ++c)
        {
          samples.color[4 * i + c] =
            static_cast<std::uint8_t>(std::lround(part * samples.color[4 * i + c]));
        }
      }
    }
  }

private:
  /// 1 where there is no texture.
  [[nodiscard]] float NoiseAt(const Vec3& x) const
  {
    const auto at = Pixels.Of(x);
    if (!at || !(at->at[0] >= 0.0 && at->at[1] >= 0.0 && at->at[0] < Width && at->at[1] < Height))
    {
      return 1.0F;
    }
    const std::size_t pixel =
      static_cast<std::size_t>(at->at[1]) * static_cast<std::size_t>(Width) +
      static_cast<std::size_t>(at->at[0]);
    const double length = Pixels.PixelAt(glm::dot(x - Eye, Forward));
    const bool isHere = std::fabs(glm::dot(x - Places[pixel], Forward)) < kSameSurface * length;
    return std::isnan(Noise[pixel]) || !isHere ? 1.0F : Noise[pixel];
  }

  Projection Pixels;
  Vec3 Forward;
  Vec3 Eye;
  int Width;
  int Height;
  std::vector<Vec3> Places; ///< of the nearest surface, by pixel
  std::vector<float> Noise;
  double Strength;
};
} // namespace

void FieldTexture::AddTo(CLI::App& command)
{
  Bind(command, "--lic", Name);
  Bind(command, "--lic-length", HalfLength);
  Bind(command, "--lic-strength", Strength);
}

Buffer FieldTexture::Needs() const
{
  return IsAsked() ? Buffer::Position | Buffer::Verdict : Buffer::None;
}

FoundTexture FieldTexture::Find(const Shot& shot, const Frame& frame) const
{
  const pixelexact::Field& field = VectorField(*shot.input.model, "--lic", Name);
  ConvolvedNoise noise =
    ConvolveNoise(shot.scene, shot.view, frame.width, frame.height, field, HalfLength);
  FoundTexture found{ field.name, 0, noise.samples, nullptr };
  found.pixels =
    std::ranges::count_if(noise.values, [](float value) { return !std::isnan(value); });
  found.colors = std::make_shared<TextureColors>(shot, frame, std::move(noise.values), Strength);
  return found;
}
} // namespace pixelexact
