// SPDX-License-Identifier: BSD-3-Clause
#include "FrameCheck.h"
#include "LayeredScene.h"
#include "SheetCheck.h"

#include "Trace/FrameTiles.h"
#include "Trace/Modules/ContourLines.h"
#include "Trace/ProgressiveFrame.h"
#include "Trace/Surfaces/Combined.h"
#include "Trace/TileVisit.h"

#include "Core/Base/Error.h"

#include <tbb/global_control.h>

#include <array>
#include <limits>
#include <memory>

namespace pixelexact::testing
{
namespace
{
std::vector<std::vector<double>> OnOneLayer(const std::vector<double>& values)
{
  return std::vector(1, values);
}

/// A certifier and lines, alike on all layers.
struct Contours
{
  explicit Contours(const std::vector<double>& values, double width = 1.5, std::size_t layers = 1,
    const std::vector<Rgba>& colors = { kBlack })
    : certifier(std::vector(layers, values))
    , lines(certifier, { .width = width }, std::vector(layers, colors))
  {
  }
  [[nodiscard]] Pipeline On(const ColorMapping& colors)
  {
    return { { &colors }, { &certifier, &lines } };
  }

  ContourCertifier certifier;
  ContourLines lines;
};

using OnImage = std::function<long double(long double px, long double py)>;

/// The distance of an image position from a contour of a smooth function, by steps along its
/// gradient; infinite where the steps do not converge.
long double DistanceToContour(const OnImage& f, long double value, long double px, long double py)
{
  constexpr long double kStep = 1e-5L;
  long double x = px;
  long double y = py;
  for (int k = 0; k < 20; ++k)
  {
    const long double gx = (f(x + kStep, y) - f(x - kStep, y)) / (2 * kStep);
    const long double gy = (f(x, y + kStep) - f(x, y - kStep)) / (2 * kStep);
    // The foot of the point on the tangent at the current place.
    const long double g2 = gx * gx + gy * gy;
    const long double s = (value - f(x, y) + gx * (x - px) + gy * (y - py)) / g2;
    const long double nx = px + s * gx;
    const long double ny = py + s * gy;
    const long double moved = std::hypot(nx - x, ny - y);
    x = nx;
    y = ny;
    if (moved < 1e-9L)
    {
      return std::hypot(x - px, y - py);
    }
  }
  return std::numeric_limits<long double>::infinity();
}

/// The part of a pixel that is no farther than half the width from the contour, by counting.
double ExactCover(const OnImage& f, long double value, double width, int x, int y)
{
  constexpr int kCount = 16;
  if (DistanceToContour(f, value, x + 0.5L, y + 0.5L) > width / 2 + 1)
  {
    return 0.0;
  }
  int near = 0;
  for (int k = 0; k < kCount * kCount; ++k)
  {
    const long double px = x + (k % kCount + 0.5L) / kCount;
    const int row = k / kCount;
    const long double py = y + (row + 0.5L) / kCount;
    near += DistanceToContour(f, value, px, py) < width / 2 ? 1 : 0;
  }
  return near / static_cast<double>(kCount * kCount);
}

/// The field along the rays of a view; NaN where they miss.
OnImage SeenThrough(const TrueScene& scene, const CameraView& view, int size)
{
  return [&scene, view, size](long double px, long double py)
  {
    const auto sheets = scene.See(RayThrough(view, size, size, px, py));
    return sheets && !sheets->empty() ? scene.Values[0](sheets->front().position)
                                      : std::numeric_limits<long double>::quiet_NaN();
  };
}

struct CoverTally
{
  double sum = 0.0;
  double exact = 0.0;
  double worst = 0.0;
};

/// Counts pixels whose neighbourhood of `away` pixels in the image shows the field.
CoverTally CompareCover(const Frame& frame, const OnImage& f, double value, double width, int away)
{
  CoverTally tally;
  for (int y = away; y < frame.height - away; ++y)
  {
    for (int x = away; x < frame.width - away; ++x)
    {
      bool inside = true;
      for (const int dx : { -away, 0, 1 + away })
      {
        for (const int dy : { -away, 0, 1 + away })
        {
          inside = inside && std::isfinite(f(x + dx, y + dy));
        }
      }
      if (inside)
      {
        const double exact = ExactCover(f, value, width, x, y);
        const double cover = CoverAt(frame, x, y);
        tally.sum += cover;
        tally.exact += exact;
        tally.worst = std::max(tally.worst, std::fabs(cover - exact));
      }
    }
  }
  return tally;
}

CameraView MakeNarrowView()
{
  CameraView view;
  view.position = { 1.0, -1.5, 4.0 };
  view.viewAngle = 20.0;
  return view;
}
} // namespace

/// A straight line is its width wide wherever it lies among the pixels, and its middle is the
/// contour.
TEST(ContourLines, OfALinearFieldHaveTheirWidthAndPlace)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  constexpr int kSize = 60;
  const ColorMapping colors = MakeWhite();
  // The field x + 10 y + 100 z by image position.
  const OnImage f = [](long double px, long double py)
  {
    const long double x = (2 * px / kSize - 1) * 1.25L;
    const long double y = (2 * py / kSize - 1) * 1.25L;
    return std::max(std::fabs(x), std::fabs(y)) < 1 ? x + 10 * y + 10
                                                    : std::numeric_limits<long double>::quiet_NaN();
  };
  for (const double width : { 0.4, 1.0, 1.5, 4.0 })
  {
    for (const double value : { 9.7, 10.0, 10.23 })
    {
      Contours contours({ value }, width);
      const Frame frame = Trace(scene, ViewAlongZ(kSize, kSize), contours.On(colors));
      const CoverTally tally = CompareCover(frame, f, value, width, 4);
      // A line moved by a pixel changes what it covers by as much.
      EXPECT_LT(tally.worst, 0.02) << width << " " << value;
      EXPECT_NEAR(tally.sum / tally.exact, 1.0, 0.01) << width << " " << value;
    }
  }
}

