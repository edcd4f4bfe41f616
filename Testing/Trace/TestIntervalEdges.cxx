// SPDX-License-Identifier: BSD-3-Clause
// Contours by intervals against many samples of fields in closed form.
#include "Block.h"
#include "TrueVerdicts.h"

#include "Core/Base/Error.h"
#include "Trace/Contours/IntervalEdges.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/TileVisit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>

namespace pixelexact::testing
{
namespace
{
/// The classifier as a module.
class Classified final : public FrameModule
{
public:
  Classified(LayerValues values, int subdivisions)
    : IsoValues(std::move(values))
    , Subdivisions(subdivisions)
  {
  }
  [[nodiscard]] SampleNeeds Needs() const override { return { .corners = kEdgeSampleBuffers }; }
  void Begin(int width, int height) override
  {
    Width = width;
    verdicts.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 77);
  }
  void Process(TileVisit& tile) override
  {
    const TileArea& area = tile.Area();
    std::vector<std::uint8_t> own(
      static_cast<std::size_t>(area.Width()) * static_cast<std::size_t>(area.Height()));
    IntervalCounters ofTile;
    ClassifyByIntervals(tile, IsoValues, Subdivisions, own, ofTile);
    const std::lock_guard lock(Mutex);
    counters.Add(ofTile);
    for (int y = 0; y < area.Height(); ++y)
    {
      std::copy_n(own.begin() + static_cast<std::ptrdiff_t>(y) * area.Width(), area.Width(),
        verdicts.begin() + static_cast<std::ptrdiff_t>(area.y0 + y) * Width + area.x0);
    }
  }

  std::vector<std::uint8_t> verdicts;
  IntervalCounters counters;

private:
  LayerValues IsoValues;
  int Subdivisions;
  int Width = 0;
  std::mutex Mutex;
};

/// A frame of it, of 70 x 50 pixels: six tiles.
constexpr int kIntervalWidth = 70;
constexpr int kIntervalHeight = 50;

CameraView MakeTiltedView()
{
  CameraView view;
  view.position = { 1.3, -1.9, 4.0 };
  view.viewUp = { 0.1, 1.0, 0.0 };
  view.viewAngle = 36.0;
  return view;
}

Classified& Classify(
  Classified& classified, const Scene& scene, const CameraView& view = MakeTiltedView())
{
  Trace(scene, Camera(view, kIntervalWidth, kIntervalHeight), { {}, { &classified } });
  return classified;
}

using LongFunction = std::function<long double(const LongVec3&)>;

/// The range of the samples on a pixel's edge, 64 a side, that lie on the plane in the cube, by
/// their rays in long double.
struct TrueRange
{
  long double lower = 1e30L;
  long double upper = -1e30L;
};

class TrueEdges
{
public:
  static constexpr int kSamples = 64;

  TrueEdges(const Vec3& origin, const Vec3& normal, LongFunction field,
    std::vector<KeptHalfSpace> kept = {})
    : Origin(ToLong(origin))
    , Normal(ToLong(normal))
    , Field(std::move(field))
    , Kept(std::move(kept))
  {
  }

  [[nodiscard]] TrueRange Of(int x, int y) const
  {
    TrueRange range;
    for (int k = 0; k < kSamples; ++k)
    {
      const long double part = static_cast<long double>(k) / kSamples;
      Add(x + part, y, range);
      Add(x + 1, y + part, range);
      Add(x + 1 - part, y + 1, range);
      Add(x, y + 1 - part, range);
    }
    return range;
  }

private:
  void Add(long double px, long double py, TrueRange& range) const
  {
    const LongRay ray = RayThrough(MakeTiltedView(), kIntervalWidth, kIntervalHeight, px, py);
    const long double t = Dot(Normal, Minus(Origin, ray.origin)) / Dot(Normal, ray.direction);
    const LongVec3 p = Plus(ray.origin, Times(t, ray.direction));
    const bool inCube = std::max({ std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) }) <= 1;
    const bool isKept = std::ranges::all_of(Kept,
      [&](const KeptHalfSpace& h) { return h[0] * p[0] + h[1] * p[1] + h[2] * p[2] + h[3] >= 0; });
    if (t > 0 && inCube && isKept)
    {
      const long double value = Field(p);
      range.lower = std::min(range.lower, value);
      range.upper = std::max(range.upper, value);
    }
  }

