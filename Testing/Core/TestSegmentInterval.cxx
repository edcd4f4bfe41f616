// SPDX-License-Identifier: BSD-3-Clause
// Intervals of fields on segments against the same stored polynomials in 113 bits, at points of the
// segments inverted in 113 bits.
#include "EnclosureCases.h"
#include "InstructionSets.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Element/SegmentInterval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// A segment of the world, and where its ends come from.
struct TestSegment
{
  Vec3 xiFrom;
  Vec3 xiTo;
  Vec3 from;
  Vec3 to;
};

std::vector<Interval> IntervalsOf(const Mesh& mesh, const Field& field, int component,
  std::span<const TestSegment> segments, double slack = 0.0)
{
  std::vector<Vec3> points[4];
  for (const TestSegment& s : segments)
  {
    points[0].push_back(s.xiFrom);
    points[1].push_back(s.xiTo);
    points[2].push_back(s.from);
    points[3].push_back(s.to);
  }
  const LaneBuffer lanes[4]{ LaneBuffer(points[0]), LaneBuffer(points[1]), LaneBuffer(points[2]),
    LaneBuffer(points[3]) };
  std::vector<Interval> intervals(segments.size());
  const std::vector<double> slacks(
    static_cast<std::size_t>(PaddedCount(static_cast<int>(segments.size()))), slack);
  SegmentIntervals(mesh, field, component, 0,
    { lanes[0].View(), lanes[1].View(), lanes[2].View(), lanes[3].View(), slacks.data() },
    intervals);
  return intervals;
}

/// Segments of about this length in xi, well inside of the element and away from a pyramid's apex.
std::vector<TestSegment> SegmentsOfLength(
  const EnclosureElement& element, double length, int count, Random& random)
{
  const Mesh mesh = element.MeshView();
  std::vector<TestSegment> segments;
  while (static_cast<int>(segments.size()) < count)
  {
    TestSegment s;
    s.xiFrom = random.Inside(mesh.ShapeOf(0));
    const Vec3 way{ random(), random(), random() };
    s.xiTo = s.xiFrom + length * way;
    const bool nearApex = mesh.ShapeOf(0) == Shape::Pyramid && s.xiFrom.z > 0.5;
    if (nearApex ||
      std::min(Margin(mesh.ShapeOf(0), s.xiFrom), Margin(mesh.ShapeOf(0), s.xiTo)) < 0.02)
    {
      continue;
    }
    MapForward(mesh, 0, { &s.xiFrom, 1 }, { &s.from, 1 });
    MapForward(mesh, 0, { &s.xiTo, 1 }, { &s.to, 1 });
    segments.push_back(s);
  }
  return segments;
}

/// The component's, or the norm's, true values at points of a segment.
std::vector<double> TruthOn(const EnclosureElement& element, const TestSegment& s, int component)
{
  constexpr int kSamples = 9;
  const Mesh mesh = element.MeshView();
  const Field field = element.FieldView();
  std::vector<double> values;
  for (int k = 0; k <= kSamples; ++k)
  {
    const double t = static_cast<double>(k) / kSamples;
    const Vec3 x = s.from + t * (s.to - s.from);
    const Vec3 guess = s.xiFrom + t * (s.xiTo - s.xiFrom);
    const auto truth = WorldValuesQuad(mesh, field, 0, InvertQuad(mesh, 0, x, guess));
    double value = 0.0;
    if (component == kNormOfAll && truth.size() > 1)
    {
      for (const Quad& v : truth)
      {
        value = std::hypot(value, double(v));
      }
    }
    else
    {
      value = double(truth[static_cast<std::size_t>(std::max(component, 0))]);
    }
    values.push_back(value);
  }
  return values;
}

struct Widths
{
  int finite = 0;
  int all = 0;
  double mean = 0.0; ///< of the finite ones
};

/// Every interval holds the truth, but for the rounding of samples' points and of their values.
Widths CheckSegments(
  const EnclosureElement& element, double length, int component, int count, Random& random)
{
  Widths widths;
  const auto segments = SegmentsOfLength(element, length, count, random);
  const auto intervals =
    IntervalsOf(element.MeshView(), element.FieldView(), component, segments, 1e-15);
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Interval& interval = intervals[i];
    for (const double value : TruthOn(element, segments[i], component))
    {
      const double rounding = 4e-16 * std::fabs(value);
      EXPECT_LE(interval.lower, value + rounding);
      EXPECT_GE(interval.upper, value - rounding);
    }
    ++widths.all;
    if (interval.IsFinite())
    {
      ++widths.finite;
      widths.mean += interval.Width();
    }
  }
  widths.mean /= std::max(widths.finite, 1);
  return widths;
}