TEST(ContourLines, OfAQuadraticFieldCoverWhatIsNear)
{
  Block block;
  block.MakeCurved();
  constexpr int kSize = 70;
  const ColorMapping colors = MakeWhite();
  for (const bool sphere : { false, true })
  {
    TrueScene scene(block);
    if (sphere)
    {
      scene.AddSphere({ 0.1, -0.1, 0.2 }, 0.7, { nullptr, &block.field_ }, &Block::CurvedAt);
    }
    else
    {
      scene.AddPlane(
        { 0.0, 0.0, 0.1 }, { 0.2, 0.1, 1.0 }, { nullptr, &block.field_ }, &Block::CurvedAt);
    }
    const CameraView view = MakeNarrowView();
    const OnImage f = SeenThrough(scene, view, kSize);
    for (const double width : { 1.0, 2.5 })
    {
      for (const double value : { 2.0, 4.0 })
      {
        Contours contours({ value }, width);
        const Frame frame = Trace(scene.Traced, Camera(view, kSize, kSize), contours.On(colors));
        const CoverTally tally = CompareCover(frame, f, value, width, 3);
        EXPECT_GT(tally.exact, 30.0);
        EXPECT_LT(tally.worst, 0.05) << sphere << " " << width << " " << value;
        EXPECT_NEAR(tally.sum / tally.exact, 1.0, 0.01) << sphere << " " << width << " " << value;
      }
    }
  }
}

/// No line is drawn near an extremum that does not reach the value, although linear interpolation
/// would give one.
TEST(ContourLines, AreNotDrawnWhereTheValueIsNotReached)
{
  Block block;
  const Field& parabola =
    block.Add(1, [](const LongVec3& x, long double* u) { u[0] = x[0] * x[0]; });
  Scene scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  scene.layers[0].field = &parabola;
  const ColorMapping colors = MakeWhite();
  // A pixel is 0.05 wide.
  Contours contours({ -1e-4, std::numeric_limits<double>::max(), -5.0 }, 8.0);
  const Frame with = Trace(scene, ViewAlongZ(50, 50), contours.On(colors));
  const Frame without = Trace(scene, ViewAlongZ(50, 50), { { &colors }, {} });
  EXPECT_EQ(with.Image(), without.Image());
}

TEST(ContourLines, OfConstantFieldsAreNotInvented)
{
  Block block;
  const Field& constant = block.Add(1, [](const LongVec3&, long double* u) { u[0] = 2; });
  Scene scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  scene.layers[0].field = &constant;
  const ColorMapping colors = MakeWhite();
  Contours beside({ 1.0, 3.0 });
  const Frame frame = Trace(scene, ViewAlongZ(40, 40), beside.On(colors));
  EXPECT_EQ(frame.Image(), Trace(scene, ViewAlongZ(40, 40), { { &colors }, {} }).Image());
}

