// SPDX-License-Identifier: BSD-3-Clause
#include "LayeredScene.h"
#include "SheetCheck.h"

#include "Trace/Modules/ContourPlaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact::testing
{
namespace
{
constexpr int kSize = 200;
/// Half the view's height; a pixel is 0.0125 wide.
constexpr double kScale = 1.25;

/// A frame of the plane z = 0.1 by the block's field, and its contours.
struct Placed
{
  Placed(Block& block, const std::vector<double>& values)
    : scene(block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 }))
    , certifier(std::vector(1, values))
    , colors(SolidColor({ 255, 255, 255, 255 }))
    , frame(Trace(scene, camera, { { &colors }, { &certifier } }, { .centres = Buffer::Value }))
  {
  }
  [[nodiscard]] std::vector<ContourPlace> Labels(const LabelSize& size) const
  {
    return PlaceLabels(
      frame, camera, certifier, { std::vector(certifier.Values()[0].size(), size) }, false);
  }

  Scene& scene;
  Camera camera = ViewAlongZ(kSize, kSize, kScale);
  ContourCertifier certifier;
  ColorMapping colors;
  Frame frame;
};

LongVec3 MapToPlane(const glm::dvec2& at)
{
  return { (2 * at.x / kSize - 1) * kScale, (2 * at.y / kSize - 1) * kScale, 0.1 };
}
} // namespace

TEST(ContourPlaces, AreOnTheContourAndAlongIt)
{
  Block block;
  block.MakeCurved();
  const Placed placed(block, { 0.0, 1.0, 2.0, 4.0, 6.0 });
  const LabelSize size{ 24.0, 10.0 };
  const std::vector<ContourPlace> places = placed.Labels(size);
  EXPECT_GE(places.size(), 4U);
  for (const ContourPlace& place : places)
  {
    const double value = placed.certifier.Values()[0][place.value];
    const double angle = place.angle * std::numbers::pi / 180.0;
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    EXPECT_LE(std::fabs(place.angle), 90.0);
    // Along the text the contour is never farther from its middle line than a part of its height.
    for (const double part : { -0.5, -0.25, 0.0, 0.25, 0.5 })
    {
      const glm::dvec2 at = place.centre + part * size.width * along;
      const glm::dvec2 side = 0.2 * size.height * glm::dvec2(-along.y, along.x);
      const long double below = Block::CurvedAt(MapToPlane(at - side)) - value;
      const long double above = Block::CurvedAt(MapToPlane(at + side)) - value;
      EXPECT_LT(below * above, 0) << place.centre.x << " " << place.centre.y;
    }
    EXPECT_GT(std::min(place.centre.x, place.centre.y), 5.0);
    EXPECT_LT(std::max(place.centre.x, place.centre.y), kSize - 5.0);
    EXPECT_LT(
      std::max(std::fabs(MapToPlane(place.centre)[0]), std::fabs(MapToPlane(place.centre)[1])), 1);
  }
}

TEST(ContourPlaces, AreApart)
{
  Block block;
  block.MakeCurved();
  const Placed placed(block, { 0.0, 1.0, 2.0, 4.0, 6.0 });
  const std::vector<ContourPlace> places = placed.Labels({ 24.0, 10.0 });
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      const double least = places[i].value == places[k].value ? 0.3 * kSize : 24.0;
      EXPECT_GE(glm::distance(places[i].centre, places[k].centre), least);
    }
  }
}

/// Labels are left out where a text would hide neighbouring lines.
TEST(ContourPlaces, AreNotWhereContoursAreClose)
{
  Block block;
  // For the field x + 10 y + 100 z a pixel up is 0.125.
  const Placed wide(block, { 6.0, 10.0 });
  EXPECT_GT(wide.Labels({ 24.0, 10.0 }).size(), 1U);
  Block again;
  const Placed close(again, { 9.5, 10.0, 10.5 });
  EXPECT_TRUE(close.Labels({ 24.0, 10.0 }).empty());
  // Longer than the contour.
  EXPECT_TRUE(wide.Labels({ 180.0, 10.0 }).empty());
}

TEST(ContourPlaces, AreNoneWhereThereIsNothing)
{
  Block block;
  const Placed placed(block, { 500.0 });
  EXPECT_TRUE(placed.Labels({ 24.0, 10.0 }).empty());
  EXPECT_TRUE(PlaceLabels({}, placed.camera, placed.certifier, { { LabelSize{} } }, true).empty());
}
} // namespace pixelexact::testing
