// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Pipeline.h"

#include "Core/Math/Mat.h"

#include <optional>
#include <vector>

namespace pixelexact
{
/// A light; all members have the meaning of vtkLight's, in the lit space.
struct Light
{
  bool positional = false; ///< else its rays are parallel
  bool headlight = false;  ///< follows the view direction
  Vec3 position{ 0.0 };
  Vec3 direction{ 0.0, 0.0, -1.0 }; ///< of its rays, or of its cone's axis; of unit length
  Vec3 color{ 1.0 };                ///< times its intensity
  Vec3 attenuation{ 1.0, 0.0, 0.0 };
  double coneAngle = 90.0; ///< degrees; 90 and more: no cone
  double exponent = 1.0;   ///< of the falloff within the cone

  bool operator==(const Light&) const = default;
};

/// A light whose rays are parallel.
struct ParallelLight
{
  Vec3 direction;
  Vec3 color;
};

/// Reflection of light by a surface; all members have the meaning of vtkProperty's.
struct Material
{
  double ambient = 0.0;
  double diffuse = 1.0;
  double specular = 0.0;
  double specularPower = 1.0;
  Vec3 specularColor{ 1.0 };
  std::optional<Vec3> ambientColor = {}; ///< none: the sample's own

  bool operator==(const Material&) const = default;
};

/// The camera, and the transformation to the space of lights.
struct LitView
{
  Vec3 eye{ 0.0 };                  ///< the camera's position
  Vec3 direction{ 0.0, 0.0, -1.0 }; ///< of the view, unit length
  bool parallel = false;
  Mat3 linear{ 1.0 }; ///< from the samples' space to that of eye and lights
  Vec3 offset{ 0.0 };

  bool operator==(const LitView&) const = default;
};

/// Lights colours by the surface's exact normals, as VTK lights polygons: both sides alike, with
/// diffuse light in the sample's colour. Belongs after the colour map. Samples that are not Exact
/// keep their colours.
class Lighting final : public SampleColors
{
public:
  /// `materials`: by layer; none: the layer is not lit.
  Lighting(
    std::vector<std::optional<Material>> materials, std::vector<Light> lights, const LitView& view);

  [[nodiscard]] Buffer Needs() const override;
  void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const override;

private:
  void PaintOne(const Material& material, SampleBuffers& samples, std::size_t i) const;
  [[nodiscard]] Vec3 Lit(
    const Material& material, const Vec3& color, const Vec3& position, const Vec3& normal) const;

  std::vector<std::optional<Material>> Materials;
  std::vector<Light> Lights;
  std::vector<ParallelLight> Parallel; ///< the lights that are parallel
  LitView View;
  Mat3 NormalMatrix;
};
} // namespace pixelexact
