// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/Lighting.h"

#include "Core/Element/Kernels.h"
#include "Trace/Modules/LightKernels.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pixelexact
{
namespace
{
/// Light that reaches a point; strength is relative to the light's colour.
struct Incoming
{
  Vec3 direction; ///< from the light
  double strength;
};

Incoming LightAt(const Light& light, const LitView& view, const Vec3& x)
{
  if (light.headlight && !light.positional)
  {
    return { view.direction, 1.0 };
  }
  if (!light.positional)
  {
    return { light.direction, 1.0 };
  }
  const Vec3 way = x - light.position;
  const double distance = glm::length(way);
  const Vec3& k = light.attenuation;
  double strength = 1.0 / (k.x + distance * (k.y + distance * k.z));
  const Vec3 direction = distance > 0.0 ? way / distance : light.direction;
  if (light.coneAngle < 90.0)
  {
    const double along = glm::dot(direction, light.direction);
    const bool within = along >= std::cos(light.coneAngle * std::numbers::pi / 180.0);
    strength = within ? strength * std::pow(along, light.exponent) : 0.0;
  }
  return { direction, strength };
}

/// Converts a channel from [0, 1] to a byte.
std::uint8_t ByteOf(double channel)
{
  const double scaled = 255.0 * std::clamp(channel, 0.0, 1.0);
  const int whole = static_cast<int>(scaled);
  return static_cast<std::uint8_t>(whole + (scaled - whole >= 0.5 ? 1 : 0));
}

/// Samples of one material, as a structure of arrays.
struct Some
{
  static constexpr std::size_t kMax = 64;
  using Column = std::array<double, kMax + kLanePadding>;

  std::array<std::size_t, kMax> number;
  std::array<Column, 3> position;
  std::array<Column, 3> normal;
  std::array<Column, 3> color;
  Column isLit;
  std::size_t count = 0;

  void Add(const SampleBuffers& samples, std::size_t i)
  {
    for (int d = 0; d < 3; ++d)
    {
      const auto at = static_cast<std::size_t>(d);
      position[at][count] = samples.position[i][d];
      normal[at][count] = samples.normal[i][d];
      color[at][count] = samples.color[4 * i + at] / 255.0;
    }
    number[count++] = i;
  }
  /// Fills the last pack with copies of the last sample.
  void Pad()
  {
    for (std::array<Column, 3>* columns : { &position, &normal, &color })
    {
      for (Column& column : *columns)
      {
        std::fill_n(column.begin() + count, kLanePadding, column[count - 1]);
      }
    }
  }
};
} // namespace

Lighting::Lighting(
  std::vector<std::optional<Material>> materials, std::vector<Light> lights, const LitView& view)
  : Materials(std::move(materials))
  , Lights(std::move(lights))
  , View(view)
  , NormalMatrix(glm::transpose(glm::inverse(view.linear)))
{
  for (const Light& light : Lights)
  {
    if (!light.positional)
    {
      Parallel.push_back({ light.headlight ? View.direction : light.direction, light.color });
    }
  }
}

Buffer Lighting::Needs() const
{
  return Buffer::Verdict | Buffer::Position | Buffer::Normal |
    (Materials.size() > 1 ? Buffer::Layer : Buffer::None);
}

void Lighting::Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
  Some some;
  const Material* common = nullptr;
  const auto flush = [&]
  {
    if (some.count > 0)
    {
      some.Pad();
      const int count = static_cast<int>(some.count);
      const auto columns = [count](const auto& from) {
        return LanePoints{ { from[0].data(), from[1].data(), from[2].data() }, count };
      };
      GetLightKernels().shine({ View, NormalMatrix, *common, Parallel },
        { columns(some.position), columns(some.normal),
          { some.color[0].data(), some.color[1].data(), some.color[2].data() }, some.isLit.data(),
          count });
      for (std::size_t k = 0; k < some.count; ++k)
      {
        for (std::size_t c = 0; some.isLit[k] != 0.0 && c < 3; ++c)
        {
          samples.color[4 * some.number[k] + c] = ByteOf(some.color[c][k]);
        }
      }
      some.count = 0;
    }
  };
  for (std::size_t i = begin; i < end; ++i)
  {
    if (samples.verdict[i] != static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      continue;
    }
    const auto& material = Materials[Materials.size() > 1 ? samples.layer[i] : 0];
    if (!material)
    {
      continue;
    }
    if (Parallel.size() < Lights.size() || material->specular != 0.0)
    {
      PaintOne(*material, samples, i);
      continue;
    }
    if (some.count == Some::kMax || common != &*material)
    {
      flush();
      common = &*material;
    }
    some.Add(samples, i);
  }
  flush();
}

void Lighting::PaintOne(const Material& material, SampleBuffers& samples, std::size_t i) const
{
  std::uint8_t* rgb = &samples.color[4 * i];
  const Vec3 color(rgb[0], rgb[1], rgb[2]);
  const Vec3 normal = glm::normalize(NormalMatrix * samples.normal[i]);
  const Vec3 lit =
    Lit(material, color / 255.0, View.linear * samples.position[i] + View.offset, normal);
  // A sample without a normal keeps its colour; light would make it black.
  if (std::isfinite(lit.x + lit.y + lit.z) && std::isfinite(normal.x + normal.y + normal.z))
  {
    for (int c = 0; c < 3; ++c)
    {
      rgb[c] = ByteOf(lit[c]);
    }
  }
}

Vec3 Lighting::Lit(
  const Material& material, const Vec3& color, const Vec3& position, const Vec3& normal) const
{
  const Vec3 fromEye = glm::normalize(position - View.eye);
  const Vec3 facing =
    glm::dot(normal, View.parallel ? View.direction : fromEye) > 0.0 ? -normal : normal;
  const bool headlightAlone = Lights.size() == 1 && Lights[0].headlight && !Lights[0].positional;
  Vec3 diffuse(0.0);
  Vec3 specular(0.0);
  for (const Light& light : Lights)
  {
    const auto [direction, strength] = LightAt(light, View, position);
    const double falling = -glm::dot(facing, direction);
    if (!(falling > 0.0))
    {
      continue;
    }
    diffuse += strength * falling * light.color;
    // The power costs as much as all other terms.
    if (material.specular == 0.0)
    {
      continue;
    }
    // VTK takes the direction from the eye also for parallel projection, and the view direction for
    // a single headlight.
    const double mirrored =
      headlightAlone ? falling : -glm::dot(glm::reflect(direction, facing), fromEye);
    specular += strength * std::pow(std::max(1e-5, mirrored), material.specularPower) * light.color;
  }
  return material.ambient * material.ambientColor.value_or(color) +
    material.diffuse * diffuse * color + material.specular * specular * material.specularColor;
}
} // namespace pixelexact
