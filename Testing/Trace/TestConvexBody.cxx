// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCheck.h"

#include "Trace/Surfaces/ConvexBody.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pixelexact::testing
{
namespace
{
/// One half-space: point, normal.
const auto kPlane = [](const std::vector<Float128>& in, const auto& x)
{ return DotWith(Less(x, in.data()), in.data() + 3); };

/// One half-space after a map, row by row, and its offset.
const auto kMovedPlane = [](const std::vector<Float128>& in, const auto& x)
{
  std::decay_t<decltype(x)> y;
  for (std::size_t i = 0; i < 3; ++i)
  {
    y[i] = DotWith(x, in.data() + 6 + 3 * i) + std::decay_t<decltype(x[0])>(in[15 + i]);
  }
  return kPlane(in, y);
};

/// The entry or exit of a ray.
struct End
{
  Float128 t;
  Float128 error; ///< by 4 ulp of every number
  int face = -1;
  Float128 gap; ///< to the next one
};

/// The hits of a ray by the definition, and whether they are certain.
struct TrueHits
{
  std::vector<End> ends;
  bool certain = true;
};

template <class Function>
TrueHits HitsByDefinition(const std::vector<Definition<Function>>& planes, const Ray& ray)
{
  constexpr double kChange = 4.0 * std::numeric_limits<double>::epsilon();
  const Float128 never = std::numeric_limits<double>::infinity();
  End enter{ -never, 0, -1, never };
  End exit{ never, 0, -1, never };
  TrueHits result;
  bool outside = false;
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    const Polynomial p = planes[i].Along(ray, 0);
    // Far away, what a change of the numbers makes of f is what it makes of the slope.
    const Float128 far = static_cast<Float128>(1e30);
    const Float128 slopeChange = kChange * planes[i].Sensitivity(ray, far) / far;
    if (p.c[1] == 0)
    {
      outside = outside || p.c[0] > 0;
      result.certain = result.certain && Size(p.c[0]) > kChange * planes[i].Sensitivity(ray, 0);
      continue;
    }
    result.certain = result.certain && Size(p.c[1]) > slopeChange;
    const Float128 t = -p.c[0] / p.c[1];
    const Float128 error = kChange * (planes[i].Sensitivity(ray, t) / Size(p.c[1]) + Size(t));
    End& end = p.c[1] < 0 ? enter : exit;
    const bool isNew = p.c[1] < 0 ? t > enter.t : t < exit.t;
    const Float128 gap = Size(t - end.t) - error - end.error;
    end = isNew ? End{ t, error, static_cast<int>(i), gap }
                : End{ end.t, end.error, end.face, std::min(gap, end.gap) };
  }
  if (outside)
  {
    return result;
  }
  const Float128 error = enter.error + exit.error;
  result.certain = result.certain && (enter.face < 0 || Size(enter.t) > enter.error) &&
    (exit.face < 0 || Size(exit.t) > exit.error) && Size(exit.t - enter.t) > error;
  for (const End& end : { enter, exit })
  {
    if (enter.t < exit.t && end.face >= 0 && end.t > 0)
    {
      result.ends.push_back(end);
    }
  }
  return result;
}

class BodyCheck
{
public:
  /// Adds rays, and others nearly in the faces that they meet.
  template <class Function>
  void Add(const ConvexBody& body, const std::vector<Definition<Function>>& planes,
    const std::vector<Ray>& rays, double size, RaysAbout& random)
  {
    std::vector<Ray> grazing;
    for (const auto& hits : MeetAll(body, rays))
    {
      for (const Hit& hit : hits)
      {
        const SurfacePoint point{ hit.position };
        grazing.push_back(random.Grazing(point.position, body.Normal(point),
          random.Sign() * size * random.Decades(-17.0, 0.0), size * random.Decades(-1.0, 1.0)));
      }
    }
    AddRays(body, planes, rays);
    AddRays(body, planes, grazing);
  }
  Tally Seen;

private:
  template <class Function>
  void AddRays(const ConvexBody& body, const std::vector<Definition<Function>>& planes,
    const std::vector<Ray>& rays)
  {
    const auto found = MeetAll(body, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      ExpectSameHits(found[i], HitsOf(body, rays[i]));
      EXPECT_LE(found[i].size(), 2U);
      const TrueHits truth = HitsByDefinition(planes, rays[i]);
      (truth.certain ? Seen.certain : Seen.uncertain) += 1;
      if (!truth.certain)
      {
        continue;
      }
      ASSERT_EQ(found[i].size(), truth.ends.size());
      for (std::size_t k = 0; k < found[i].size(); ++k)
      {
        Compare(body, planes, rays[i], found[i][k], truth.ends[k]);
      }
    }
  }

  template <class Function>
  void Compare(const ConvexBody& body, const std::vector<Definition<Function>>& planes,
    const Ray& ray, const Hit& hit, const End& truth)
  {
    ++Seen.hits;
    const double inUlps = static_cast<double>(4 * Size(hit.t - truth.t) / truth.error);
    Seen.tError = std::max(Seen.tError, inUlps);
    EXPECT_LE(inUlps, 4.0);
    const auto face = static_cast<std::size_t>(truth.face);
    for (int d = 0; d < 3; ++d)
    {
      const Float128 x = ray.origin[d] + truth.t * ray.direction[d];
      EXPECT_LE(Size(hit.position[d] - x), 2 * truth.error + 2.0 * UlpOf(hit.position[d]));
    }
    // The position is on the face up to the rounding of its coordinates, not that of t.
    const Definition<Function>& plane = planes[face];
    const Ray at{ hit.position, Vec3(0.0) };
    const Float128 off = Size(plane.Along(at, 0).c[0]);
    EXPECT_LE(off, 4.0 * std::numeric_limits<double>::epsilon() * plane.Sensitivity(at, 0));
    if (truth.gap > 0)
    {
      // The same without its piece, because the other faces are some errors away.
      const Polynomial across = plane.Along({ Vec3(0.0), body.Normal({ hit.position }) }, 0);
      EXPECT_GT(across.c[1], 0);
    }
  }
};

void CheckBodies(BodyCheck& check, RaysAbout& random)
{
  for (int k = 0; k < 40; ++k)
  {
    const double size = random.Decades(-6.0, 6.0);
    const Vec3 centre = random.Vector(k % 3 == 0 ? 0.0 : size * random.Decades(-2.0, 5.0));
    std::vector<HalfSpace> sides;
    std::vector<Definition<std::decay_t<decltype(kPlane)>>> planes;
    for (int i = 0; i < 1 + k % 9; ++i)
    {
      const Vec3 normal = random.UnitVector();
      const double shift = k % 10 == 9 ? -1.0 : 1.0;
      sides.push_back({ centre + shift * size * normal + random.Vector(0.3 * size),
        random.Decades(-100.0, 100.0) * normal });
      planes.push_back(
        Definition{ Numbers({ sides.back().point, sides.back().normal }, {}), kPlane });
    }
    check.Add(ConvexBody(sides), planes, RoundRays(random, centre, size), size, random);
  }
}

void CheckBoxes(BodyCheck& check, RaysAbout& random)
{
  for (int k = 0; k < 20; ++k)
  {
    const double size = random.Decades(-6.0, 6.0);
    const Vec3 centre = random.Vector(k % 3 == 0 ? 0.0 : size * random.Decades(-2.0, 5.0));
    const Vec3 half = size * (Vec3(0.6) + random.Vector(0.5));
    const Vec3 lower = centre - half;
    const Vec3 upper = centre + half;
    AffineMap map;
    if (k % 2 == 0)
    {
      for (int j = 0; j < 3; ++j)
      {
        map.linear[j] += random.Vector(0.5);
      }
      map.linear *= random.Decades(-2.0, 2.0);
      map.offset = random.Vector(size);
    }
    std::vector<Definition<std::decay_t<decltype(kMovedPlane)>>> planes;
    for (int i = 0; i < 6; ++i)
    {
      Vec3 normal(0.0);
      normal[i / 2] = i % 2 == 0 ? -1.0 : 1.0;
      std::vector<double> numbers = Numbers({ i % 2 == 0 ? lower : upper, normal }, {});
      for (int row = 0; row < 3; ++row)
      {
        numbers.insert(
          numbers.end(), { map.linear[0][row], map.linear[1][row], map.linear[2][row] });
      }
      numbers.insert(numbers.end(), { map.offset.x, map.offset.y, map.offset.z });
      planes.push_back(Definition{ numbers, kMovedPlane });
    }
    const Vec3 inWorld = glm::inverse(map.linear) * (centre - map.offset);
    const double inWorldSize = size / std::cbrt(std::fabs(glm::determinant(map.linear)));
    check.Add(MakeBox(lower, upper, map), planes, RoundRays(random, inWorld, inWorldSize),
      inWorldSize, random);
  }
}

/// Every hit's numbers.
std::vector<double> BitsOfHits()
{
  RaysAbout random(23);
  const ConvexBody body({ { Vec3(0.0, 0.0, 1.0), { 0.1, 0.2, 1.0 } },
    { Vec3(0.3, 0.0, -1.0), { 0.3, 0.2, -1.0 } }, { Vec3(1.0), { 3.0, 1.0, 0.4 } } });
  std::vector<double> bits;
  for (const auto& hits : MeetAll(body, RoundRays(random, Vec3(0.1), 1.0, 53)))
  {
    for (const Hit& hit : hits)
    {
      bits.insert(bits.end(), { hit.t, hit.position.x, hit.position.y, hit.position.z });
    }
  }
  return bits;
}
} // namespace

