// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Mat.h"
#include "LongVectors.h"

#include "Trace/Modules/Lighting.h"

#include <numbers>

// VTK's lights, from its documentation, in long double.
namespace pixelexact::testing
{
inline LongVec3 Linear(const Mat3& m, const LongVec3& x)
{
  // Columns of m.
  return Plus(
    Times(x[0], ToLong(m[0])), Plus(Times(x[1], ToLong(m[1])), Times(x[2], ToLong(m[2]))));
}

/// A direction that is across all that the surface's tangents are mapped to.
inline LongVec3 MappedNormal(const Mat3& m, const LongVec3& normal)
{
  const LongVec3 other = std::fabs(normal[0]) < 0.6L * std::sqrt(Dot(normal, normal))
    ? LongVec3{ 1, 0, 0 }
    : LongVec3{ 0, 1, 0 };
  const LongVec3 s = Cross(normal, other);
  const LongVec3 t = Cross(normal, s);
  return Unit(Cross(Linear(m, s), Linear(m, t)));
}

/// The colour of one sample: ambient + diffuse n.l + specular (r.v)^power of each light. Nothing
/// where rounding decides what it is.
inline std::optional<LongVec3> Lit(const Material& material, const std::vector<Light>& lights,
  const LitView& view, const LongVec3& color, const Vec3& at, const Vec3& given)
{
  const LongVec3 x = Plus(Linear(view.linear, ToLong(at)), ToLong(view.offset));
  LongVec3 n = MappedNormal(view.linear, ToLong(given));
  const LongVec3 toEye = Unit(Minus(ToLong(view.eye), x));
  const LongVec3 back = Times(-1, ToLong(view.direction));
  const long double facing = Dot(n, view.parallel ? back : toEye);
  if (std::fabs(facing) < 1e-9L)
  {
    return std::nullopt;
  }
  n = facing < 0 ? Times(-1, n) : n;
  LongVec3 lit = Times(material.ambient, color);
  for (const Light& light : lights)
  {
    LongVec3 toLight = Times(-1, ToLong(light.direction));
    long double strength = 1;
    if (light.positional)
    {
      const LongVec3 way = Minus(ToLong(light.position), x);
      const long double d = std::sqrt(Dot(way, way));
      toLight = Times(1 / d, way);
      strength = 1 / (light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d);
      if (light.coneAngle < 90)
      {
        const long double within = -Dot(toLight, ToLong(light.direction));
        const long double edge = std::cos(light.coneAngle * std::numbers::pi_v<long double> / 180);
        if (std::fabs(within - edge) < 1e-9L)
        {
          return std::nullopt;
        }
        strength *= within < edge ? 0 : std::pow(within, static_cast<long double>(light.exponent));
      }
    }
    else if (light.headlight)
    {
      toLight = back;
    }
    const long double diffuse = Dot(n, toLight);
    if (std::fabs(diffuse) < 1e-9L)
    {
      return std::nullopt;
    }
    if (diffuse < 0)
    {
      continue;
    }
    // The way that mirrored light leaves.
    const LongVec3 mirrored = Minus(Times(2 * diffuse, n), toLight);
    const bool alone = lights.size() == 1 && light.headlight && !light.positional;
    const long double along = alone ? diffuse : Dot(mirrored, toEye);
    const long double specular =
      std::pow(std::max(0.0L, along), static_cast<long double>(material.specularPower));
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto axis = static_cast<int>(c);
      const long double incoming = strength * light.color[axis];
      lit[c] += incoming *
        (material.diffuse * diffuse * color[c] +
          material.specular * specular * material.specularColor[axis]);
    }
  }
  return lit;
}
} // namespace pixelexact::testing