/// NaN in one element: no line there, and none that the picture's other elements do not have.
TEST(ContourLines, EndWhereValuesAreNoNumbers)
{
  Block block;
  Scene& scene = block.WithPlane({ 0.0, 0.0, -0.5 }, { 0.0, 0.0, 1.0 });
  scene.layers[0].component = 1;
  const ColorMapping colors = MakeWhite();
  Contours contours({ 1.0 - 1e-9, 0.5 });
  const Frame frame = Trace(scene, ViewAlongZ(40, 40), contours.On(colors));
  EXPECT_EQ(frame.Image(), Trace(scene, ViewAlongZ(40, 40), { { &colors }, {} }).Image());
}

/// At the intersection of a plane and a sphere, values jump between the two.
TEST(ContourLines, EndWhereAnotherLayerBegins)
{
  Block block;
  const Field& low = block.Add(1, [](const LongVec3& x, long double* u) { u[0] = x[0] - 9; });
  const Field& high = block.Add(1, [](const LongVec3& x, long double* u) { u[0] = x[0] + 9; });
  TrueScene scene(block);
  scene.AddSphere({ 0.2, -0.1, 0.1 }, 0.6, { nullptr, &high }, &Block::CurvedAt);
  scene.AddPlane({ 0.0, 0.0, 0.1 }, { 0.2, 0.1, 1.0 }, { nullptr, &low }, &Block::CurvedAt);
  const Camera camera(MakeNarrowView(), 80, 80);
  const ColorMapping colors = MakeWhite(2);
  Contours contours({ 0.0 }, 3.0, 2);
  const Frame frame = Trace(scene.Traced, camera, contours.On(colors));
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    // The verdicts of these pixels are tested with the certifier.
    if (contours.certifier.Verdicts()[i] == static_cast<std::uint8_t>(ContourVerdict::Out))
    {
      EXPECT_EQ(frame.color[4 * i], frame.centres.color[4 * i]) << i;
    }
  }
}

/// A surface that hides a part of itself: the value is between those of the two parts, and on no
/// visible part.
TEST(ContourLines, EndWhereASheetBegins)
{
  Block block;
  const Field& along = block.Add(1, [](const LongVec3& x, long double* u) { u[0] = x[2]; });
  Scene scene = block.scene_;
  const auto ball = [](const Vec3& centre, double radius)
  {
    return Combined::Part{ std::make_shared<Quadric>(MakeSphere(centre, radius)),
      [centre, radius](const Vec3& x)
      { return glm::dot(x - centre, x - centre) - radius * radius; } };
  };
  const auto any = [](const std::vector<bool>& inside) { return inside[0] || inside[1]; };
  scene.layers.push_back(
    { std::make_shared<Combined>(
        std::vector{ ball({ 0.0, 0.0, 0.6 }, 0.3), ball({ 0.2, 0.1, -0.6 }, 0.35) }, any),
      &along });
  const ColorMapping colors = MakeWhite();
  // Visible values of the nearer surface are above 0.6, those of the other one below -0.25.
  Contours contours({ 0.0, 0.3 }, 4.0);
  const Frame frame = Trace(scene, ViewAlongZ(90, 90, 0.6), contours.On(colors));
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    // The verdicts of the other pixels are tested with the certifier.
    if (contours.certifier.Verdicts()[i] == static_cast<std::uint8_t>(ContourVerdict::Out))
    {
      EXPECT_EQ(frame.color[4 * i], frame.centres.color[4 * i]) << i;
    }
  }
  // On a strip that crosses the silhouette no ray meets the value.
  EXPECT_EQ(contours.certifier.Counters().undecided, 0);
  EXPECT_EQ(contours.certifier.Counters().in, 0);
}

TEST(ContourLines, HaveColorsByValue)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  const ColorMapping colors = MakeWhite();
  ContourCertifier certifier(OnOneLayer({ 14.0, 6.0 }));
  // Values are in ascending order.
  ContourLines lines(certifier, { .width = 3.0 }, { { kRed, kGreen } });
  const Frame frame = Trace(scene, ViewAlongZ(50, 50), { { &colors }, { &certifier, &lines } });
  const auto at = [&](double y)
  {
    const auto row = static_cast<std::size_t>((y / 1.25 + 1.0) * 25.0);
    Rgba color;
    std::copy_n(&frame.color[4 * (row * 50 + 25)], 4, color.begin());
    return color;
  };
  EXPECT_EQ(at(-0.4), kRed);
  EXPECT_EQ(at(0.4), kGreen);
  EXPECT_EQ(at(0.0), (Rgba{ 255, 255, 255, 255 }));
}