TEST(ConvexBody, BodiesAreMetAsDefined)
{
  RaysAbout random(21);
  BodyCheck check;
  CheckBodies(check, random);
  RecordProperty("errorUlpTimesCondition", std::to_string(check.Seen.tError));
  EXPECT_GT(check.Seen.certain, 1200);
  EXPECT_GT(check.Seen.uncertain, 30);
  EXPECT_GT(check.Seen.hits, 1000);
}

TEST(ConvexBody, MovedBoxesAreMetAsDefined)
{
  RaysAbout random(22);
  BodyCheck check;
  CheckBoxes(check, random);
  RecordProperty("errorUlpTimesCondition", std::to_string(check.Seen.tError));
  EXPECT_GT(check.Seen.certain, 500);
  EXPECT_GT(check.Seen.hits, 300);
}

TEST(ConvexBody, SameBitsOnEveryInstructionSet)
{
  const std::vector<double> expected = BitsOfHits();
  EXPECT_GT(expected.size(), 100U);
  OnEveryInstructionSet([&] { EXPECT_EQ(BitsOfHits(), expected); });
}

TEST(ConvexBody, BoxIsEnteredAndLeft)
{
  const ConvexBody box = MakeBox({ -1.0, -2.0, -3.0 }, { 1.0, 2.0, 3.0 });
  const Vec3 right(1.0, 0.0, 0.0);
  const auto hits = HitsOf(box, { { -4.0, 0.5, 0.25 }, right });
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0].t, 3.0);
  EXPECT_EQ(hits[1].t, 5.0);
  EXPECT_EQ(hits[1].position, Vec3(1.0, 0.5, 0.25));
  EXPECT_EQ(box.Normal({ hits[0].position }), -right);
  EXPECT_EQ(box.Normal({ hits[1].position }), right);
  // From inside, outside, along a face and along an edge, through two edges, before and after.
  EXPECT_EQ(HitsOf(box, { Vec3(0.0), right }).size(), 1U);
  EXPECT_TRUE(HitsOf(box, { { -4.0, 2.5, 0.0 }, right }).empty());
  EXPECT_EQ(HitsOf(box, { { -4.0, 2.0, 0.0 }, right }).size(), 2U);
  EXPECT_EQ(HitsOf(box, { { -4.0, 2.0, 3.0 }, right }).size(), 2U);
  EXPECT_EQ(HitsOf(box, { { -4.0, 0.0, 0.0 }, right }, 3.5).size(), 1U);
  EXPECT_EQ(HitsOf(box, { { -4.0, 0.0, 0.0 }, right }, 1.0, 4.0).size(), 1U);
  EXPECT_TRUE(HitsOf(box, { { -4.0, 0.0, 0.0 }, right }, 3.5, 4.5).empty());
  EXPECT_TRUE(HitsOf(box, { { 4.0, 0.0, 0.0 }, right }).empty());
  // The ray meets an edge only, once.
  const double h = std::sqrt(0.5);
  const ConvexBody cube = MakeBox(Vec3(-1.0), Vec3(1.0));
  EXPECT_EQ(HitsOf(cube, { { -2.0, 0.0, 0.0 }, { h, h, 0.0 } }).size(), 1U);
  // A flat one, once.
  EXPECT_EQ(
    HitsOf(MakeBox({ 0.0, -1.0, -1.0 }, { 0.0, 1.0, 1.0 }), { { -4.0, 0.0, 0.0 }, right }).size(),
    1U);
}

