// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on pixels against many samples of fields in closed form.
#include "BentCube.h"

#include "Trace/Contours/LayerBounds.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/SearchedSurface.h"
#include "Trace/TileVisit.h"

#include <glm/geometric.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <limits>

namespace pixelexact::testing
{
namespace
{
Sight QuadraticSight(const CameraView& view, const LongHits& hits)
{
  return SightOf(view, kVerdictWidth, kVerdictHeight, hits,
    [](const LongVec3& x, const LongVec3& /*u*/) { return Quadratic(x); });
}

void Certify(ContourCertifier& certifier, const Scene& scene, const CameraView& view = Oblique())
{
  Trace(scene, Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &certifier } });
}

/// On planes hardly any pixel is undecided; on curved surfaces some are, near silhouettes.
void ExpectFewUndecided(const ContourCertifier& certifier, bool isFlat)
{
  const ContourCounters& counters = certifier.Counters();
  // Each pixel by one of them, or by none.
  EXPECT_EQ(counters.byBlocks + counters.byEdges + counters.byParts + counters.undecided,
    kVerdictWidth * kVerdictHeight);
  EXPECT_LE(static_cast<double>(counters.undecided),
    1.0 + (isFlat ? 1e-4 : 3e-2) * static_cast<double>(counters.in + counters.out));
}

struct Cut
{
  const char* name;
  std::shared_ptr<const Surface> surface;
  LongHits hits;
};

std::vector<Cut> MakeCuts()
{
  const Vec3 centre(0.05, -0.1, 0.1);
  const Vec3 axis = glm::normalize(Vec3(0.6, 0.64, 0.48));
  return { { "plane", std::make_shared<Plane>(kPlaneOrigin, kPlaneNormal),
             PlaneHits(kPlaneOrigin, kPlaneNormal) },
    { "sphere", std::make_shared<Quadric>(MakeSphere(centre, 0.7)),
      RoundHits(centre, Vec3(0.0), 0.7) },
    { "large sphere", std::make_shared<Quadric>(MakeSphere(centre, 1.05)),
      RoundHits(centre, Vec3(0.0), 1.05) },
    { "cylinder", std::make_shared<Quadric>(MakeCylinder(centre, axis, 0.5)),
      RoundHits(centre, axis, 0.5) } };
}

std::vector<std::vector<Shape>> AllMeshes()
{
  std::vector<std::vector<Shape>> all;
  for (const Shape shape : kShapes)
  {
    all.push_back({ shape });
  }
  all.emplace_back(std::begin(kShapes), std::end(kShapes));
  return all;
}
} // namespace

TEST(ContourCertifier, NoVerdictIsWrong)
{
  for (const auto& cut : MakeCuts())
  {
    for (const bool parallel : { false, true })
    {
      const CameraView view = Oblique(parallel);
      const TrueVerdicts truth(QuadraticSight(view, cut.hits), kVerdictWidth, kVerdictHeight,
        kContourValues, kValueTolerance);
      for (const auto& shapes : AllMeshes())
      {
        if (parallel && shapes.size() == 1)
        {
          continue;
        }
        SCOPED_TRACE(::testing::Message() << cut.name << (parallel ? ", parallel, " : ", ")
                                          << Name(shapes.front()) << " of " << shapes.size());
        const BentCube cube(shapes);
        ContourCertifier certifier({ kContourValues });
        Certify(certifier, cube.With(cut.surface), view);
        truth.Check(certifier.Verdicts(), cut.surface->IsFlat());
        ExpectFewUndecided(certifier, cut.surface->IsFlat());
        EXPECT_GT(certifier.Counters().in, 150);
      }
    }
  }
}

namespace
{
std::vector<std::uint8_t> VerdictsOf(
  const Scene& scene, const std::vector<double>& values, const ContourMethod& method = {})
{
  ContourCertifier certifier({ values }, method);
  Certify(certifier, scene);
  return certifier.Verdicts();
}

/// The true view of the block, in which z = 0 is a face between elements.
Sight BlockSight(const CameraView& view, const LongHits& hits,
  const std::function<long double(const LongVec3& x)>& value)
{
  return [=](long double px, long double py) -> std::optional<TrueSight>
  {
    const LongRay ray = RayThrough(view, kVerdictWidth, kVerdictHeight, px, py);
    const std::vector<long double> all = hits(ray);
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const LongVec3 x = Plus(ray.origin, Times(all[k], ray.direction));
      if (all[k] > 0 && Largest(x) < 1)
      {
        return TrueSight{ SheetOf(k, all), value(x) };
      }
    }
    return std::nullopt;
  };
}
} // namespace

