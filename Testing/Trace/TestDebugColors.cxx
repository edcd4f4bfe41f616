// SPDX-License-Identifier: BSD-3-Clause
// Pictures of soundness, on one layer and on several.
#include "FrameCheck.h"
#include "LayeredScene.h"
#include "SheetCheck.h"

#include "Core/Location/Owners.h"
#include "Trace/Modules/DebugColors.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr Rgba kMagenta{ 255, 0, 255, 255 };
constexpr Rgba kNone{ 0, 0, 0, 0 };
constexpr Rgba kOnce{ 168, 212, 240, 255 };
constexpr Rgba kTwice{ 230, 159, 0, 255 };
constexpr Rgba kMore{ 213, 60, 0, 255 };
constexpr Rgba kGrey{ 64, 64, 64, 255 };

/// 1 from `step` on, 0 below.
ColorMap Step(double step)
{
  return [step](std::span<const double> values, std::uint8_t* rgba)
  {
    for (const double v : values)
    {
      const std::uint8_t level = v >= step ? 1 : 0;
      rgba = std::ranges::copy(Rgba{ level, level, level, 255 }, rgba).out;
    }
  };
}

/// Two straight cubes, [-1, 0.5] and [-0.5, 1] along x: they overlap.
class Overlap
{
public:
  Overlap()
  {
    for (const long double from : { -1.0L, -0.5L })
    {
      const Space space = UniformSpace(Shape::Hexahedron, 1);
      Elements.Add(space,
        [from](const LongVec3& xi) -> LongVec3 {
          return { from + 0.75L * (1 + xi[0]), xi[1], xi[2] };
        });
      Values.Add(space, [](const LongVec3& xi, long double* u) { u[0] = xi[1]; });
    }
    field_ = { "u", Values.View() };
    locator_ = std::make_unique<Locator>(Elements.View());
    scene_.locator = locator_.get();
  }

  Field field_;
  Scene scene_;

private:
  MeshBuilder Elements;
  ExpansionBuilder Values{ 1 };
  std::unique_ptr<Locator> locator_;
};
} // namespace