EnclosureElement ElementOf(
  Shape shape, Form form, int mapOrder, int fieldOrder, Random& random, Mapping mapping = {})
{
  EnclosureCase c;
  c.shape = shape;
  c.form = form;
  c.mapOrder = mapOrder;
  c.fieldOrder = fieldOrder;
  c.mapping = mapping;
  c.components = mapping == Mapping::Covariant || mapping == Mapping::Contravariant ? 3 : 1;
  return { c, random };
}
} // namespace

TEST(SegmentInterval, HoldsTheTruthForAllShapesAndOrders)
{
  Random random(31);
  for (const auto& [shape, form] : ShapesAndForms())
  {
    for (const int mapOrder : { 1, 2, 3 })
    {
      for (int fieldOrder = 1; fieldOrder <= 8; ++fieldOrder)
      {
        SCOPED_TRACE(std::string(Name(shape)) + " map " + std::to_string(mapOrder) + " field " +
          std::to_string(fieldOrder));
        const EnclosureElement element = ElementOf(shape, form, mapOrder, fieldOrder, random);
        for (const double length : { 1e-1, 1e-2, 1e-4 })
        {
          const Widths widths = CheckSegments(element, length, 0, 6, random);
          EXPECT_TRUE(length > 0.01 || widths.finite == widths.all) << length;
        }
      }
    }
  }
}

TEST(SegmentInterval, HoldsTheTruthOnEveryInstructionSet)
{
  OnEveryInstructionSet(
    []
    {
      Random random(32);
      for (const auto& [shape, form] : ShapesAndForms())
      {
        const EnclosureElement element = ElementOf(shape, form, 3, 5, random);
        const Widths widths = CheckSegments(element, 1e-2, 0, 12, random);
        EXPECT_EQ(widths.finite, widths.all);
      }
    });
}

TEST(SegmentInterval, HoldsMappedComponentsAndTheirNorm)
{
  Random random(33);
  for (const Mapping mapping : { Mapping::Covariant, Mapping::Contravariant, Mapping::Density })
  {
    const EnclosureElement element =
      ElementOf(Shape::Hexahedron, Form::Collapsed, 3, 4, random, mapping);
    for (const int component : { 0, kNormOfAll })
    {
      const Widths widths = CheckSegments(element, 1e-3, component, 12, random);
      EXPECT_EQ(widths.finite, widths.all);
    }
  }
}

/// A norm's interval is that of one number: of a scalar its own, sign and all.
TEST(SegmentInterval, NormOfAScalarIsTheScalar)
{
  Random random(34);
  const EnclosureElement element = ElementOf(Shape::Tetrahedron, Form::Collapsed, 2, 3, random);
  const auto segments = SegmentsOfLength(element, 1e-2, 8, random);
  const auto own = IntervalsOf(element.MeshView(), element.FieldView(), 0, segments);
  const auto norm = IntervalsOf(element.MeshView(), element.FieldView(), kNormOfAll, segments);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    EXPECT_EQ(own[i].lower, norm[i].lower);
    EXPECT_EQ(own[i].upper, norm[i].upper);
  }
}

TEST(SegmentInterval, ShrinksWithTheSegment)
{
  Random random(35);
  for (const auto& [shape, form] : ShapesAndForms())
  {
    for (const int fieldOrder : { 2, 4, 8 })
    {
      const EnclosureElement element = ElementOf(shape, form, 3, fieldOrder, random);
      const auto widthAt = [&](double length)
      {
        Random same(36);
        return CheckSegments(element, length, 0, 20, same).mean;
      };
      const double coarse = widthAt(1e-3);
      for (const int times : { 2, 16, 128 })
      {
        const double ratio = coarse / widthAt(1e-3 / times);
        EXPECT_GT(ratio, 0.7 * times) << Name(shape) << fieldOrder;
        EXPECT_LT(ratio, 1.4 * times) << Name(shape) << fieldOrder;
      }
    }
  }
}