/// The plane z = 0 between two layers of elements, with saddles and extrema in it, also on element
/// edges.
TEST(ContourCertifier, NoVerdictIsWrongAlongFaces)
{
  const Vec3 normal(0.0, 0.0, 1.0);
  struct Case
  {
    const char* name;
    std::function<long double(const LongVec3& x)> value;
    std::vector<double> values;
  };
  const Case cases[] = { { "several values", Quadratic, kContourValues },
    { "saddle", [](const LongVec3& x) { return x[0] * x[1]; }, { 0.0 } },
    { "saddle beside edges",
      [](const LongVec3& x) { return (x[0] - 0.23L) * (x[1] + 0.37L) + x[2]; }, { 0.0 } },
    { "minimum",
      [](const LongVec3& x)
      { return (x[0] - 0.23L) * (x[0] - 0.23L) + (x[1] + 0.37L) * (x[1] + 0.37L); },
      { 0.0 } },
    { "valley", [](const LongVec3& x) { return (x[0] - 0.23L) * (x[0] - 0.23L); }, { 1e-6 } } };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    Block block;
    Scene scene = block.scene_;
    const Field& field =
      block.Add(1, [&](const LongVec3& x, long double* u) { u[0] = one.value(x); });
    scene.layers = { { std::make_shared<Plane>(Vec3(0.0), normal), &field } };
    const TrueVerdicts truth(BlockSight(Oblique(), PlaneHits(Vec3(0.0), normal), one.value),
      kVerdictWidth, kVerdictHeight, one.values, kValueTolerance);
    ContourCertifier certifier({ one.values });
    Certify(certifier, scene);
    truth.Check(certifier.Verdicts(), true);
    ExpectFewUndecided(certifier, true);
  }
}

TEST(ContourCertifier, ValuesOutOfRangeAreOut)
{
  const BentCube cube(AllMeshes().back());
  for (const Cut& cut : MakeCuts())
  {
    SCOPED_TRACE(cut.name);
    const auto verdicts = VerdictsOf(cube.With(cut.surface), { -50.0, 50.0 });
    EXPECT_EQ(std::ranges::count(verdicts, kOut), kVerdictWidth * kVerdictHeight);
  }
}

/// Every pixel that shows a plateau of the value is in; none of any other value.
TEST(ContourCertifier, PlateausAreIn)
{
  const BentCube cube(
    AllMeshes().back(), [](const LongVec3& /*x*/, int /*element*/) { return 0.375L; });
  for (const Cut& cut : MakeCuts())
  {
    SCOPED_TRACE(cut.name);
    const auto verdicts = VerdictsOf(cube.With(cut.surface), { 0.375 });
    const Sight sight = QuadraticSight(Oblique(), cut.hits);
    int shown = 0;
    for (int y = 0; y < kVerdictHeight; ++y)
    {
      for (int x = 0; x < kVerdictWidth; ++x)
      {
        const bool all = sight(x, y) && sight(x + 1, y) && sight(x, y + 1) && sight(x + 1, y + 1);
        shown += all ? 1 : 0;
        EXPECT_TRUE(!all || verdicts[static_cast<std::size_t>(y * kVerdictWidth + x)] == kIn)
          << x << " " << y;
      }
    }
    EXPECT_GT(shown, 300);
    const auto others = VerdictsOf(cube.With(cut.surface), { 0.375 - 1e-9, 0.375 + 1e-9 });
    EXPECT_EQ(std::ranges::count(others, kOut), kVerdictWidth * kVerdictHeight);
  }
}

namespace
{
/// The cube [-1,1]^3 in one element, seen along z in 40 x 40 pixels, and a field on the plane
/// z = 1/4.
class PlainCube
{
public:
  using Value = std::function<long double(const LongVec3& x)>;
  static constexpr int kPixels = 40;
  static constexpr double kScale = 1.17;

  PlainCube(int order, const Value& value)
  {
    Elements.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
    Values.Add(UniformSpace(Shape::Hexahedron, order),
      [&](const LongVec3& xi, long double* u) { *u = value(xi); });
    field_ = { "u", Values.View() };
    locator_ = std::make_unique<Locator>(Elements.View());
  }
  void Certify(ContourCertifier& certifier) const
  {
    const Scene scene{ locator_.get(),
      { { std::make_shared<Plane>(Vec3(0.0, 0.0, 0.25), Vec3(0.0, 0.0, 1.0)), &field_ } }, {} };
    Trace(scene, ViewAlongZ(kPixels, kPixels, kScale), { {}, { &certifier } });
  }
  /// The x of the k-th line between two columns of pixels.
  static long double SideOf(int k)
  {
    return static_cast<long double>(kScale) * (2.0L * k / kPixels - 1.0L);
  }

private:
  MeshBuilder Elements;
  ExpansionBuilder Values{ 1 };
  Field field_;
  std::unique_ptr<Locator> locator_;
};
} // namespace

