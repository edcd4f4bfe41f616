// SPDX-License-Identifier: BSD-3-Clause
// Lit colours against the model that VTK's documentation gives.
#include "Core/Math/Mat.h"
#include "LightModel.h"
#include "MeshBuilder.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr Buffer kLit = Buffer::Verdict | Buffer::Position | Buffer::Normal | Buffer::Layer;

Vec3 MakeDirection(Random& random)
{
  return glm::normalize(Vec3(random(), random(), random()) + Vec3(1e-3));
}

/// Samples anywhere in a cube, with normals in any direction and colours.
SampleBuffers RandomSamples(Random& random, int count)
{
  SampleBuffers samples;
  samples.Allocate(kLit, count, 1);
  for (std::size_t i = 0; i < samples.Size(); ++i)
  {
    samples.verdict[i] = kExactPixel;
    samples.layer[i] = 0;
    samples.position[i] = Vec3(random(), random(), random());
    samples.normal[i] = MakeDirection(random);
    for (int c = 0; c < 4; ++c)
    {
      samples.color.push_back(static_cast<std::uint8_t>(random(0.0, 256.0)));
    }
  }
  return samples;
}

LitView RandomView(Random& random)
{
  LitView view;
  view.direction = MakeDirection(random);
  view.eye = 3.0 * MakeDirection(random) - 2.0 * view.direction;
  view.parallel = random() < 0.0;
  if (random() < 0.0)
  {
    view.linear = Mat3(Vec3(2.0, 0.1, 0.0), Vec3(0.0, 0.5, -0.2), Vec3(0.3, 0.0, random(0.7, 4.0)));
    view.offset = 0.3 * MakeDirection(random);
  }
  return view;
}

Material RandomMaterial(Random& random)
{
  Material material;
  material.ambient = random(0.0, 0.3);
  material.diffuse = random(0.0, 1.0);
  material.specular = random(0.0, 1.0);
  material.specularPower = random(1.0, 60.0);
  material.specularColor = Vec3(random(0.0, 1.0), random(0.0, 1.0), 1.0);
  return material;
}

enum class Kind
{
  LoneHeadlight,
  Headlights,
  Parallel,
  Positional,
  Cone,
  LonePositionalHeadlight,
  None
};

std::vector<Light> RandomLights(Kind kind, Random& random)
{
  std::vector<Light> lights;
  const int lone = kind == Kind::LoneHeadlight || kind == Kind::LonePositionalHeadlight ? 1 : 2;
  for (int k = 0; kind != Kind::None && k < lone; ++k)
  {
    Light light;
    light.headlight = kind == Kind::LoneHeadlight || kind == Kind::Headlights ||
      kind == Kind::LonePositionalHeadlight;
    light.positional =
      kind == Kind::Positional || kind == Kind::Cone || kind == Kind::LonePositionalHeadlight;
    light.direction = MakeDirection(random);
    // A cone is to hold many of the samples.
    light.position = (kind == Kind::Cone ? -3.0 : 2.5) * light.direction;
    light.color = Vec3(random(0.0, 0.7), random(0.0, 0.7), random(0.0, 0.7));
    light.attenuation = Vec3(random(0.2, 1.0), random(0.0, 0.3), random(0.0, 0.1));
    light.coneAngle = kind == Kind::Cone ? random(10.0, 89.0) : random(90.0, 180.0);
    light.exponent = random(0.0, 5.0);
    lights.push_back(light);
  }
  return lights;
}

class Lights : public ::testing::TestWithParam<std::pair<const char*, Kind>>
{
};
} // namespace

