// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that tell where on elements their hits are.
#include "FrameCheck.h"
#include "SheetCheck.h"

namespace pixelexact::testing
{
namespace
{
/// Two elements side by side, curved along z alone, (x, y, z) = (a + offset, b, c + bump): what the
/// rays along z hit of them is known in closed form. Their field is 1 + x + z in the first one and
/// 100 + x y in the second: it tells on which side of the face between them a value was taken.
class ElementPair
{
public:
  ElementPair()
  {
    for (const int e : { 0, 1 })
    {
      const Space space = UniformSpace(Shape::Hexahedron, 3);
      const auto map = [e](const LongVec3& xi) { return Map(e, xi); };
      Elements.Add(space, map);
      Values.Add(space, [e](const LongVec3& xi, long double* u) { u[0] = ValueAt(e, Map(e, xi)); });
    }
    field_ = { "u", Values.View() };
    locator_ = std::make_unique<Locator>(Elements.View());
    scene_.locator = locator_.get();
  }

  static long double Bump(long double x, long double y) { return 0.1L * x * y + 0.05L * y * y; }
  static LongVec3 Map(int e, const LongVec3& xi)
  {
    const long double x = xi[0] + (e == 0 ? -1 : 1);
    return { x, xi[1], xi[2] + Bump(x, xi[1]) };
  }
  static long double ValueAt(int e, const LongVec3& x)
  {
    return e == 0 ? 1 + x[0] + x[2] : 100 + x[0] * x[1];
  }
  [[nodiscard]] std::int64_t Queries() const { return locator_->Counters().queries; }
  [[nodiscard]] const Mesh& GetMesh() const { return locator_->GetMesh(); }

  Field field_;
  Scene scene_;

private:
  MeshBuilder Elements;
  ExpansionBuilder Values{ 1 };
  std::unique_ptr<Locator> locator_;
};

/// The sheets xi_2 = const of a pair's elements, seen along -z.
class IsoSheets final : public Surface
{
public:
  std::vector<double> levels; ///< of xi_2, falling: in the order of t

  void Meet(const RayLanes& rays, HitSlots& hits) const override
  {
    for (int i = 0; i < rays.count; ++i)
    {
      const double x = rays.origin[0][i];
      const double y = rays.origin[1][i];
      if (std::fabs(x) > 2.0 || std::fabs(y) > 1.0)
      {
        continue;
      }
      int k = 0;
      for (const double level : levels)
      {
        const double z = level + static_cast<double>(ElementPair::Bump(x, y));
        const double t = rays.origin[2][i] - z;
        if (t < rays.tNear[i] || t > rays.tFar[i])
        {
          continue;
        }
        const HitLanes lanes = hits.Slot(k);
        lanes.t[i] = t;
        lanes.position[0][i] = x;
        lanes.position[1][i] = y;
        lanes.position[2][i] = z;
        const ElementLanes on = hits.Elements(k);
        on.element[i] = x < 0.0 ? 0 : 1;
        on.xi[0][i] = x < 0.0 ? x + 1.0 : x - 1.0;
        on.xi[1][i] = y;
        on.xi[2][i] = level;
        ++k;
      }
    }
  }
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override
  {
    // Returns its arguments, so that the test can compare them.
    return { point.xi.z, static_cast<double>(point.element), 0.0 };
  }
};

constexpr int kSurfaceWidth = 50;
constexpr int kSurfaceHeight = 30;

/// Pixels' centres at multiples of 0.1, x = 0 among them.
Camera AlongZ()
{
  CameraView view;
  view.position = { -0.05, 0.05, 5.0 };
  view.focalPoint = { -0.05, 0.05, 0.0 };
  view.parallel = true;
  view.parallelScale = 1.5;
  return { view, kSurfaceWidth, kSurfaceHeight };
}

} // namespace

/// At x = 0 both elements contain the points; the surface determines the element.
TEST(MeshSurface, IsNotLocated)
{
  ElementPair pair;
  const auto surface = std::make_shared<IsoSheets>();
  surface->levels = { 0.25 };
  pair.scene_.layers.push_back(MakeLayer(surface, pair.field_));
  const Camera camera = AlongZ();
  const std::int64_t before = pair.Queries();
  const Frame frame =
    Trace(pair.scene_, camera, {}, { .centres = kAllWithLayer | Buffer::Enclosure });
  EXPECT_EQ(pair.Queries(), before);
  int exact = 0;
  int between = 0;
  for (int y = 0; y < kSurfaceHeight; ++y)
  {
    for (int x = 0; x < kSurfaceWidth; ++x)
    {
      const auto at = static_cast<std::size_t>(y * kSurfaceWidth + x);
      const Vec3 origin = camera.At(x + 0.5, y + 0.5).origin;
      const bool hit = std::fabs(origin.x) <= 2.0 && std::fabs(origin.y) <= 1.0;
      ASSERT_EQ(frame.centres.verdict[at], hit ? kExactPixel : kNothingPixel) << x << " " << y;
      if (!hit)
      {
        EXPECT_EQ(frame.centres.element[at], -1);
        continue;
      }
      ++exact;
      const int element = origin.x < 0.0 ? 0 : 1;
      // The first element's face is also at x = 0.
      between += std::fabs(origin.x) < 1e-12 ? 1 : 0;
      EXPECT_EQ(frame.centres.element[at], element);
      EXPECT_EQ(frame.centres.xi[at],
        Vec3(origin.x < 0.0 ? origin.x + 1.0 : origin.x - 1.0, origin.y, 0.25));
      EXPECT_EQ(frame.centres.normal[at], Vec3(0.25, element, 0.0));
      const LongVec3 position = ElementPair::Map(element, ToLong(frame.centres.xi[at]));
      EXPECT_LE(Largest(Minus(ToLong(frame.centres.position[at]), position)), 1e-15);
      const long double value = ElementPair::ValueAt(element, position);
      EXPECT_NEAR(frame.centres.value[at], static_cast<double>(value), 1e-12);
      // The value is enclosed at the position, in the element that the surface returned.
      const long double there = ElementPair::ValueAt(element, ToLong(frame.centres.position[at]));
      EXPECT_LE(frame.centres.valueLower[at], there + 1e-17L);
      EXPECT_GE(frame.centres.valueUpper[at], there - 1e-17L);
      EXPECT_LT(frame.centres.valueUpper[at] - frame.centres.valueLower[at], 1e-10);
    }
  }
  EXPECT_GT(exact, 700);
  EXPECT_GT(between, 15);
  EXPECT_EQ(frame.counters.exact, exact);

  // A plane in the same place is located, and its points there belong to the first element.
  ElementPair located;
  located.scene_.layers.push_back(
    MakeLayer(std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0)), located.field_));
  const Frame other = Trace(located.scene_, camera, {}, { .centres = kAllWithLayer });
  EXPECT_GT(located.Queries(), 0);
  EXPECT_EQ(other.centres.element[static_cast<std::size_t>(15 * kSurfaceWidth + 25)], 0);
  EXPECT_EQ(frame.centres.element[static_cast<std::size_t>(15 * kSurfaceWidth + 25)], 1);
}

