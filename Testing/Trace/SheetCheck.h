// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Block.h"

#include "Trace/Surfaces/Quadric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

// True views of planes and spheres in a cube, from all hits in long double, and comparison of
// frames with them.
namespace pixelexact::testing
{
inline constexpr Buffer kAllWithLayer = kAll | Buffer::Layer;

inline CameraView MakeAskewView()
{
  CameraView view;
  view.position = { 1.0, -1.5, 4.0 };
  view.viewUp = { 0.1, 1.0, 0.0 };
  view.viewAngle = 36.0;
  return view;
}

inline Layer MakeLayer(
  std::shared_ptr<const Surface> surface, const Field& field, bool translucent = false)
{
  return { std::move(surface), &field, 0, Precision::Double, translucent };
}

struct TrueSheet
{
  long double t;
  int layer;
  LongVec3 position;
};

/// Planes and spheres in the cube [-1, 1]^3.
class TrueScene
{
public:
  using Value = std::function<long double(const LongVec3& x)>;

  /// Begins with the block's mesh.
  explicit TrueScene(const Block& block) { Traced.locator = block.scene_.locator; }

  void AddPlane(const Vec3& through, const Vec3& normal, const Layer& layer, Value value)
  {
    const LongVec3 origin = ToLong(through);
    const LongVec3 across = ToLong(normal);
    Add(std::make_shared<Plane>(through, normal), layer, std::move(value),
      [origin, across](const LongRay& ray, std::vector<long double>& hits)
      { hits.push_back(Dot(across, Minus(origin, ray.origin)) / Dot(across, ray.direction)); });
  }

  void AddSphere(const Vec3& centre, double radius, const Layer& layer, Value value)
  {
    const LongVec3 about = ToLong(centre);
    Add(std::make_shared<Quadric>(MakeSphere(centre, radius)), layer, std::move(value),
      [about, radius](const LongRay& ray, std::vector<long double>& hits)
      {
        const LongVec3 from = Minus(ray.origin, about);
        const long double b = Dot(from, ray.direction);
        const long double d = b * b - Dot(from, from) + static_cast<long double>(radius) * radius;
        if (d >= 0)
        {
          hits.push_back(-b - std::sqrt(d));
          hits.push_back(-b + std::sqrt(d));
        }
        // Two hits near each other: a ray that nearly touches.
      });
  }

  /// The sheets of a ray in order; none where rounding may change what they are.
  [[nodiscard]] std::optional<std::vector<TrueSheet>> See(const LongRay& ray) const
  {
    constexpr long double kNear = 1e-9L;
    std::vector<TrueSheet> hits;
    for (std::size_t k = 0; k < Met.size(); ++k)
    {
      std::vector<long double> found;
      Met[k](ray, found);
      for (const long double t : found)
      {
        const LongVec3 x = Plus(ray.origin, Times(t, ray.direction));
        // The depth inside the mesh and the half-spaces.
        long double depth = std::min(1 - Largest(x), t);
        for (const auto& [a, b, c, d] : Traced.kept)
        {
          depth = std::min(depth, a * x[0] + b * x[1] + c * x[2] + d);
        }
        if (std::fabs(depth) < kNear)
        {
          return std::nullopt;
        }
        if (depth > 0)
        {
          hits.push_back({ t, static_cast<int>(k), x });
        }
      }
    }
    std::ranges::sort(hits, {}, &TrueSheet::t);
    std::vector<TrueSheet> seen;
    for (const TrueSheet& hit : hits)
    {
      if (!seen.empty() && hit.t - seen.back().t < kNear)
      {
        return std::nullopt;
      }
      seen.push_back(hit);
      if (!Traced.layers[static_cast<std::size_t>(hit.layer)].translucent)
      {
        break;
      }
    }
    return seen;
  }

  Scene Traced;
  std::vector<Value> Values; ///< by layer

private:
  using Meet = std::function<void(const LongRay& ray, std::vector<long double>& hits)>;

  void Add(std::shared_ptr<const Surface> surface, const Layer& layer, Value value, Meet meet)
  {
    Traced.layers.push_back(layer);
    Traced.layers.back().surface = std::move(surface);
    Values.push_back(std::move(value));
    Met.push_back(std::move(meet));
  }

  std::vector<Meet> Met;
};

/// The sheets of a set of samples: the nearest, then those behind it.
inline std::vector<const SampleBuffers*> SheetsOf(const SampleBuffers& samples)
{
  std::vector<const SampleBuffers*> sheets{ &samples };
  for (const SampleBuffers& sheet : samples.behind)
  {
    sheets.push_back(&sheet);
  }
  return sheets;
}

struct SheetTally
{
  int uncertain = 0;              ///< pixels
  std::vector<int> pixelsOfDepth; ///< by number of sheets

  [[nodiscard]] int WithDepth(std::size_t sheets) const
  {
    return sheets < pixelsOfDepth.size() ? pixelsOfDepth[sheets] : 0;
  }
};

/// Every pixel's centre shows the sheets that the scene has in closed form, and no others. The
/// frame has value, depth, position, layer, normal and verdict.
inline SheetTally ExpectSheets(
  const Frame& frame, const TrueScene& scene, const CameraView& view, double tolerance = 1e-12)
{
  SheetTally tally;
  const auto sheets = SheetsOf(frame.centres);
  tally.pixelsOfDepth.assign(sheets.size() + 1, 0);
  for (int y = 0; y < frame.height; ++y)
  {
    for (int x = 0; x < frame.width; ++x)
    {
      SCOPED_TRACE(::testing::Message() << "pixel " << x << " " << y);
      const auto at = static_cast<std::size_t>(y * frame.width + x);
      const LongRay ray = RayThrough(view, frame.width, frame.height, x + 0.5L, y + 0.5L);
      const auto seen = scene.See(ray);
      if (!seen)
      {
        ++tally.uncertain;
        continue;
      }
      EXPECT_LE(seen->size(), sheets.size());
      ++tally.pixelsOfDepth[std::min(seen->size(), sheets.size())];
      for (std::size_t k = 0; k < sheets.size(); ++k)
      {
        const SampleBuffers& sheet = *sheets[k];
        if (k >= seen->size())
        {
          EXPECT_EQ(sheet.verdict[at], static_cast<std::uint8_t>(PixelVerdict::Nothing)) << k;
          EXPECT_EQ(sheet.layer[at], kNoLayer);
          EXPECT_EQ(sheet.depth[at], kNoHit);
          EXPECT_TRUE(std::isnan(sheet.value[at]));
          continue;
        }
        const auto& [t, layer, position] = (*seen)[k];
        EXPECT_EQ(sheet.verdict[at], static_cast<std::uint8_t>(PixelVerdict::Exact)) << k;
        EXPECT_EQ(int{ sheet.layer[at] }, layer) << "sheet " << k;
        EXPECT_NEAR(sheet.depth[at], static_cast<double>(t), tolerance);
        EXPECT_LE(Largest(Minus(ToLong(sheet.position[at]), position)), tolerance);
        const auto value =
          static_cast<double>(scene.Values[static_cast<std::size_t>(layer)](position));
        EXPECT_NEAR(sheet.value[at], value, 100.0 * tolerance);
      }
    }
  }
  return tally;
}
} // namespace pixelexact::testing
