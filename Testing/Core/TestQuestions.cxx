// SPDX-License-Identifier: BSD-3-Clause
// Crossings of segments with faces and values of curved elements, against marching in 113 bits and
// closed forms: none lost, none invented, none twice.
#include "MeshBuilder.h"
#include "QuadLine.h"
#include "RangeCases.h"

#include "Core/Base/Error.h"
#include "Core/Questions/Questions.h"

#include <gtest/gtest.h>

#include <limits>

namespace pixelexact::testing
{
namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Straight at the apex, where the functions of pyramids are rational.
LongVec3 Bent(const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  return { a + 0.1L * c * c, b + 0.08L * c * (1 + c) - 0.1L * a, c + 0.05L * b };
}

MeshBuilder::Map MapFor(Shape shape)
{
  return shape == Shape::Pyramid ? Bent : Curved;
}

/// Of this order, on every shape.
MeshBuilder::Map MapOf(Shape shape, int order)
{
  return [=](const LongVec3& xi)
  {
    const auto [a, b, c] = xi;
    const long double size = order == 1 ? 0.0L : 0.03L;
    const LongVec3 bump{ std::pow(b, order), std::pow(c, order), std::pow(a, order) };
    return Plus(order < 3 ? xi : MapFor(shape)(xi), Times(size, bump));
  };
}

/// An element with a field and what is asked of it.
struct Asked : RangeCase
{
  explicit Asked(Shape shape)
    : Asked(shape, 3, MapFor(shape))
  {
  }
  Asked(Shape shape, int mapOrder, const MeshBuilder::Map& itsMap)
    : RangeCase(UniformSpace(shape, mapOrder), itsMap)
    , map(itsMap)
    , index(mesh)
  {
  }

  void SetPolynomial(int order, const std::function<long double(const LongVec3& x)>& function)
  {
    ExpansionBuilder made(1);
    made.Add(UniformSpace(mesh.ShapeOf(0), order),
      [&](const LongVec3& xi, long double* value) { *value = function(map(xi)); });
    SetField(made.Spaces[0], made.Coefficients);
  }

  [[nodiscard]] Vec3 PointOf(const Vec3& xi) const
  {
    const auto phi = EvaluateQuad(mesh.map, 0, { xi.x, xi.y, xi.z });
    return { static_cast<double>(phi[0].value), static_cast<double>(phi[1].value),
      static_cast<double>(phi[2].value) };
  }

  /// Through two points of the shape, beyond them by a part of their distance.
  [[nodiscard]] Segment Through(const Vec3& a, const Vec3& b, double beyond) const
  {
    const Vec3 from = PointOf(a);
    const Vec3 step = beyond * (PointOf(b) - from);
    return { from - step, PointOf(b) + step };
  }

  [[nodiscard]] LevelFunction Less(double value) const
  {
    return [this, value](const QuadVec3& xi)
    { return EvaluateQuad(field.values, 0, xi)[0].value - Quad(value); };
  }

  [[nodiscard]] double ValueAt(const Vec3& xi) const
  {
    return static_cast<double>(EvaluateQuad(field.values, 0, { xi.x, xi.y, xi.z })[0].value);
  }

