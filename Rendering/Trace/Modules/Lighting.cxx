// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/Lighting.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact
{
namespace
{
/// What reaches a point, in parts of the light's colour.
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
} // namespace

Lighting::Lighting(
  std::vector<std::optional<Material>> materials, std::vector<Light> lights, const LitView& view)
  : Materials(std::move(materials))
  , Lights(std::move(lights))
  , View(view)
  , NormalMatrix(glm::transpose(glm::inverse(view.linear)))
{
}

Buffer Lighting::Needs() const
{
  return Buffer::Verdict | Buffer::Position | Buffer::Normal |
    (Materials.size() > 1 ? Buffer::Layer : Buffer::None);
}

void Lighting::Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
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
    std::uint8_t* rgb = &samples.color[4 * i];
    const Vec3 color(rgb[0], rgb[1], rgb[2]);
    const Vec3 normal = glm::normalize(NormalMatrix * samples.normal[i]);
    const Vec3 lit =
      Lit(*material, color / 255.0, View.linear * samples.position[i] + View.offset, normal);
    // What has no normal would be in the dark.
    if (!std::isfinite(lit.x + lit.y + lit.z) || !std::isfinite(normal.x + normal.y + normal.z))
    {
      continue;
    }
    for (int c = 0; c < 3; ++c)
    {
      rgb[c] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(lit[c], 0.0, 1.0)));
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
    // A power costs as much as all else.
    if (material.specular == 0.0)
    {
      continue;
    }
    // VTK looks from the eye also where its rays are parallel, and along them by a lone headlight.
    const double mirrored =
      headlightAlone ? falling : -glm::dot(glm::reflect(direction, facing), fromEye);
    specular += strength * std::pow(std::max(1e-5, mirrored), material.specularPower) * light.color;
  }
  return material.ambient * material.ambientColor.value_or(color) +
    material.diffuse * diffuse * color + material.specular * specular * material.specularColor;
}
} // namespace pixelexact