TEST(ConvexBody, HitsNameTheirFace)
{
  const ConvexBody box = MakeBox(Vec3(-1.0), Vec3(1.0));
  double lanes[8][kLanePadding];
  for (int i = 0; i < kLanePadding; ++i)
  {
    const double numbers[8] = { 3.0, 0.1, 0.2, i % 2 == 0 ? -1.0 : 1.0, 0.0, 0.0, kNearest,
      kNoHit };
    for (int j = 0; j < 8; ++j)
    {
      lanes[j][i] = numbers[j];
    }
  }
  HitSlots slots;
  slots.Begin(kLanePadding);
  box.Meet({ { lanes[0], lanes[1], lanes[2] }, { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7],
             kLanePadding },
    slots);
  ASSERT_EQ(slots.Count(), 2);
  for (int i = 0; i < kLanePadding; ++i)
  {
    EXPECT_EQ(slots.PointOf(0, i).piece, i % 2 == 0 ? 1 : -1);
    EXPECT_EQ(slots.PointOf(1, i).piece, i % 2 == 0 ? 0 : -1);
  }
  // The piece decides, not the position.
  SurfacePoint point{ Vec3(1.0, 0.0, 0.0) };
  point.piece = 4;
  EXPECT_EQ(box.Normal(point), Vec3(0.0, 0.0, -1.0));
}