  MeshBuilder::Map map;
  ElementIndex index;
};

/// The distances to the planes of the faces, as FacesOf orders them.
std::vector<Quad> FaceDistances(Shape shape, const QuadVec3& xi)
{
  const Quad one(1);
  std::vector<Quad> distances;
  for (const ShapeFace& face : FacesOf(shape))
  {
    const auto d = static_cast<std::size_t>(face.direction);
    if (!face.upper)
    {
      distances.push_back(one + xi[d]);
    }
    else if (shape == Shape::Tetrahedron)
    {
      distances.push_back(Quad(-1) - xi[0] - xi[1] - xi[2]);
    }
    else if (shape == Shape::Pyramid || (shape == Shape::Prism && d == 0))
    {
      distances.push_back(Quad(0) - xi[d] - xi[2]);
    }
    else
    {
      distances.push_back(one - xi[d]);
    }
  }
  return distances;
}

/// The least distance but that of one face; of all for -1.
double MarginBut(Shape shape, const Vec3& xi, int face)
{
  const auto distances = FaceDistances(shape, { xi.x, xi.y, xi.z });
  double least = 1e300;
  for (int f = 0; f < static_cast<int>(distances.size()); ++f)
  {
    least = f == face
      ? least
      : std::min(least, static_cast<double>(distances[static_cast<std::size_t>(f)]));
  }
  return least;
}

struct Tally
{
  int certain = 0;
  int open = 0; ///< crossings that marching shows and that are undecided
  int undecided = 0;
};

/// Compares an answer with what marching shows; `face` as in MarginBut.
void Compare(const Asked& one, const QuadLine& line, const Crossings& answer,
  const std::vector<QuadCrossing>& known, int face, Tally& tally)
{
  const Shape shape = one.mesh.ShapeOf(0);
  std::vector<int> held(answer.found.size(), 0);
  for (const QuadCrossing& crossing : known)
  {
    const double margin = MarginBut(shape, crossing.xi, face);
    int holders = 0;
    for (std::size_t i = 0; i < answer.found.size(); ++i)
    {
      const Interval& t = answer.found[i].t;
      const bool holds = crossing.t >= t.lower - 1e-15 && crossing.t <= t.upper + 1e-15;
      holders += holds ? 1 : 0;
      held[i] += holds ? 1 : 0;
    }
    const bool open = std::ranges::any_of(
      answer.undecided, [&](const UndecidedCrossing& box) { return box.t.Contains(crossing.t); });
    EXPECT_LE(holders, 1) << "twice: t = " << crossing.t;
    EXPECT_TRUE(holders == 1 || open || margin < 1e-9)
      << Name(shape) << ": lost at t = " << crossing.t << ", margin " << margin;
    EXPECT_TRUE(holders == 0 || margin > -1e-9) << Name(shape) << ": beyond, t = " << crossing.t;
    tally.certain += holders;
    tally.open += holders == 0 && open ? 1 : 0;
  }
  for (std::size_t i = 0; i < held.size(); ++i)
  {
    const Crossing& crossing = answer.found[i];
    EXPECT_TRUE(held[i] == 1 || line.ChangesSign(crossing.t.lower, crossing.t.upper, crossing.xi))
      << Name(shape) << ": invented at t = " << crossing.middle;
    EXPECT_LT(crossing.t.Width(), 1e-6);
    EXPECT_GE(Margin(shape, crossing.xi), -1e-9);
  }
  tally.undecided += static_cast<int>(answer.undecided.size());
}

Interval Hull(const std::vector<UndecidedCrossing>& undecided)
{
  Interval t = undecided.front().t;
  for (const UndecidedCrossing& box : undecided)
  {
    t = Join(t, box.t);
  }
  return t;
}
} // namespace

TEST(Questions, ValuesOfNoiseAgainstMarching)
{
  Random random(41);
  Tally tally;
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 2, 3, 4, 5, 6, 7, 8, 16 })
    {
      if (order == 16 && shape != Shape::Hexahedron)
      {
        continue;
      }
      Asked one(shape);
      one.SetNoise(order, random, 0.8);
      ElementQuestions questions(one.index, 0, one.field, 0);
      for (int repeat = 0; repeat < 2; ++repeat)
      {
        const Vec3 a = random.Inside(shape);
        const Vec3 b = random.Inside(shape);
        const Segment segment = one.Through(a, b, 0.1);
        const double value = 0.5 * (one.ValueAt(a) + one.ValueAt(b));
        const Crossings answer = questions.WithValue(segment, value);
        const QuadLine line(one.mesh, 0, segment, one.Less(value));
        Compare(one, line, answer, line.March(0.1 / 1.2, a, 40), -1, tally);
      }
    }
  }
  std::cout << tally.certain << " certain, " << tally.open << " open, " << tally.undecided
            << " undecided boxes\n";
  EXPECT_GT(tally.certain, 80);
  EXPECT_EQ(tally.undecided, 0);
}