  LongVec3 Origin;
  LongVec3 Normal;
  LongFunction Field;
  std::vector<KeptHalfSpace> Kept;
};

/// No pixel is Out whose samples bracket a value, and none is In whose samples bracket none.
void ExpectNoneWrong(
  const Classified& classified, const TrueEdges& truth, const std::vector<double>& values)
{
  // Rounding of the block's coefficients and of values in doubles.
  constexpr long double kRounding = 1e-12L;
  int wrong = 0;
  for (int y = 0; y < kIntervalHeight; ++y)
  {
    for (int x = 0; x < kIntervalWidth; ++x)
    {
      const auto verdict = static_cast<ContourVerdict>(
        classified
          .verdicts[static_cast<std::size_t>(y) * kIntervalWidth + static_cast<std::size_t>(x)]);
      const TrueRange range = truth.Of(x, y);
      const auto meets = [&](long double slack)
      {
        return std::ranges::any_of(values,
          [&](double value)
          { return range.lower - slack <= value && value <= range.upper + slack; });
      };
      const bool isWrong = (verdict == ContourVerdict::Out && meets(-kRounding)) ||
        (verdict == ContourVerdict::In && !meets(kRounding));
      wrong += isWrong ? 1 : 0;
      EXPECT_TRUE(!isWrong || wrong > 5)
        << x << " " << y << " verdict " << int(verdict) << " range " << double(range.lower) << " "
        << double(range.upper);
    }
  }
  EXPECT_EQ(wrong, 0);
}

/// A polynomial of degree 4, with many extrema on a cut.
long double Wavy(const LongVec3& p)
{
  const auto [x, y, z] = p;
  return 8 * x * x * x * x - 8 * x * x + 8 * y * y * y * y - 8 * y * y + 4 * x * y + z * z;
}

/// A block with a field that its map takes to degree 8.
struct WavyBlock
{
  Block block;
  ExpansionBuilder values{ 1 };
  Field field;

  explicit WavyBlock(const LongFunction& function)
  {
    Space space = UniformSpace(Shape::Hexahedron, 8);
    space.order[2] = 4;
    for (int e = 0; e < 8; ++e)
    {
      values.Add(
        space, [&](const LongVec3& xi, long double* u) { u[0] = function(Block::Map(e, xi)); });
    }
    field = { "wavy", values.View() };
  }

  [[nodiscard]] Scene With(std::shared_ptr<const Surface> surface) const
  {
    return { block.scene_.locator, { { std::move(surface), &field } }, {} };
  }
};

const WavyBlock& block_()
{
  static const WavyBlock block(&Wavy);
  return block;
}
Scene cut_()
{
  return block_().With(std::make_shared<Plane>(kPlaneOrigin, kPlaneNormal));
}
const std::vector<double> kValues{ -3.5, -2.0, -1.0, -0.25, 0.5 };
} // namespace

TEST(IntervalEdges, NoVerdictIsWrong)
{
  const Scene scene = cut_();
  const TrueEdges truth(kPlaneOrigin, kPlaneNormal, &Wavy);
  std::int64_t undecided = 0;
  for (const int level : { 0, 1, 2, 3, 6 })
  {
    SCOPED_TRACE(level);
    Classified classified({ kValues }, level);
    ExpectNoneWrong(Classify(classified, scene), truth, kValues);
    const IntervalCounters& counters = classified.counters;
    EXPECT_GT(counters.out, 100);
    EXPECT_GT(counters.in, 200);
    EXPECT_EQ(
      std::ranges::count(classified.verdicts, static_cast<std::uint8_t>(ContourVerdict::Undecided)),
      counters.undecided);
    EXPECT_EQ(counters.undecided, counters.undecidedAfter[static_cast<std::size_t>(level)]);
    EXPECT_TRUE(level == 0 || counters.undecided < undecided);
    undecided = counters.undecided;
  }
}