/// However large a field is elsewhere, a pixel is in where the value occurs, and nowhere else. All
/// coefficients are numbers exactly.
TEST(ContourCertifier, RoundingIsNoProofOfAValue)
{
  struct Case
  {
    double steepness;
    double value;
    int mostUndecided;
  };
  for (const auto& [steepness, value, mostUndecided] :
    { Case{ 0.0, 1e-13, 0 }, Case{ 0.0, -1e-13, 0 }, Case{ 0.0, 3e-15, 80 }, Case{ 0x1p30, 0.1, 0 },
      Case{ 0x1p44, 0.1, 1600 }, Case{ 0x1p48, 0.1, 1600 } })
  {
    SCOPED_TRACE(::testing::Message() << steepness << " " << value);
    const PlainCube cube(
      1, [a = steepness](const LongVec3& x) { return x[0] + a * (x[2] - 0.25L); });
    ContourCertifier certifier({ std::vector{ value } });
    cube.Certify(certifier);
    int in = 0;
    for (int y = 0; y < PlainCube::kPixels; ++y)
    {
      for (int x = 0; x < PlainCube::kPixels; ++x)
      {
        const auto verdict =
          certifier.Verdicts()[static_cast<std::size_t>(y * PlainCube::kPixels + x)];
        const bool occurs = PlainCube::SideOf(x) <= value && value <= PlainCube::SideOf(x + 1) &&
          PlainCube::SideOf(y) < 1 && PlainCube::SideOf(y + 1) > -1;
        EXPECT_TRUE(verdict != kIn || occurs) << x << " " << y;
        EXPECT_TRUE(verdict != kOut || !occurs) << x << " " << y;
        in += verdict == kIn ? 1 : 0;
      }
    }
    EXPECT_LE(certifier.Counters().undecided, mostUndecided);
    EXPECT_TRUE(mostUndecided > 0 || in > 30);
  }
}

/// A field that has the value all over the plane, but for what rounding makes of it; and one that
/// all but has it.
TEST(ContourCertifier, PlateausOnPlanesAreIn)
{
  for (const int order : { 1, 4, 7 })
  {
    const PlainCube cube(order, [](const LongVec3& x) { return 0.7L * x[2] + 0.1L; });
    ContourCertifier own({ std::vector{ 0.7 * 0.25 + 0.1 } });
    cube.Certify(own);
    EXPECT_GE(own.Counters().in, 34 * 34) << order;
    EXPECT_EQ(own.Counters().undecided, 0) << order;
    ContourCertifier others({ std::vector{ 0.7 * 0.25 + 0.1 + 1e-12 } });
    cube.Certify(others);
    EXPECT_EQ(others.Counters().in, 0) << order;
    EXPECT_EQ(others.Counters().undecided, 0) << order;
  }
}

/// Values that are not finite give no contours, and do not affect those of neighbours.
TEST(ContourCertifier, NanElementsTakeNoValue)
{
  BentCube cube(kHexahedra);
  cube.Values.Coefficients[0] = std::nan("");
  const Cut cut = MakeCuts()[1];
  const Sight sight = SightOf(Oblique(), kVerdictWidth, kVerdictHeight, cut.hits,
    [](const LongVec3& x, const LongVec3& u)
    {
      return std::max({ u[0], u[1], u[2] }) < 0 ? std::numeric_limits<long double>::quiet_NaN()
                                                : Quadratic(x);
    });
  const TrueVerdicts truth(sight, kVerdictWidth, kVerdictHeight, kContourValues, kValueTolerance);
  truth.Check(VerdictsOf(cube.With(cut.surface), kContourValues), cut.surface->IsFlat());
}

/// Neighbours differ by a half: across that a value is in.
TEST(ContourCertifier, JumpsAreInAndCounted)
{
  const auto besides = [](int element) { return (element & 1) != 0 ? 0.5L : 0.0L; };
  const BentCube cube(
    kHexahedra, [&](const LongVec3& x, int element) { return 0.5L * x[1] + besides(element); });
  for (const std::size_t which : { 0, 1, 3 })
  {
    const Cut cut = MakeCuts()[which];
    SCOPED_TRACE(cut.name);
    const Sight sight = SightOf(Oblique(), kVerdictWidth, kVerdictHeight, cut.hits,
      [&](const LongVec3& x, const LongVec3& u)
      { return 0.5L * x[1] + besides(u[0] > 0 ? 1 : 0); });
    const std::vector<double> values{ 0.25, 0.7 };
    const TrueVerdicts truth(sight, kVerdictWidth, kVerdictHeight, values, kValueTolerance);
    ContourCertifier certifier({ values });
    Certify(certifier, cube.With(cut.surface));
    truth.Check(certifier.Verdicts(), cut.surface->IsFlat());
    EXPECT_GT(certifier.Counters().in, 20);
    EXPECT_GT(certifier.Counters().jumps, 20);
    ExpectFewUndecided(certifier, cut.surface->IsFlat());
  }
}