TEST(DebugColors, UndecidedOnesByTheirLayersMap)
{
  SampleBuffers samples;
  samples.Allocate(Buffer::Value | Buffer::Verdict | Buffer::Enclosure | Buffer::Layer, 9, 1);
  const auto set = [&](std::size_t i, std::uint8_t layer, double lower, double value, double upper)
  {
    samples.verdict[i] = kExactPixel;
    samples.layer[i] = layer;
    samples.value[i] = value;
    samples.valueLower[i] = lower;
    samples.valueUpper[i] = upper;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  // The first layer's colours change at 1, the second one's at 2.
  set(0, 0, 0.9, 0.95, 1.0);   // undecided: from 1 on it is another
  set(1, 0, 0.9, 0.95, 0.999); // decided
  set(2, 1, 0.9, 1.0, 1.1);    // decided there
  set(3, 1, 1.9, 2.0, 2.1);    // undecided
  set(4, 0, 1.9, 2.0, 2.1);    // decided here
  set(5, 1, -kInfinity, 5.0, kInfinity);
  set(6, 0, kNan, kNan, kNan);
  set(7, 0, 0.9, 0.95, 1.1);
  samples.verdict[7] = static_cast<std::uint8_t>(PixelVerdict::Unknown);
  set(8, 1, 2.0, 2.0, 2.1); // decided
  samples.color.assign(36, 9);
  const Rgba paint{ 1, 2, 3, 4 };
  const UndecidedColors both({ Step(1.0), Step(2.0) }, paint);
  EXPECT_TRUE(Has(both.Needs(), Buffer::Layer));
  EXPECT_EQ(both.Count(samples), 3);
  both.Paint(samples, 0, 9);
  for (std::size_t i = 0; i < 9; ++i)
  {
    const bool undecided = i == 0 || i == 3 || i == 5;
    EXPECT_EQ(ColorAt(samples.color, i), undecided ? paint : (Rgba{ 9, 9, 9, 9 })) << i;
  }
  // The layers share one map.
  const UndecidedColors one({ Step(1.0) }, paint);
  EXPECT_FALSE(Has(one.Needs(), Buffer::Layer));
  EXPECT_EQ(one.Count(samples), 3);
  samples.color.assign(36, 9);
  one.Paint(samples, 1, 9);
  for (std::size_t i = 0; i < 9; ++i)
  {
    EXPECT_EQ(ColorAt(samples.color, i), i == 2 || i == 5 ? paint : (Rgba{ 9, 9, 9, 9 })) << i;
  }
}

/// Enclosures are some roundings wide: what they leave open is close to the maps' steps.
TEST(DebugColors, UndecidedOnesOfAFrame)
{
  Block block;
  const Field& flat = block.Add(1, [](const LongVec3& x, long double* u) { u[0] = x[2]; });
  Scene& scene = block.WithPlane({ 0.0, 0.0, 0.25 }, { 0.0, 0.0, 1.0 });
  block.WithPlane({ 0.0, 0.0, -0.25 }, { 0.0, 0.0, 1.0 });
  for (Layer& layer : scene.layers)
  {
    layer.field = &flat;
    layer.translucent = true;
  }
  const Rgba paint{ 1, 2, 3, 255 };
  const Camera camera = ViewAlongZ(20, 20, 0.9);
  for (const auto& [first, second] :
    { std::pair(0.25, -0.25), std::pair(0.25, 0.0), std::pair(0.2, -0.25), std::pair(-0.25, 0.25) })
  {
    const ColorMapping colors(
      std::vector<LayerColors>{ { Step(first), kMagenta }, { Step(second), kMagenta } });
    const UndecidedColors undecided({ Step(first), Step(second) }, paint);
    const Frame frame = Trace(scene, camera, { { &colors, &undecided }, {} });
    const auto sheets = SheetsOf(frame.centres);
    ASSERT_EQ(sheets.size(), 2U);
    // The layer's value is its map's step, or far from it.
    const std::array open{ first == 0.25, second == -0.25 };
    for (std::size_t k = 0; k < 2; ++k)
    {
      EXPECT_EQ(undecided.Count(*sheets[k]), open[k] ? 400 : 0) << k;
      for (std::size_t i = 0; i < 400; ++i)
      {
        EXPECT_EQ(ColorAt(sheets[k]->color, i) == paint, open[k]);
      }
    }
  }
}

TEST(DebugColors, CoverageOfWhatIsSeen)
{
  const Overlap mesh;
  const CoverageColors colors;
  // The view is oblique, so that points behind a pixel's point have another coverage.
  CameraView view;
  view.position = { 4.003, 0.002, 3.0 };
  view.parallel = true;
  view.parallelScale = 1.25;
  const Camera camera(view, 40, 40);
  const auto expected = [&](std::size_t i, const std::vector<double>& planes)
  {
    const LongRay ray = RayThrough(view, 40, 40, static_cast<long double>(i % 40) + 0.5L,
      static_cast<long double>(i / 40) + 0.5L);
    for (const double z : planes)
    {
      const LongVec3 x =
        Plus(ray.origin, Times((z - ray.origin[2]) / ray.direction[2], ray.direction));
      if (Largest(x) <= 1)
      {
        return std::fabs(x[0]) < 0.5L ? kTwice : kOnce;
      }
    }
    return kNone;
  };
  struct Case
  {
    std::vector<double> planes; ///< falling
    bool translucent;
  };
  const std::vector<Case> cases{ { { 0.0 }, false }, { { 2.0, 0.3, 0.0 }, false },
    { { 0.9, 0.3, -0.5 }, true }, { { 1.5, 0.8, -0.7 }, true } };
  for (const auto& [planes, translucent] : cases)
  {
    Scene scene = mesh.scene_;
    for (const double z : planes)
    {
      scene.layers.push_back({ std::make_shared<Plane>(Vec3(0.0, 0.0, z), Vec3(0.0, 0.0, 1.0)),
        &mesh.field_, 0, Precision::Double, translucent });
    }
    std::ranges::rotate(scene.layers, scene.layers.begin() + 1);
    const Frame frame = Trace(scene, camera, { { &colors }, {} }, { .centres = Buffer::Verdict });
    std::array<int, 3> seen{};
    for (std::size_t i = 0; i < frame.centres.Size(); ++i)
    {
      const Rgba wanted = expected(i, planes);
      ASSERT_EQ(ColorAt(frame.centres.color, i), wanted) << planes.size() << " " << i;
      EXPECT_EQ(ColorAt(frame.Image(), i), wanted);
      const int owners = wanted == kNone ? 0 : wanted == kOnce ? 1 : 2;
      EXPECT_EQ(frame.centres.owners[i], owners == 0 ? -1 : owners);
      ++seen.at(static_cast<std::size_t>(owners));
    }
    EXPECT_GT(std::ranges::min(seen), 100);
  }

  // Every kind of coverage.
  SampleBuffers samples;
  samples.Allocate(Buffer::Coverage, 6, 1);
  const std::array kinds{ std::pair(Coverage::None, 0), std::pair(Coverage::Once, 1),
    std::pair(Coverage::Several, 2), std::pair(Coverage::Several, 3),
    std::pair(Coverage::Undecided, 1) };
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    samples.coverage[i] = static_cast<std::uint8_t>(kinds[i].first);
    samples.owners[i] = kinds[i].second;
  }
  samples.color.assign(24, 9);
  colors.Paint(samples, 0, 6);
  const std::array wanted{ kGrey, kOnce, kTwice, kMore, kMagenta, kNone };
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    EXPECT_EQ(ColorAt(samples.color, i), wanted[i]) << i;
  }
}