/// The results at a level are those of a run with the same number of subdivisions.
TEST(IntervalEdges, LevelsAreThoseOfShorterRuns)
{
  const Scene scene = cut_();
  Classified deep({ kValues }, 4);
  Classify(deep, scene);
  std::int64_t in = 0;
  for (int level = 0; level <= 4; ++level)
  {
    Classified classified({ kValues }, level);
    Classify(classified, scene);
    const auto at = static_cast<std::size_t>(level);
    in += deep.counters.inAt[at];
    EXPECT_EQ(classified.counters.in, in);
    EXPECT_EQ(classified.counters.undecided, deep.counters.undecidedAfter[at]);
    EXPECT_EQ(classified.counters.unproven, deep.counters.unprovenAfter[at]);
  }
}

/// A pixel's verdict is the same at a tile's border and within a tile.
TEST(IntervalEdges, TilesChangeNothing)
{
  const Scene scene = cut_();
  const Camera camera(MakeTiltedView(), kIntervalWidth, kIntervalHeight);
  Classified whole({ kValues }, 3);
  Classify(whole, scene);
  Classified other({ kValues }, 3);
  const Pipeline pipeline{ {}, { &other } };
  Frame frame;
  frame.width = kIntervalWidth;
  frame.height = kIntervalHeight;
  other.Begin(kIntervalWidth, kIntervalHeight);
  other.verdicts = whole.verdicts;
  for (const TileArea& area : { TileArea{ 16, 16, 48, 48 }, TileArea{ 31, 20, 33, 40 } })
  {
    TileVisit(&scene, &camera, pipeline, frame, area).Run(pipeline.modules);
    EXPECT_EQ(other.verdicts, whole.verdicts);
  }
  EXPECT_GT(other.counters.in, 50);
}

TEST(IntervalEdges, NoVerdictIsWrongWherePartsAreCutAway)
{
  Scene scene = cut_();
  scene.kept = { { 1.0, 0.5, 0.0, 0.3 }, { -0.2, -1.0, 0.1, 0.45 } };
  Classified classified({ kValues }, 3);
  ExpectNoneWrong(
    Classify(classified, scene), TrueEdges(kPlaneOrigin, kPlaneNormal, &Wavy, scene.kept), kValues);
  EXPECT_GT(classified.counters.out, 100);
}

/// Figure 3 of the paper: a thin strip that passes between the corners. The corners show nothing,
/// the intervals leave it undecided, and samples between find it.
TEST(IntervalEdges, FindsWhatCornersMiss)
{
  const auto ridge = [](const LongVec3& p)
  {
    const long double d = p[0] - 0.31L;
    return d * d;
  };
  const WavyBlock block(ridge);
  const Scene scene =
    block.With(std::make_shared<Plane>(Vec3(0.0, 0.0, 0.05), Vec3(0.0, 0.0, 1.0)));
  CameraView view;
  view.position = { 0.0, 0.0, 5.0 };
  view.parallel = true;
  view.parallelScale = 1.25;
  // A pixel is 0.05 wide, the strip of values below 0.0012 ^ 2 is 0.0024 wide, and 0.31 lies a
  // fifth of a pixel beyond a corner.
  const LayerValues values{ { 0.0012 * 0.0012 } };
  Classified corners(values, 0);
  Classify(corners, scene, view);
  EXPECT_EQ(corners.counters.in, 0);
  EXPECT_GT(corners.counters.undecided, 30);
  Classified deep(values, 6);
  Classify(deep, scene, view);
  EXPECT_GE(deep.counters.in, 36);
  // Only the strip's own column, and those near faces, are in.
  EXPECT_LT(deep.counters.in, 45);
}