/// |(x, y)|, which is no polynomial and has a corner where it is 0.
TEST(ContourCertifier, MagnitudesAreProven)
{
  Block block;
  const Field& field = block.Add(2,
    [](const LongVec3& x, long double* u)
    {
      u[0] = x[0];
      u[1] = x[1];
    });
  Scene scene = block.scene_;
  const Plane plane(kPlaneOrigin, kPlaneNormal);
  scene.layers = { { std::make_shared<Plane>(plane), &field, kMagnitude } };
  const Camera camera(Oblique(), kVerdictWidth, kVerdictHeight);
  const Frame frame = Trace(scene, camera, {}, { .corners = kAll });
  constexpr double kValue = 0.25;
  const auto verdicts = VerdictsOf(scene, { kValue });
  int in = 0;
  for (int y = 0; y < kVerdictHeight; ++y)
  {
    for (int x = 0; x < kVerdictWidth; ++x)
    {
      const auto at = static_cast<std::size_t>(y * (kVerdictWidth + 1) + x);
      const std::size_t corners[4] = { at, at + 1, at + kVerdictWidth + 1, at + kVerdictWidth + 2 };
      const bool shown = std::ranges::all_of(corners,
        [&](std::size_t corner) {
          return frame.corners.verdict[corner] == static_cast<std::uint8_t>(PixelVerdict::Exact);
        });
      double least = 1e9;
      double most = 0.0;
      for (int k = 0; k <= 64; ++k)
      {
        const double part = k / 64.0;
        for (const auto& [dx, dy] : { std::array{ part, 0.0 }, std::array{ part, 1.0 },
               std::array{ 0.0, part }, std::array{ 1.0, part } })
        {
          const Vec3 hit = HitsOf(plane, camera.At(x + dx, y + dy)).front().position;
          least = std::min(least, std::hypot(hit.x, hit.y));
          most = std::max(most, std::hypot(hit.x, hit.y));
        }
      }
      if (shown && std::fabs(least - kValue) > 1e-4 && std::fabs(most - kValue) > 1e-4)
      {
        const bool takes = least < kValue && kValue < most;
        in += takes ? 1 : 0;
        EXPECT_EQ(verdicts[static_cast<std::size_t>(y * kVerdictWidth + x)], takes ? kIn : kOut)
          << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(in, 20);
}

/// On searched surfaces nothing is known between two hits.
TEST(ContourCertifier, SearchedSurfacesAreUndecidedWhereShown)
{
  Block block;
  const Field& field = block.Add(1, [](const LongVec3& x, long double* u) { u[0] = x[0]; });
  class Ball final : public SampledFunction
  {
  public:
    void Evaluate(std::span<const Vec3> x, std::span<double> values) const override
    {
      std::ranges::transform(
        x, values.begin(), [](const Vec3& at) { return glm::dot(at, at) - 0.5; });
    }
    void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override
    {
      std::ranges::copy(x, gradients.begin());
    }
  };
  const Scene searched{ block.scene_.locator,
    { { std::make_shared<SearchedSurface>(std::make_shared<Ball>(), Box3{ Vec3(-1.0), Vec3(1.0) }),
      &field, 0 } },
    {} };
  const Frame frame =
    Trace(searched, Camera(Oblique(), kVerdictWidth, kVerdictHeight), {}, { .corners = kAll });
  const auto verdicts = VerdictsOf(searched, { 0.25 });
  int shown = 0;
  for (int y = 0; y < kVerdictHeight; ++y)
  {
    for (int x = 0; x < kVerdictWidth; ++x)
    {
      const auto at = static_cast<std::size_t>(y * (kVerdictWidth + 1) + x);
      bool any = false;
      for (const std::size_t corner :
        { at, at + 1, at + kVerdictWidth + 1, at + kVerdictWidth + 2 })
      {
        any =
          any || frame.corners.verdict[corner] == static_cast<std::uint8_t>(PixelVerdict::Exact);
      }
      shown += any ? 1 : 0;
      EXPECT_EQ(verdicts[static_cast<std::size_t>(y * kVerdictWidth + x)], any ? kUndecided : kOut);
    }
  }
  EXPECT_GT(shown, 200);
  const auto beyond = VerdictsOf(searched, { 7.0 });
  EXPECT_EQ(std::ranges::count(beyond, kOut), kVerdictWidth * kVerdictHeight);
}

TEST(ContourCertifier, AgreesWithThePapersMethod)
{
  const BentCube cube(kHexahedra);
  const Scene scene = cube.With(MakeCuts()[0].surface);
  const auto own = VerdictsOf(scene, kContourValues);
  const auto theirs = VerdictsOf(scene, kContourValues, { .subdivisions = 2 });
  int compared = 0;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    if (own[i] != kUndecided && theirs[i] != kUndecided)
    {
      ++compared;
      EXPECT_EQ(own[i], theirs[i]) << i;
    }
  }
  EXPECT_GT(compared, kVerdictWidth * kVerdictHeight / 2);
}

/// Neither threads nor tiles nor what was found out for another view.
TEST(ContourCertifier, VerdictsDependOnNothingElse)
{
  const BentCube cube(AllMeshes().back());
  for (const std::size_t which : { 0, 1 })
  {
    const Scene scene = cube.With(MakeCuts()[which].surface);
    SCOPED_TRACE(MakeCuts()[which].name);
    const auto wanted = VerdictsOf(scene, kContourValues);
    for (const std::size_t threads : { 1, 2 })
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      EXPECT_EQ(VerdictsOf(scene, kContourValues), wanted) << threads << " threads";
    }

    const auto bounds = std::make_shared<ContourBounds>();
    ContourCertifier kept({ kContourValues }, {}, bounds);
    Certify(kept, scene, Oblique(true));
    Certify(kept, scene);
    EXPECT_EQ(kept.Verdicts(), wanted) << "bounds of another view";

    const Camera camera(Oblique(), kVerdictWidth, kVerdictHeight);
    ContourCertifier tiled({ kContourValues });
    const Pipeline pipeline{ {}, { &tiled } };
    Frame frame = Trace(scene, camera, pipeline);
    for (const int size : { 1, 7, 20 })
    {
      tiled.Begin(kVerdictWidth, kVerdictHeight);
      // Runs both passes, as pipelines do: small tiles have small shares of the work, and get the
      // remaining work in the second pass.
      for (FrameModule* const module : { static_cast<FrameModule*>(&tiled), tiled.Rest() })
      {
        const std::vector<FrameModule*> modules{ module };
        for (int y = 0; y < kVerdictHeight; y += size)
        {
          for (int x = 0; x < kVerdictWidth; x += size)
          {
            TileVisit(&scene, &camera, pipeline, frame,
              { x, y, std::min(x + size, kVerdictWidth), std::min(y + size, kVerdictHeight) })
              .Run(modules);
          }
        }
      }
      EXPECT_EQ(tiled.Verdicts(), wanted) << "tiles of " << size;
    }
  }
}

/// A ridge along a face between elements, just above the value: seen by no sample.
TEST(ContourCertifier, RidgesAlongFacesAreNotOut)
{
  Block block;
  ExpansionBuilder values(1);
  for (int e = 0; e < 8; ++e)
  {
    values.Add(UniformSpace(Shape::Hexahedron, 4),
      [&](const LongVec3& xi, long double* u) { u[0] = (e & 4 ? -1 : 1) * Block::Map(e, xi)[2]; });
  }
  const Field field{ "ridge", values.View() };
  struct Case
  {
    std::shared_ptr<const Surface> surface;
    LongHits hits;
  };
  const Vec3 normal(0.1, 1.0, 0.3);
  const Case cases[] = {
    { std::make_shared<Plane>(Vec3(0.0), normal), PlaneHits(Vec3(0.0), normal) },
    { std::make_shared<Quadric>(MakeSphere(Vec3(0.0), 0.6)), RoundHits(Vec3(0.0), Vec3(0.0), 0.6) }
  };
  for (const Case& one : cases)
  {
    const Scene scene{ block.scene_.locator, { { one.surface, &field } }, {} };
    const TrueVerdicts truth(
      BlockSight(Oblique(), one.hits, [](const LongVec3& x) { return x[2]; }), kVerdictWidth,
      kVerdictHeight, { 0.0 }, 0.0L);
    const int wrong = truth.CountOutThatTake(VerdictsOf(scene, { -1e-9 }));
    EXPECT_EQ(wrong, 0) << (one.surface->IsFlat() ? "plane" : "sphere");
  }
}
} // namespace pixelexact::testing