TEST(Questions, FacesAgainstMarching)
{
  Random random(42);
  Tally tally;
  for (const Shape shape : kShapes)
  {
    const auto faces = FacesOf(shape);
    EXPECT_EQ(faces.size(),
      shape == Shape::Hexahedron      ? 6U
        : shape == Shape::Tetrahedron ? 4U
                                      : 5U);
    for (int repeat = 0; repeat < 8; ++repeat)
    {
      Asked one(shape, repeat + 1, MapOf(shape, repeat + 1));
      ElementQuestions questions(one.index, 0);
      const Vec3 a = random.Inside(shape);
      const Segment segment = one.Through(a, random.Inside(shape), 0.5);
      for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      {
        const QuadLine line(one.mesh, 0, segment,
          [&](const QuadVec3& xi)
          { return FaceDistances(shape, xi)[static_cast<std::size_t>(f)]; });
        const Crossings answer = questions.WithFace(segment, faces[static_cast<std::size_t>(f)]);
        Compare(one, line, answer, line.March(0.25, a, 12), f, tally);
      }
    }
  }
  std::cout << tally.certain << " certain, " << tally.open << " open, " << tally.undecided
            << " undecided boxes\n";
  EXPECT_GT(tally.certain, 30);
  EXPECT_EQ(tally.undecided, 0);
}

/// G(x) = (n . x - c_1) ... (n . x - c_k) of world x: roots on each line in closed form.
TEST(Questions, ManyRootsOnOneSegment)
{
  const LongVec3 normal{ 0.8L, 0.36L, 0.48L };
  for (const Shape shape : kShapes)
  {
    const bool hexahedron = shape == Shape::Hexahedron;
    for (int roots = 1; roots <= (hexahedron ? 4 : 3); ++roots)
    {
      std::vector<long double> level(static_cast<std::size_t>(roots));
      for (int i = 0; i < roots; ++i)
      {
        level[static_cast<std::size_t>(i)] = -1.2L + 0.15L * i;
      }
      Asked one(shape, 2, Bent);
      one.SetPolynomial(2 * roots,
        [&](const LongVec3& x)
        {
          long double product = 1.0L;
          for (const long double c : level)
          {
            product *= Dot(normal, x) - c;
          }
          return product;
        });
      ElementQuestions questions(one.index, 0, one.field, 0);
      const Segment segment = one.Through({ -0.98, -0.8, -0.7 }, { -0.35, -0.4, -0.3 }, 0.0);
      const long double start = Dot(normal, ToLong(segment.from));
      const long double end = Dot(normal, ToLong(segment.to));
      const Crossings answer = questions.WithValue(segment, 0.0);
      EXPECT_TRUE(answer.IsComplete()) << Name(shape) << ' ' << roots;
      ASSERT_EQ(answer.found.size(), level.size()) << Name(shape);
      for (std::size_t i = 0; i < level.size(); ++i)
      {
        EXPECT_NEAR(
          static_cast<double>((level[i] - start) / (end - start)), answer.found[i].middle, 1e-10);
        EXPECT_EQ(answer.found[i].status, CrossingStatus::Certain);
      }
    }
  }
}

/// At a corner of eight pieces, and of ever more nodes: found in many, listed once.
TEST(Questions, MapsOfVeryHighOrderLoseNothing)
{
  // The tree of such a smooth map begins with one piece, the conversion of its nodes with 512.
  const Space low = UniformSpace(Shape::Hexahedron, 3);
  const Space high = UniformSpace(Shape::Hexahedron, 24);
  MeshBuilder mesh;
  mesh.Add(low, Curved);
  const std::vector<double> few = mesh.Phi.Coefficients;
  const auto each = static_cast<std::size_t>(high.Modes());
  mesh.Phi.Spaces = { high };
  mesh.Phi.Coefficients.assign(3 * each, 0.0);
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::size_t from = c * static_cast<std::size_t>(low.Modes());
    ForEachMode(high,
      [&](int p, int q, int r, int mode)
      {
        if (p <= 3 && q <= 3 && r <= 3)
        {
          mesh.Phi.Coefficients[c * each + static_cast<std::size_t>(mode)] = few[from++];
        }
      });
  }
  ExpansionBuilder x(1);
  x.Add(low, [](const LongVec3& xi, long double* value) { *value = Curved(xi)[0]; });
  const Mesh view = mesh.View();
  const ElementIndex index(view);
  const Field field{ "x", x.View() };
  ElementQuestions questions(index, 0, field, 0);
  const Segment segment{ { -0.8, 0.1, 0.2 }, { 0.8, 0.1, 0.2 } };
  for (const double value : { -0.6, 0.2, 0.7 })
  {
    const Crossings crossings = questions.WithValue(segment, value);
    EXPECT_TRUE(crossings.IsComplete()) << value;
    ASSERT_EQ(crossings.found.size(), 1U) << value;
    // F is x, which is -0.8 + 1.6 t on the segment.
    EXPECT_NEAR(crossings.found[0].middle, (value + 0.8) / 1.6, 1e-9);
  }
}