/// Pixels outside the mesh are proven Out, not guessed.
TEST(IntervalEdges, TellsWhatIsBesideTheMesh)
{
  const Scene scene = cut_();
  Classified classified({ { 1e3 } }, 3);
  Classify(classified, scene);
  EXPECT_EQ(classified.counters.in, 0);
  EXPECT_EQ(classified.verdicts.front(), static_cast<std::uint8_t>(ContourVerdict::Out));
  // Left are the pixels that an element's face crosses, the outline among them.
  EXPECT_EQ(classified.counters.undecided, classified.counters.unproven);
  EXPECT_LT(classified.counters.undecided, 300);
  EXPECT_GT(classified.counters.undecided, 100);
}

/// The view is along the plane; the upper half of the image shows nothing of it.
TEST(IntervalEdges, TellsWhatIsBeyondTheHorizon)
{
  CameraView view;
  view.position = { 0.0, -4.0, 0.5 };
  view.focalPoint = { 0.0, 0.0, 0.5 };
  view.viewUp = { 0.0, 0.0, 1.0 };
  const Scene scene = block_().With(std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0)));
  Classified classified({ { 1e3 } }, 1);
  Classify(classified, scene, view);
  const auto out = static_cast<std::uint8_t>(ContourVerdict::Out);
  EXPECT_EQ(std::ranges::count(
              std::span(classified.verdicts).last(kIntervalWidth * (kIntervalHeight / 2 - 1)), out),
    kIntervalWidth * (kIntervalHeight / 2 - 1));
  // The block has faces that are flat along the plane.
  EXPECT_GT(classified.counters.out, 100);
}

/// A chord is not the curve: on other surfaces, and with several layers, nothing is Out.
TEST(IntervalEdges, SaysNothingOfCurvedSurfacesAndSeveralLayers)
{
  const Scene ball = block_().With(std::make_shared<Quadric>(MakeSphere(Vec3(0.0), 0.8)));
  Classified onBall({ kValues }, 1);
  Classify(onBall, ball);
  EXPECT_GT(onBall.counters.in, 50);
  EXPECT_EQ(onBall.counters.out, 0);
  EXPECT_EQ(onBall.counters.undecided, onBall.counters.unproven);

  Scene planes = cut_();
  planes.layers.push_back(
    { std::make_shared<Plane>(Vec3(0.0), Vec3(1.0, 0.0, 0.3)), &block_().field });
  Classified onPlanes({ kValues, {} }, 1);
  Classify(onPlanes, planes);
  EXPECT_GT(onPlanes.counters.in, 50);
  EXPECT_EQ(onPlanes.counters.out, 0);
}

TEST(IntervalEdges, WithoutValuesAllIsOut)
{
  const Scene scene = cut_();
  Classified classified({ {} }, 2);
  Classify(classified, scene);
  EXPECT_EQ(classified.counters.in + classified.counters.undecided, 0);
  EXPECT_GT(classified.counters.out, 1000);
}

/// The second component is NaN in the first element: there nothing is known.
TEST(IntervalEdges, NanIsUndecided)
{
  Block block;
  Scene& scene = block.WithPlane(kPlaneOrigin, kPlaneNormal);
  scene.layers.front().component = 1;
  Classified classified({ { 0.5 } }, 2);
  Classify(classified, scene);
  EXPECT_EQ(classified.counters.in, 0);
  EXPECT_GT(classified.counters.undecided, 150);
  EXPECT_GT(classified.counters.out, 300);
}

TEST(IntervalEdges, RefusesWhatItCannotDo)
{
  const auto messageOf = [](const LayerValues& values, int subdivisions)
  {
    Classified classified(values, subdivisions);
    try
    {
      Classify(classified, cut_());
    }
    catch (const Error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto says = [](const std::string& message, const char* what)
  { return message.find(what) != std::string::npos; };
  EXPECT_TRUE(says(messageOf({ kValues }, 9), "9 subdivisions; give 0 to 8"));
  EXPECT_TRUE(says(messageOf({ kValues }, -1), "-1 subdivisions"));
  EXPECT_TRUE(says(messageOf({ kValues, kValues }, 1), "of 2 layers, but the scene has 1"));
}
} // namespace pixelexact::testing
