// SPDX-License-Identifier: BSD-3-Clause
// Linear pictures against closed forms, distances against brute force, errors counted by hand.
#include "Core/Base/Error.h"
#include "Core/Math/Rounding.h"
#include "Trace/Compare/LinearSurface.h"
#include "Trace/Compare/PictureErrors.h"
#include "TrueVerdicts.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace pixelexact::testing
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The square [-1,1]^2 at z = 0, slanted by z = x / 2, of 2 n^2 triangles, with f = x + 2 y.
LinearSurface MakeSquareSurface(int n, double slope)
{
  std::vector<Triangles::Triangle> triangles;
  std::vector<std::array<double, 3>> values;
  const auto at = [&](int i, int j)
  {
    const double x = -1.0 + 2.0 * i / n;
    return Vec3(x, -1.0 + 2.0 * j / n, slope * x);
  };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c)
  {
    triangles.push_back({ a, b, c });
    values.push_back({ a.x + 2.0 * a.y, b.x + 2.0 * b.y, c.x + 2.0 * c.y });
  };
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add(at(i + 1, j + 1), at(i, j + 1), at(i, j)); // of the other turn
    }
  }
  return { triangles, values };
}

Camera ViewOf(int width, int height, bool parallel)
{
  CameraView view;
  view.position = { 0.3, -0.2, 5.0 };
  view.focalPoint = { 0.0, 0.0, 0.0 };
  view.parallel = parallel;
  view.parallelScale = 1.3;
  return { view, width, height };
}

Picture PictureWith(std::vector<double> values)
{
  return PictureOf(static_cast<int>(values.size()), 1, values, {}, {});
}
} // namespace

TEST(LinearSurface, LinearValuesComeBackInEachPixel)
{
  for (const bool parallel : { true, false })
  {
    const Camera camera = ViewOf(151, 90, parallel);
    const double slope = 0.5;
    const LinearSurface square = MakeSquareSurface(7, slope);
    for (const bool corners : { false, true })
    {
      const std::vector<double> values = square.Trace(camera, corners);
      const int width = 151 + (corners ? 1 : 0);
      ASSERT_EQ(values.size(), static_cast<std::size_t>(width * (90 + (corners ? 1 : 0))));
      int seen = 0;
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        const double offset = corners ? 0.0 : 0.5;
        const Ray ray = camera.At(static_cast<double>(k % static_cast<std::size_t>(width)) + offset,
          static_cast<double>(k / static_cast<std::size_t>(width)) + offset);
        // The intersection of the ray with the plane z = x / 2.
        const double t =
          (slope * ray.origin.x - ray.origin.z) / (ray.direction.z - slope * ray.direction.x);
        const Vec3 x = ray.origin + t * ray.direction;
        const double beyond = std::max(std::fabs(x.x), std::fabs(x.y)) - 1.0;
        if (beyond < -1e-12)
        {
          ASSERT_NEAR(values[k], x.x + 2.0 * x.y, 1e-13) << k;
          ++seen;
        }
        else if (beyond > 1e-12)
        {
          ASSERT_TRUE(std::isnan(values[k])) << k;
        }
      }
      EXPECT_GT(seen, 1000);
    }
  }
}

TEST(LinearSurface, ThreadsChangeNoBitAndProgressAborts)
{
  const Camera camera = ViewOf(200, 300, false);
  const LinearSurface square = MakeSquareSurface(16, 0.0);
  const std::vector<double> many = square.Trace(camera, false);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const std::vector<double> alone = square.Trace(camera, false);
  EXPECT_TRUE(std::ranges::equal(
    many, alone, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
  EXPECT_TRUE(square.Trace(camera, false, [](double part) { return part < 0.5; }).empty());
}

TEST(LinearSurface, OneOfNoTrianglesShowsNothing)
{
  const LinearSurface nothing({}, {});
  const std::vector<double> values = nothing.Trace(ViewOf(8, 8, true), false);
  EXPECT_EQ(values.size(), 64U);
  EXPECT_TRUE(std::ranges::all_of(values, [](double value) { return std::isnan(value); }));
}

TEST(PixelDistance, IsThatOfTheNearestMark)
{
  std::mt19937 random(3);
  for (int k = 0; k < 20; ++k)
  {
    const int width = 1 + static_cast<int>(random() % 40);
    const int height = 1 + static_cast<int>(random() % 40);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height));
    for (std::uint8_t& pixel : pixels)
    {
      pixel = random() % 50 < static_cast<unsigned int>(k) ? 1 : 0;
    }
    const std::vector<double> found = DistanceToMarked(pixels, 1, width, height);
    for (int p = 0; p < width * height; ++p)
    {
      double nearest = kInfinity;
      for (int q = 0; q < width * height; ++q)
      {
        if (pixels[static_cast<std::size_t>(q)] == 1)
        {
          nearest = std::min(nearest, std::hypot(p % width - q % width, p / width - q / width));
        }
      }
      // Infinity is no number of units in the last place from itself.
      ASSERT_TRUE(found[static_cast<std::size_t>(p)] == nearest ||
        std::fabs(found[static_cast<std::size_t>(p)] - nearest) < 1e-12);
    }
  }
}