TEST(Questions, RootsBetweenNodesAreListedOnce)
{
  RangeCase one(UniformSpace(Shape::Hexahedron, 8), [](const LongVec3& xi) { return xi; });
  const ElementIndex index(one.mesh);
  std::vector<double> modes(one.mesh.map.SpaceOf(0).Modes(), 0.0);
  modes[9] = 0.25;
  modes[81] = 1.0;
  modes[1] = 0.5;
  one.SetField(UniformSpace(Shape::Hexahedron, 8), modes);
  ElementQuestions questions(index, 0, one.field, 0);
  for (const Vec3& direction : { Vec3(1, 1, 1), Vec3(1, 0, 0), Vec3(0.5, 1, -0.25), Vec3(0, 1, 1) })
  {
    const Crossings answer = questions.WithValue({ -direction, direction }, 0.0);
    ASSERT_EQ(answer.found.size(), 1U);
    EXPECT_TRUE(answer.IsComplete());
    EXPECT_TRUE(answer.found[0].t.Contains(0.5));
    EXPECT_EQ(answer.found[0].status, CrossingStatus::Certain);
    EXPECT_LT(answer.found[0].t.Width(), 1e-12);
  }
  const Segment across{ { 0.0, 0.0, -2.0 }, { 0.0, 0.0, 2.0 } };
  const Crossings face = questions.WithFace(across, { 2, true });
  ASSERT_EQ(face.found.size(), 1U);
  EXPECT_TRUE(face.IsComplete());
  EXPECT_TRUE(face.found[0].t.Contains(0.75));
  EXPECT_EQ(face.found[0].eta[2].lower, 1.0);
}

/// (n . x - c)^2 - gap^2: one double root, or two near each other.
TEST(Questions, TangentsAreNeverWrong)
{
  for (const Shape shape : kShapes)
  {
    for (const double gap : { 0.0, 1e-9, 1e-6, 1e-4, 1e-2 })
    {
      Asked one(shape, 2, Bent);
      one.SetPolynomial(4,
        [](const LongVec3& x)
        {
          const long double level = x[0] + 0.5L * x[1] + 0.25L * x[2] + 0.8L;
          return level * level;
        });
      ElementQuestions questions(one.index, 0, one.field, 0);
      const Segment segment{ { -0.9, -0.6, -0.7 }, { 0.4, -0.5, -0.4 } };
      const Crossings answer = questions.WithValue(segment, gap * gap);
      const double start = -0.9 - 0.3 - 0.175 + 0.8;
      const double end = 0.4 - 0.25 - 0.1 + 0.8;
      const double t = -start / (end - start);
      const double apart = gap / (end - start);
      if (gap >= 1e-4)
      {
        ASSERT_EQ(answer.found.size(), 2U) << Name(shape) << ' ' << gap;
        EXPECT_TRUE(answer.IsComplete());
        EXPECT_NEAR(answer.found[0].middle, t - apart, 1e-7 * gap + 1e-9);
        EXPECT_NEAR(answer.found[1].middle, t + apart, 1e-7 * gap + 1e-9);
        continue;
      }
      // The stored coefficients' rounding decides whether there are two roots or none.
      EXPECT_NE(answer.found.size(), 1U);
      if (answer.found.empty())
      {
        ASSERT_FALSE(answer.undecided.empty());
        EXPECT_TRUE(Hull(answer.undecided).Contains(t));
        EXPECT_LT(Hull(answer.undecided).Width(), 1e-5) << Name(shape);
      }
      EXPECT_LT(answer.boxes, 4000) << Name(shape);
    }
  }
}