/// Without a colour map only lines are drawn.
TEST(ContourLines, AreOpaqueOverNothing)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  const ColorMapping colors(SolidColor({ 0, 0, 0, 0 }));
  ContourCertifier certifier(OnOneLayer({ 10.0 }));
  ContourLines lines(certifier, { .width = 3.0 }, { { kRed } });
  const Frame frame = Trace(scene, ViewAlongZ(50, 50), { { &colors }, { &certifier, &lines } });
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    const std::uint8_t* color = &frame.color[4 * i];
    EXPECT_TRUE(color[3] == 0 || (color[0] == 255 && color[1] == 0 && color[2] == 0));
  }
  EXPECT_EQ(frame.color[4 * (25 * 50 + 25) + 3], 255);
}

/// A pixel with the verdict in shows a line, however narrow it is.
TEST(ContourLines, AreSeenInEveryPixelThatIsIn)
{
  Block block;
  block.MakeCurved();
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.1, 0.2, 1.0 });
  const ColorMapping colors = MakeWhite();
  Contours contours({ 0.1, 0.5, 1.0, 2.0, 3.0 }, 0.1);
  const Frame frame = Trace(scene, ViewAlongZ(70, 70), contours.On(colors));
  int in = 0;
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    if (contours.certifier.Verdicts()[i] == static_cast<std::uint8_t>(ContourVerdict::In))
    {
      ++in;
      // The line is also visible where a pixel outside of the mesh has no colour.
      EXPECT_TRUE(frame.color[4 * i] < 255 && frame.color[4 * i + 3] > 0) << i;
    }
  }
  EXPECT_GT(in, 100);
}

namespace
{
/// Makes a certifier's verdicts of a column of pixels undecided.
class Doubting final : public FrameModule
{
public:
  Doubting(ContourCertifier& certifier, int column)
    : Verdicts(const_cast<std::vector<std::uint8_t>&>(certifier.Verdicts()))
    , Column(column)
  {
  }
  [[nodiscard]] SampleNeeds Needs() const override { return {}; }
  void Begin(int /*width*/, int /*height*/) override {}
  void Process(TileVisit& tile) override
  {
    const TileArea& area = tile.Area();
    for (int y = area.y0; y < area.y1 && area.x0 <= Column && Column < area.x1; ++y)
    {
      Verdicts[static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.GetFrame().width) +
        static_cast<std::size_t>(Column)] = static_cast<std::uint8_t>(ContourVerdict::Undecided);
    }
  }

private:
  std::vector<std::uint8_t>& Verdicts;
  int Column;
};
} // namespace

/// Undecided pixels have what there is of lines between corners, or a colour of their own.
TEST(ContourLines, AreDrawnWhereItIsUndecided)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  const ColorMapping colors = MakeWhite();
  constexpr Rgba kTeal{ 0, 128, 128, 255 };
  for (const bool shown : { false, true })
  {
    ContourCertifier certifier(OnOneLayer({ 10.0 }));
    Doubting doubting(certifier, 30);
    ContourLines lines(certifier, { .width = 1.5, .showUndecided = shown }, { { kBlack } });
    const Frame frame =
      Trace(scene, ViewAlongZ(50, 50), { { &colors }, { &certifier, &doubting, &lines } });
    const auto at = [&frame](int x, int y)
    {
      Rgba color;
      std::copy_n(&frame.color[4 * static_cast<std::size_t>(y * 50 + x)], 4, color.begin());
      return color;
    };
    // Away from the contour, y = -x / 10, and on it.
    EXPECT_EQ(at(30, 40), shown ? kTeal : (Rgba{ 255, 255, 255, 255 }));
    EXPECT_EQ(at(30, 24) == kTeal, shown);
    EXPECT_LT(at(30, 24)[0], 128);
    EXPECT_EQ(at(29, 40), (Rgba{ 255, 255, 255, 255 }));
    // Beyond the mesh there is nothing to draw a line of.
    EXPECT_EQ(at(30, 1), shown ? kTeal : (Rgba{ 0, 0, 0, 0 }));
  }
}