TEST_P(Lights, ShineAsTheirModelSays)
{
  Random random(71);
  int compared = 0;
  int dark = 0;
  for (int repeat = 0; repeat < 60; ++repeat)
  {
    const auto lights = RandomLights(GetParam().second, random);
    const LitView view = RandomView(random);
    const Material material = RandomMaterial(random);
    SampleBuffers samples = RandomSamples(random, 120);
    const SampleBuffers before = samples;
    // All but the first and the last.
    Lighting({ material }, lights, view).Paint(samples, 1, samples.Size() - 1);
    for (std::size_t i = 0; i < samples.Size(); ++i)
    {
      const std::uint8_t* from = &before.color[4 * i];
      const std::uint8_t* to = &samples.color[4 * i];
      EXPECT_EQ(to[3], from[3]);
      if (i == 0 || i + 1 == samples.Size())
      {
        EXPECT_TRUE(std::equal(from, from + 4, to));
        continue;
      }
      const LongVec3 color{ from[0] / 255.0L, from[1] / 255.0L, from[2] / 255.0L };
      const auto lit = Lit(material, lights, view, color, before.position[i], before.normal[i]);
      if (!lit)
      {
        continue;
      }
      ++compared;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto wanted = static_cast<double>(255 * std::clamp((*lit)[c], 0.0L, 1.0L));
        // Far from the highlight, VTK's value is slightly above zero.
        EXPECT_NEAR(to[c], wanted, 0.51) << repeat << " " << i;
        dark += wanted < 40.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 7000);
  EXPECT_GT(dark, 100);
  EXPECT_LT(dark, 20000);
}

INSTANTIATE_TEST_SUITE_P(Lighting, Lights,
  ::testing::Values(std::pair("LoneHeadlight", Kind::LoneHeadlight),
    std::pair("Headlights", Kind::Headlights), std::pair("Parallel", Kind::Parallel),
    std::pair("Positional", Kind::Positional), std::pair("Cone", Kind::Cone),
    std::pair("LonePositionalHeadlight", Kind::LonePositionalHeadlight),
    std::pair("None", Kind::None)),
  [](const auto& test) { return std::string(test.param.first); });

TEST(Lighting, LayersAreLitOrNot)
{
  Random random(5);
  SampleBuffers samples = RandomSamples(random, 300);
  for (std::size_t i = 0; i < samples.Size(); ++i)
  {
    samples.layer[i] = static_cast<std::uint8_t>(i % 3);
  }
  const SampleBuffers before = samples;
  const std::vector<Light> lights = RandomLights(Kind::Parallel, random);
  const std::vector<std::optional<Material>> materials{ RandomMaterial(random), std::nullopt,
    RandomMaterial(random) };
  const Lighting lighting(materials, lights, {});
  EXPECT_EQ(lighting.Needs(), kLit);
  EXPECT_EQ(Lighting({ materials[0] }, lights, {}).Needs(),
    Buffer::Verdict | Buffer::Position | Buffer::Normal);
  lighting.Paint(samples, 0, samples.Size());
  int changed = 0;
  for (std::size_t i = 0; i < samples.Size(); ++i)
  {
    const std::uint8_t* from = &before.color[4 * i];
    const std::uint8_t* to = &samples.color[4 * i];
    if (i % 3 == 1)
    {
      EXPECT_TRUE(std::equal(from, from + 4, to));
      continue;
    }
    const LongVec3 color{ from[0] / 255.0L, from[1] / 255.0L, from[2] / 255.0L };
    const auto lit =
      Lit(*materials[i % 3], lights, {}, color, before.position[i], before.normal[i]);
    ASSERT_TRUE(lit);
    for (std::size_t c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(to[c], static_cast<double>(255 * std::clamp((*lit)[c], 0.0L, 1.0L)), 0.51);
    }
    changed += std::equal(from, from + 4, to) ? 0 : 1;
  }
  EXPECT_GT(changed, 150);
}

TEST(Lighting, WhatCannotBeLitKeepsItsColour)
{
  Random random(9);
  for (const Kind kind : { Kind::LoneHeadlight, Kind::Parallel, Kind::Cone, Kind::None })
  {
    SampleBuffers samples = RandomSamples(random, 5);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    samples.verdict[0] = static_cast<std::uint8_t>(PixelVerdict::Unknown);
    samples.verdict[1] = static_cast<std::uint8_t>(PixelVerdict::Nothing);
    samples.normal[2] = Vec3(kNan);
    samples.normal[3] = Vec3(0.0);
    samples.normal[4].z = kNan;
    const std::vector<std::uint8_t> before = samples.color;
    // Half of their light were they lit.
    const Lighting lighting({ Material{ .ambient = 0.5, .diffuse = 0.0, .specular = 0.0 } },
      RandomLights(kind, random), {});
    lighting.Paint(samples, 0, samples.Size());
    EXPECT_EQ(samples.color, before) << static_cast<int>(kind);
  }
}
} // namespace pixelexact::testing