TEST(Questions, SegmentsThatMissGrazeLieInAFaceOrEndInside)
{
  Random random(43);
  for (const Shape shape : kShapes)
  {
    // Straight, so that a segment can lie in a face.
    RangeCase one(UniformSpace(shape, 2), [](const LongVec3& xi) { return xi; });
    const ElementIndex index(one.mesh);
    ExpansionBuilder made(1);
    made.Add(UniformSpace(shape, 2),
      [](const LongVec3& xi, long double* value) { *value = xi[0] + xi[0] * xi[1] / 8; });
    one.SetField(made.Spaces[0], made.Coefficients);
    ElementQuestions questions(index, 0, one.field, 0);

    // Beyond all faces.
    const Segment miss{ { -3.0, -1.01, 0.5 }, { 3.0, -1.01, 0.4 } };
    const Crossings none = questions.WithValue(miss, 0.0);
    EXPECT_TRUE(none.IsComplete() && none.found.empty());
    for (const ShapeFace& face : FacesOf(shape))
    {
      const Crossings nothing = questions.WithFace(miss, face);
      EXPECT_TRUE(nothing.IsComplete() && nothing.found.empty()) << Name(shape);
    }

    // In the face xi2 = -1: its value is met on the face, where a neighbour may have it too.
    const Segment within{ { -0.95, -1.0, -0.7 }, { 0.2, -1.0, -0.6 } };
    const Crossings level = questions.WithValue(within, -0.4);
    ASSERT_EQ(level.found.size(), 1U);
    EXPECT_TRUE(level.IsComplete());
    EXPECT_EQ(level.found[0].status, CrossingStatus::OnBoundary);
    const double x = -0.4 / 0.875;
    EXPECT_NEAR(level.found[0].middle, (x + 0.95) / 1.15, 1e-12);
    // With the face itself it has no crossing that could be isolated.
    const Crossings plane = questions.WithFace(within, { 1, false });
    EXPECT_TRUE(plane.found.empty());
    ASSERT_FALSE(plane.undecided.empty());
    EXPECT_TRUE(Hull(plane.undecided).Contains(Interval(0.001, 0.999)));

    // Out of the element through xi2 = -1, and short of it.
    const Segment out{ { -0.5, -0.5, -0.8 }, { -0.6, -1.5, -0.7 } };
    const Crossings through = questions.WithFace(out, { 1, false });
    ASSERT_EQ(through.found.size(), 1U);
    EXPECT_TRUE(through.found[0].t.Contains(0.5));
    EXPECT_EQ(through.found[0].status, CrossingStatus::Certain);
    const Crossings shortOf =
      questions.WithFace({ out.from, out.from + 0.499 * (out.to - out.from) }, { 1, false });
    EXPECT_TRUE(shortOf.IsComplete() && shortOf.found.empty());
    const Crossings atEnd = questions.WithFace({ out.from, { -0.55, -1.0, -0.75 } }, { 1, false });
    ASSERT_EQ(atEnd.found.size(), 1U);
    EXPECT_EQ(atEnd.found[0].status, CrossingStatus::AtEnd);

    // Near to an edge of the face, on either side of it.
    for (const double beside : { 1e-13, 1e-10 })
    {
      for (const double side : { -1.0, 1.0 })
      {
        const double a = -1.0 + side * beside;
        const Crossings edge =
          questions.WithFace({ { a, -2.0, -0.5 }, { a, 0.0, -0.5 } }, { 1, false });
        EXPECT_TRUE(edge.IsComplete());
        EXPECT_EQ(edge.found.size(), side > 0.0 ? 1U : 0U) << Name(shape) << ' ' << beside;
      }
    }
    // In the edge's plane: whether the segment meets the face is a matter of rounding.
    const Crossings edge =
      questions.WithFace({ { -1.0, -2.0, -0.5 }, { -1.0, 0.0, -0.5 } }, { 1, false });
    ASSERT_EQ(edge.found.size(), 1U);
    EXPECT_EQ(edge.found[0].status, CrossingStatus::OnBoundary);
  }
}