TEST(ContourLines, DoNotDependOnTilesAndThreads)
{
  for (const bool translucent : { false, true })
  {
    const LayeredScene scene(translucent);
    const Camera camera(ObliqueView(), 75, 61);
    const ColorMapping colors = LayeredColors();
    Contours contours({ 0.5, 1.0, 1.5, 2.5 }, 5.0, 2);
    const Pipeline pipeline = contours.On(colors);
    const auto traced = [&](std::size_t threads)
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      return Trace(scene.scene_, camera, pipeline);
    };
    const Frame frame = traced(1);
    EXPECT_EQ(traced(4).Image(), frame.Image());
    Frame again = frame;
    BeginPipeline(pipeline, again);
    for (const auto& modules : pipeline.Runs())
    {
      for (int y = 0; y < 61; y += 7)
      {
        for (int x = 0; x < 75; x += 13)
        {
          TileVisit visit(&scene.scene_, &camera, pipeline, again,
            { x, y, std::min(x + 13, 75), std::min(y + 7, 61) });
          if (modules == pipeline.Runs().front())
          {
            visit.MakeImage();
          }
          visit.Run(modules);
        }
      }
    }
    EXPECT_EQ(again.Image(), frame.Image());
    // With corners that the frame keeps, and in passes.
    const Buffer kept = pipeline.Needs().corners;
    EXPECT_EQ(Trace(scene.scene_, camera, pipeline, { .corners = kept }).Image(), frame.Image());
    ProgressiveFrame passes(scene.scene_, camera, pipeline, Buffer::None, kept);
    while (passes.Step() != 1)
    {
      ASSERT_TRUE(passes.Refine());
    }
    EXPECT_EQ(passes.Get().Image(), frame.Image());
  }
}

/// Other values, colours and widths for a frame that keeps its corners.
TEST(ContourLines, AreRepaintedWithoutRays)
{
  Block block;
  block.MakeCurved();
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.1, 0.2, 1.0 });
  const Camera camera = ViewAlongZ(75, 61);
  const ColorMapping colors = MakeWhite();
  Frame frame = Trace(scene, camera, { { &colors }, {} });
  EXPECT_EQ(frame.counters.rays, 75 * 61);
  Contours first({ 1.0, 2.0 });
  frame.centres.layer.assign(frame.centres.Size(), 0);
  ASSERT_TRUE(KeepCorners(scene, camera, first.On(colors).Needs().corners, frame));
  const std::int64_t before = frame.counters.rays;
  EXPECT_EQ(before, 75 * 61 + 76 * 62);
  std::int64_t besides = 0;
  for (const double value : { 1.0, 1.3, 2.5 })
  {
    Contours others({ value }, 1.0 + value);
    ASSERT_TRUE(KeepCorners(scene, camera, others.On(colors).Needs().corners, frame));
    Repaint(scene, camera, others.On(colors), frame);
    besides += others.certifier.Counters().samples;
    EXPECT_EQ(frame.Image(), Trace(scene, camera, others.On(colors)).Image());
  }
  // Exactly the rays that the verdicts need are traced.
  EXPECT_EQ(frame.counters.rays, before + besides);
  EXPECT_LT(besides, before / 20);
}

TEST(ContourLines, RefuseWhatTheyCannotDraw)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  const ColorMapping colors = MakeWhite();
  Frame frame = Trace(scene, ViewAlongZ(20, 20), { { &colors }, {} });
  Contours contours({ 1.0 });
  // Without corners, and without a scene to trace them.
  EXPECT_THROW(Repaint(contours.On(colors), frame), Error);
  const ContourCertifier certifier(OnOneLayer({ 1.0, 2.0 }));
  for (const double width : { 0.0, 0.05, 33.0, std::nan("") })
  {
    EXPECT_THROW(ContourLines(certifier, { .width = width }, { { kBlack } }), Error);
  }
  EXPECT_THROW(ContourLines(certifier, {}, {}), Error);
  EXPECT_THROW(ContourLines(certifier, {}, { { kBlack, kRed, kGreen } }), Error);
  EXPECT_NO_THROW(ContourLines(certifier, {}, { { kBlack, kRed } }));
  // One list of values for two layers, and three lists, are refused.
  const LayeredScene layered(false);
  const ColorMapping ofLayers = LayeredColors();
  for (const std::size_t lists : { 1U, 3U })
  {
    Contours others({ 1.0 }, 1.5, lists);
    EXPECT_THROW(Trace(layered.scene_, Camera(ObliqueView(), 20, 20), others.On(ofLayers)), Error)
      << lists;
  }
}
} // namespace pixelexact::testing