TEST(ConvexBody, MayBeUnboundedOrEmpty)
{
  const Vec3 up(0.0, 0.0, 1.0);
  const Ray ray{ { 0.0, 0.0, -5.0 }, up };
  const ConvexBody half({ { Vec3(0.0), 7.0 * up } });
  ASSERT_EQ(HitsOf(half, ray).size(), 1U);
  EXPECT_EQ(HitsOf(half, ray)[0].t, 5.0);
  EXPECT_TRUE(HitsOf(half, { Vec3(0.0), { 1.0, 0.0, 0.0 } }).empty());
  const ConvexBody empty({ { Vec3(0.0), up }, { up, -up } });
  EXPECT_TRUE(HitsOf(empty, ray).empty());
  EXPECT_TRUE(HitsOf(empty, { { 0.0, 0.0, 0.5 }, { 1.0, 0.0, 0.0 } }).empty());
}

TEST(ConvexBody, RefusesWhatIsNoBody)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
    MessageOf([] { ConvexBody({}); }), "convex body: there is no half-space; give at least one.");
  EXPECT_EQ(MessageOf(
              [] {
                ConvexBody({ { Vec3(0.0), Vec3(0.0) } });
              }),
    "convex body: its normal is zero; give a direction.");
  EXPECT_EQ(MessageOf(
              [=] {
                ConvexBody({ { Vec3(0.0), Vec3(nan) } });
              }),
    "convex body: a coordinate of its normal is not a finite number.");
  EXPECT_EQ(MessageOf(
              [] {
                ConvexBody({ { Vec3(kNoHit), Vec3(1.0) } });
              }),
    "convex body: a coordinate of its position is not a finite number.");
  EXPECT_EQ(MessageOf([] { MakeBox(Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.5, 1.0)); }),
    "box: a lower coordinate is above the upper one; give them in order.");
  EXPECT_EQ(MessageOf([=] { MakeBox(Vec3(0.0, nan, 0.0), Vec3(1.0)); }),
    "box: a coordinate of its position is not a finite number.");
  AffineMap flat;
  flat.linear[0] = Vec3(0.0);
  EXPECT_EQ(MessageOf([=] { MakeBox(Vec3(0.0), Vec3(1.0), flat); }),
    "box: its transform has no inverse; give one that does not flatten space.");
}
} // namespace pixelexact::testing