/// Collapsed vertices and edges have no proven roots: they are undecided, and nothing is lost.
TEST(Questions, CollapsedVerticesAreUndecided)
{
  for (const Shape shape : { Shape::Prism, Shape::Tetrahedron, Shape::Pyramid })
  {
    RangeCase one(UniformSpace(shape, 2), [](const LongVec3& xi) { return xi; });
    const ElementIndex index(one.mesh);
    ExpansionBuilder made(1);
    made.Add(
      UniformSpace(shape, 2), [](const LongVec3& xi, long double* value) { *value = xi[2]; });
    one.SetField(made.Spaces[0], made.Coefficients);
    ElementQuestions questions(index, 0, one.field, 0);
    const Vec3 tip(-1.0, shape == Shape::Prism ? 0.25 : -1.0, 1.0);
    const Segment segment{ tip - Vec3(0.0, 0.0, 1.0), tip };
    const Crossings half = questions.WithValue(segment, 0.5);
    EXPECT_EQ(half.found.size(), 1U);
    const Crossings at = questions.WithValue(segment, 1.0);
    EXPECT_TRUE(at.found.empty());
    ASSERT_FALSE(at.IsComplete());
    EXPECT_TRUE(Hull(at.undecided).Contains(1.0));
    // Next to it there is a proven root, or the little that is not decided holds it.
    for (const double by : { 1e-3, 1e-6 })
    {
      const Crossings near = questions.WithValue(
        { tip + by * Vec3(1.0, 1.0, -4.0), tip + by * Vec3(1.0, 1.0, -12.0) }, 1.0 - 8.0 * by);
      if (near.IsComplete() || by > 1e-4)
      {
        EXPECT_TRUE(near.IsComplete());
        ASSERT_EQ(near.found.size(), 1U) << Name(shape);
        EXPECT_NEAR(near.found[0].middle, 0.5, 1e-6);
        continue;
      }
      EXPECT_TRUE(near.found.empty());
      EXPECT_TRUE(Hull(near.undecided).Contains(0.5));
      EXPECT_LT(Hull(near.undecided).Width(), 1e-3);
    }
  }
}

TEST(Questions, BadInputProvesNothing)
{
  Random random(44);
  Asked one(Shape::Tetrahedron);
  one.SetNoise(4, random, 0.5);
  ElementQuestions questions(one.index, 0, one.field, 0);
  const Vec3 inside = one.PointOf({ -0.6, -0.6, -0.6 });
  const double infinity = std::numeric_limits<double>::infinity();
  const double value = one.ValueAt(Vec3(-0.6));
  for (const Segment& segment : { Segment{ inside, inside }, Segment{ inside, Vec3(kNaN) },
         Segment{ { kNaN, 0.0, 0.0 }, inside }, Segment{ inside, Vec3(infinity) },
         Segment{ Vec3(-1.7e308), Vec3(1.7e308) } })
  {
    for (const Crossings& answer :
      { questions.WithValue(segment, value), questions.WithFace(segment, { 0, false }) })
    {
      EXPECT_TRUE(answer.found.empty());
    }
    EXPECT_FALSE(questions.WithValue(segment, value).IsComplete());
  }
  const Crossings away = questions.WithValue({ Vec3(9.0), Vec3(9.0) }, value);
  EXPECT_TRUE(away.IsComplete() && away.found.empty());
  EXPECT_TRUE(questions.WithValue({ Vec3(-1.0), inside }, kNaN).found.empty());
  EXPECT_TRUE(questions.WithValue({ Vec3(-1.0), inside }, infinity).found.empty());

  one.values[3] = kNaN;
  one.field.values.coefficients = one.values;
  ElementQuestions unsound(one.index, 0, one.field, 0);
  const Crossings nothing = unsound.WithValue({ Vec3(-1.0), inside }, value);
  EXPECT_TRUE(nothing.found.empty());
  EXPECT_FALSE(nothing.IsComplete());

  ElementQuestions noField(one.index, 0);
  EXPECT_THROW(noField.WithValue({ Vec3(-1.0), inside }, 0.0), InvalidData);
  one.field.mapping = Mapping::Density;
  EXPECT_THROW(ElementQuestions(one.index, 0, one.field, 0), Unsupported);
}