TEST(DebugColors, ValidityOfTheElementSeen)
{
  const LayeredScene scene(false);
  // Told apart by number.
  std::vector<Validity> verdicts;
  std::vector<Rgba> wanted;
  for (int e = 0; e < 8; ++e)
  {
    verdicts.push_back(std::array{ Validity::Valid, Validity::Inverted, Validity::Undecided }.at(
      static_cast<std::size_t>(e % 3)));
    wanted.push_back(
      std::array{ kOnce, kMore, Rgba{ 240, 228, 66, 255 } }.at(static_cast<std::size_t>(e % 3)));
  }
  const ValidityColors colors(verdicts);
  const Frame frame = Trace(scene.scene_, Camera(ObliqueView(), 50, 40), { { &colors }, {} });
  std::array<int, 8> seen{};
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    const std::int64_t element = frame.centres.element[i];
    if (element < 0)
    {
      EXPECT_EQ(ColorAt(frame.Image(), i), kNone);
      continue;
    }
    ++seen.at(static_cast<std::size_t>(element));
    EXPECT_EQ(ColorAt(frame.Image(), i), wanted.at(static_cast<std::size_t>(element)));
  }
  EXPECT_GE(std::ranges::count_if(seen, [](int pixels) { return pixels > 20; }), 4);
  SampleBuffers samples;
  samples.Allocate(colors.Needs(), 2, 1);
  samples.verdict[1] = static_cast<std::uint8_t>(PixelVerdict::Unknown);
  samples.element[1] = 3;
  samples.color.assign(8, 9);
  colors.Paint(samples, 0, 2);
  EXPECT_EQ(ColorAt(samples.color, 0), kNone);
  EXPECT_EQ(ColorAt(samples.color, 1), kMagenta);
}

TEST(DebugColors, JumpsFromYellowToPurple)
{
  const JumpColors colors(4.0);
  SampleBuffers samples;
  samples.Allocate(colors.Needs(), 6, 1);
  samples.jump = { std::nan(""), 0.0, 1e-9, 2.0, 4.0, 1.0 };
  samples.verdict.assign(6, kExactPixel);
  samples.verdict[5] = kUnknownPixel;
  samples.color.assign(24, 9);
  colors.Paint(samples, 0, 6);
  const std::array wanted{ Rgba{ 225, 225, 225, 255 }, kOnce, Rgba{ 240, 228, 66, 255 }, kMore,
    Rgba{ 75, 0, 80, 255 }, kMagenta };
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    EXPECT_EQ(ColorAt(samples.color, i), wanted[i]) << i;
  }
  samples.verdict.assign(6, kNothingPixel);
  colors.Paint(samples, 0, 6);
  EXPECT_EQ(ColorAt(samples.color, 4), kNone);
}
} // namespace pixelexact::testing