TEST(MeshSurface, SevenSheetsInOrder)
{
  ElementPair pair;
  const auto surface = std::make_shared<IsoSheets>();
  surface->levels = { 0.9, 0.6, 0.3, 0.0, -0.3, -0.6, -0.9 };
  for (const bool translucent : { false, true })
  {
    pair.scene_.layers = { MakeLayer(surface, pair.field_, translucent) };
    const Frame frame = Trace(pair.scene_, AlongZ(), {}, { .centres = kAllWithLayer });
    const auto sheets = SheetsOf(frame.centres);
    ASSERT_EQ(sheets.size(), translucent ? 7U : 1U);
    for (std::size_t k = 0; k < sheets.size(); ++k)
    {
      for (std::size_t i = 0; i < frame.centres.Size(); ++i)
      {
        ASSERT_EQ(sheets[k]->verdict[i], frame.centres.verdict[i]);
        if (sheets[k]->verdict[i] == kExactPixel)
        {
          EXPECT_EQ(sheets[k]->xi[i].z, surface->levels[k]);
          EXPECT_EQ(sheets[k]->normal[i].x, surface->levels[k]);
          EXPECT_EQ(sheets[k]->element[i], frame.centres.element[i]);
          const LongVec3 position =
            ElementPair::Map(static_cast<int>(sheets[k]->element[i]), ToLong(sheets[k]->xi[i]));
          EXPECT_NEAR(sheets[k]->depth[i], static_cast<double>(5 - position[2]), 1e-14);
        }
      }
    }
  }
  EXPECT_EQ(pair.Queries(), 0);
}

/// Next to a plane: each hit has the values of its layer, in any order.
TEST(MeshSurface, AmongOthers)
{
  const auto surface = std::make_shared<IsoSheets>();
  surface->levels = { 0.4, -0.4 };
  const auto plane = std::make_shared<Plane>(Vec3(0.0), Vec3(0.6, 0.0, 1.0));
  for (const bool planeFirst : { false, true })
  {
    ElementPair pair;
    pair.scene_.layers = { MakeLayer(surface, pair.field_, true),
      MakeLayer(plane, pair.field_, true) };
    if (planeFirst)
    {
      std::swap(pair.scene_.layers[0], pair.scene_.layers[1]);
    }
    const Frame frame = Trace(pair.scene_, AlongZ(), {}, { .centres = kAllWithLayer });
    const auto sheets = SheetsOf(frame.centres);
    ASSERT_EQ(sheets.size(), 3U);
    int of[2] = {};
    for (std::size_t i = 0; i < frame.centres.Size(); ++i)
    {
      double last = 0.0;
      for (const SampleBuffers* sheet : sheets)
      {
        if (sheet->verdict[i] != kExactPixel)
        {
          continue;
        }
        EXPECT_GE(sheet->depth[i], last);
        last = sheet->depth[i];
        const bool onPlane = (sheet->layer[i] == 0) == planeFirst;
        ++of[onPlane ? 1 : 0];
        const Vec3& x = sheet->position[i];
        if (onPlane)
        {
          EXPECT_NEAR(x.z, -0.6 * x.x, 1e-14);
        }
        else
        {
          EXPECT_EQ(std::fabs(sheet->xi[i].z), 0.4);
        }
        const long double value =
          ElementPair::ValueAt(static_cast<int>(sheet->element[i]), ToLong(x));
        EXPECT_NEAR(sheet->value[i], static_cast<double>(value), 1e-12);
      }
    }
    EXPECT_GT(of[0], 1400);
    EXPECT_GT(of[1], 500);
  }
}
} // namespace pixelexact::testing