TEST(PictureErrors, AreThoseCountedByHand)
{
  Picture truth = PictureWith({ 0.0, 1.0, 2.0, 3.0, kNan, kNan, 4.0, kNan });
  truth.verdict[5] = static_cast<std::uint8_t>(PixelVerdict::Unknown);
  truth.verdict[7] = static_cast<std::uint8_t>(PixelVerdict::Exact); // the field is NaN there
  const Picture other = PictureWith({ 0.0, 1.5, kNan, 3.25, 9.0, 9.0, 4.0, 9.0 });
  const PictureErrors errors = Compare(truth, other, { 0.75, { 0.0, 4.0 }, 4 });
  EXPECT_EQ(errors.shown, 5);
  EXPECT_EQ(errors.compared, 4);
  EXPECT_EQ(errors.missing, 1);
  EXPECT_EQ(errors.invented, 1);
  EXPECT_EQ(errors.largest, 0.5);
  EXPECT_EQ(errors.mean, 0.75 / 4.0);
  EXPECT_EQ(errors.atShare, 0.5); // of 0, 0, 0.25, 0.5 and a missing one
  EXPECT_EQ(errors.wrongBin, 0);
  EXPECT_EQ(Compare(truth, other, { 0.6, { 0.0, 4.0 }, 16 }).wrongBin, 2);
  EXPECT_EQ(Compare(truth, other, { 0.6, { 0.0, 4.0 }, 16 }).atShare, 0.25);
  EXPECT_EQ(Compare(truth, other, { 1.0, { 0.0, 4.0 }, 16 }).atShare, kInfinity);
  EXPECT_FALSE(errors.hasContours);
  EXPECT_THROW((void)Compare(truth, PictureWith({ 1.0 }), {}), Error);
}

TEST(PictureErrors, ContoursAreMissedDisplacedOrInvented)
{
  const auto line = [](std::initializer_list<int> places)
  {
    Picture picture = PictureWith(std::vector<double>(40, 0.0));
    picture.contour.assign(40, static_cast<std::uint8_t>(ContourVerdict::Out));
    for (const int place : places)
    {
      picture.contour[static_cast<std::size_t>(place)] = kIn;
    }
    return picture;
  };
  Picture truth = line({ 2, 10, 20 });
  const Picture other = line({ 2, 12, 30, 39 });
  const PictureErrors errors = Compare(truth, other, { 0.99, { 0.0, 1.0 }, 8 });
  ASSERT_TRUE(errors.hasContours);
  EXPECT_EQ(errors.contourPixels, 3);
  EXPECT_EQ(errors.contourMissed, 1);
  EXPECT_EQ(errors.contourDisplaced, 1);
  EXPECT_EQ(errors.contourInvented, 2);
  EXPECT_EQ(errors.contourFarthest, 8.0);
  truth.contour[30] = kUndecided;
  EXPECT_EQ(Compare(truth, other, { 0.99, { 0.0, 1.0 }, 8 }).contourInvented, 1);
}

TEST(PictureErrors, ContoursOfValuesAtCorners)
{
  // Two pixels side by side; their corners hold 0, 1, 2 below and above.
  const std::vector<double> corners{ 0.0, 1.0, 2.0, 0.0, 1.0, 2.0 };
  const std::vector<double> values{ 0.25, 1.0 };
  const auto contour = [&](std::vector<double> iso) {
    return PictureOf(2, 1, { 0.5, 1.5 }, corners, iso).contour;
  };
  EXPECT_EQ(contour({ 0.5 }), (std::vector<std::uint8_t>{ 1, 0 }));
  EXPECT_EQ(contour({ 1.0 }), (std::vector<std::uint8_t>{ 1, 1 }));
  EXPECT_EQ(contour({ 5.0, 1.5 }), (std::vector<std::uint8_t>{ 0, 1 }));
}
} // namespace pixelexact::testing