/// Of rays from afar (ElementIndex::ClipRay) nobody knows exactly where they are.
TEST(Questions, WhereASegmentMayBeOffTheAnswerHoldsAllThatItMayBe)
{
  constexpr double kSlack = 1e-6;
  Random random(47);
  int found = 0;
  for (const Shape shape : kShapes)
  {
    Asked one(shape);
    one.SetNoise(3, random, 0.5);
    ElementQuestions questions(one.index, 0, one.field, 0);
    for (int i = 0; i < 12; ++i)
    {
      Segment segment = one.Through(random.Inside(shape), random.Inside(shape), 0.5);
      const double value = one.ValueAt(random.Inside(shape));
      segment.slack = kSlack;
      const Crossings wide[] = { questions.WithValue(segment, value),
        questions.WithFace(segment, FacesOf(shape)[static_cast<std::size_t>(i) % 4]) };
      Segment moved;
      for (int d = 0; d < 3; ++d)
      {
        moved.from[d] = segment.from[d] + kSlack * random();
        moved.to[d] = segment.to[d] + kSlack * random();
      }
      const Crossings exact[] = { questions.WithValue(moved, value),
        questions.WithFace(moved, FacesOf(shape)[static_cast<std::size_t>(i) % 4]) };
      for (int k = 0; k < 2; ++k)
      {
        const auto meets = [](const Crossing& crossing)
        { return [&](const auto& other) { return !Intersect(other.t, crossing.t).IsEmpty(); }; };
        for (const Crossing& crossing : exact[k].found)
        {
          ++found;
          EXPECT_TRUE(std::ranges::any_of(wide[k].found, meets(crossing)) ||
            std::ranges::any_of(wide[k].undecided, meets(crossing)))
            << Name(shape) << i;
        }
      }
    }
  }
  EXPECT_GT(found, 20);
}

/// Whatever was asked before, and with little effort what is not decided is said to be.
TEST(Questions, AnswersDependOnTheQuestionAlone)
{
  Random random(45);
  Asked one(Shape::Prism);
  one.SetNoise(5, random, 0.8);
  ElementQuestions used(one.index, 0, one.field, 0);
  for (int repeat = 0; repeat < 20; ++repeat)
  {
    const Segment segment =
      one.Through(random.Inside(Shape::Prism), random.Inside(Shape::Prism), 0.2);
    const Crossings again = used.WithValue(segment, 0.05);
    const ElementIndex fresh(one.mesh);
    ElementQuestions first(fresh, 0, one.field, 0);
    const Crossings alone = first.WithValue(segment, 0.05);
    ASSERT_EQ(alone.found.size(), again.found.size());
    EXPECT_EQ(alone.boxes, again.boxes);
    EXPECT_EQ(alone.nodes, again.nodes);
    for (std::size_t i = 0; i < alone.found.size(); ++i)
    {
      EXPECT_EQ(alone.found[i].t.lower, again.found[i].t.lower);
      EXPECT_EQ(alone.found[i].t.upper, again.found[i].t.upper);
    }
    for (const QuestionEffort effort : { QuestionEffort{ 1, 1 }, { 3, 10 }, { 10, 3 }, { 0, 0 } })
    {
      const Crossings less = used.WithValue(segment, 0.05, effort);
      EXPECT_LE(less.boxes, std::max(effort.boxes, 1));
      for (const Crossing& crossing : alone.found)
      {
        const auto holds = [&](const auto& other)
        { return !Intersect(other.t, crossing.t).IsEmpty(); };
        EXPECT_TRUE(
          std::ranges::any_of(less.found, holds) || std::ranges::any_of(less.undecided, holds));
      }
    }
  }
}

/// An uncertain mesh: crossings hold for every map that is moved within its uncertainty.
TEST(Questions, UncertaintyOfTheMeshIsInTheEnclosures)
{
  for (const double uncertainty : { 0.0, 1e-9 })
  {
    MeshBuilder builder;
    builder.Add(UniformSpace(Shape::Hexahedron, 3), Curved, { 100.0, 0.0, 0.0 }, 0.5);
    builder.Uncertainty[0] = uncertainty;
    const Mesh mesh = builder.View();
    const ElementIndex index(mesh);
    ElementQuestions questions(index, 0);
    const Segment segment{ { 0.1, 0.2, -3.0 }, { 0.15, 0.1, 3.0 } };
    const Crossings answer = questions.WithFace(segment, { 2, true });
    ASSERT_EQ(answer.found.size(), 1U);
    EXPECT_EQ(answer.found[0].status, CrossingStatus::Certain);
    const double width = answer.found[0].t.Width();
    EXPECT_GE(width, uncertainty / 3.0);
    EXPECT_LE(width, uncertainty + 1e-12);
  }
}
} // namespace pixelexact::testing