/// The ends lie in the element, what is between does not: beyond a face that bulges inwards.
TEST(SegmentInterval, SaysNothingOfSegmentsThatLeaveTheElement)
{
  MeshBuilder mesh;
  // The face xi3 = -1 is z = -1 + (x^2 + y^2) / 2 upside down: lowest at its edges.
  mesh.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) {
      return LongVec3{ xi[0], xi[1], xi[2] - 0.25L * (xi[0] * xi[0] - 1) };
    });
  ExpansionBuilder values(1);
  values.Add(
    UniformSpace(Shape::Hexahedron, 2), [](const LongVec3& xi, long double* u) { u[0] = xi[2]; });
  const Field field{ "u", values.View() };
  const auto segmentAt = [&](double a, double height)
  {
    TestSegment s;
    s.xiFrom = { -a, 0.1, -1.0 + height };
    s.xiTo = { a, 0.1, -1.0 + height };
    MapForward(mesh.View(), 0, { &s.xiFrom, 1 }, { &s.from, 1 });
    MapForward(mesh.View(), 0, { &s.xiTo, 1 }, { &s.to, 1 });
    return s;
  };
  // Half-way the chord lies by 0.25 a^2 lower in xi3.
  const std::vector<TestSegment> segments{ segmentAt(0.1, 0.002), segmentAt(0.1, 0.02) };
  const auto intervals = IntervalsOf(mesh.View(), field, 0, segments);
  EXPECT_FALSE(intervals[0].IsFinite());
  EXPECT_TRUE(intervals[1].IsFinite());
  EXPECT_TRUE(intervals[1].Contains(-0.98 - 0.0025));
}

TEST(SegmentInterval, SaysNothingWhereNothingIsProven)
{
  Random random(37);
  const EnclosureElement element = ElementOf(Shape::Hexahedron, Form::Collapsed, 3, 3, random);
  const auto good = SegmentsOfLength(element, 1e-3, 1, random).front();
  const double nan = std::nan("");
  std::vector<TestSegment> bad(5, good);
  bad[0].xiFrom.x += 2.0;
  bad[1].from.y = nan;
  bad[2].xiTo.z = nan;
  bad[3].to = good.to + Vec3(0.5);
  bad[4].to.x = std::numeric_limits<double>::infinity();
  const Mesh mesh = element.MeshView();
  for (const Interval& interval : IntervalsOf(mesh, element.FieldView(), 0, bad))
  {
    EXPECT_FALSE(interval.IsFinite());
  }
  EnclosureElement broken = ElementOf(Shape::Hexahedron, Form::Collapsed, 3, 3, random);
  broken.Values.Coefficients[3] = nan;
  const std::vector<TestSegment> one{ SegmentsOfLength(broken, 1e-3, 1, random).front() };
  EXPECT_FALSE(IntervalsOf(broken.MeshView(), broken.FieldView(), 0, one).front().IsFinite());
}

/// The paper's example: 3 x^2 + 2 x - 4 on [-1,1] has values in [-4.33, 1]. Subdivided intervals
/// are narrower and still contain the values.
TEST(SegmentInterval, PapersExample)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  ExpansionBuilder values(1);
  values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi, long double* u) { u[0] = 3 * xi[0] * xi[0] + 2 * xi[0] - 4; });
  const Field field{ "u", values.View() };
  Interval last = Interval::Everything();
  for (const int parts : { 1, 10, 100 })
  {
    std::vector<TestSegment> segments;
    for (int k = 0; k < parts; ++k)
    {
      const Vec3 from{ -1.0 + 2.0 * k / parts, 0.0, 0.0 };
      const Vec3 to{ -1.0 + 2.0 * (k + 1) / parts, 0.0, 0.0 };
      segments.push_back({ from, to, from, to });
    }
    const auto intervals = IntervalsOf(mesh.View(), field, 0, segments);
    Interval hull = intervals.front();
    for (const Interval& interval : intervals)
    {
      hull = Join(hull, interval);
    }
    EXPECT_TRUE(hull.Contains(Interval(-13.0 / 3.0 + 1e-15, 1.0)));
    EXPECT_TRUE(last.Contains(hull));
    last = hull;
  }
  // The paper has [-4.37, 1] for 100 intervals.
  EXPECT_NEAR(last.lower, -4.37, 0.02);
  EXPECT_NEAR(last.upper, 1.0, 0.05);
}
} // namespace pixelexact::testing
