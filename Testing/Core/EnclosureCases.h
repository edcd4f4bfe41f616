// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"
#include "QuadReference.h"

#include "Core/Element/Enclosure.h"
#include "Core/Location/Sample.h"

// Manufactured elements with random fields, their enclosures, and what the values truly are.
namespace pixelexact::testing
{
/// Properties of an element.
struct EnclosureCase
{
  Shape shape = Shape::Hexahedron;
  Form form = Form::Collapsed;
  int mapOrder = 3;
  int fieldOrder = 4;
  double size = 1.0; ///< a power of two
  double offset = 0; ///< of the centre, in sizes
  double fieldScale = 1.0;
  int components = 1;
  Mapping mapping = Mapping::Identity;
};

inline std::vector<std::pair<Shape, Form>> ShapesAndForms()
{
  std::vector<std::pair<Shape, Form>> all;
  for (const Shape shape : kShapes)
  {
    all.emplace_back(shape, Form::Collapsed);
  }
  all.emplace_back(Shape::Pyramid, Form::Tensor);
  return all;
}

inline LongVec3 MapOfOrder(int order, const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  switch (order)
  {
    case 1:
      return { a + 0.25L * b - 0.125L * c, b - 0.3L * c, c + 0.2L * a };
    case 2:
      return { a + 0.1L * b * b - 0.05L * c * a, b + 0.08L * a * c - 0.04L * a * a,
        c + 0.06L * a * b };
    default:
      return Curved(xi);
  }
}

/// One element and a field with random coefficients in every mode.
class EnclosureElement
{
public:
  EnclosureElement(const EnclosureCase& c, Random& random)
    : Values(c.components)
    , mapping_(c.mapping)
  {
    const auto spaceOf = [&](int order)
    {
      Space space = UniformSpace(c.shape, order);
      space.form = c.form;
      return space;
    };
    // Collapsed functions of a pyramid contain only the polynomials in xi of the same order.
    const bool rational = c.shape == Shape::Pyramid;
    Builder.Add(spaceOf(rational && c.mapOrder > 2 ? 4 : c.mapOrder),
      [&](const LongVec3& xi) { return MapOfOrder(c.mapOrder, xi); });
    Builder.Size[0] = c.size;
    for (int d = 0; d < 3; ++d)
    {
      Builder.Centre[d] = c.offset * c.size * (1.0 + 0.1 * d);
    }
    const Space space = spaceOf(c.fieldOrder);
    Values.Spaces = { space };
    Values.SpaceOf = { 0 };
    Values.Offset = { 0 };
    for (int k = 0; k < c.components; ++k)
    {
      ForEachMode(space,
        [&](int p, int q, int r, int /*mode*/)
        { Values.Coefficients.push_back(c.fieldScale * random() / (1.0 + p + q + r)); });
    }
  }

  [[nodiscard]] Mesh MeshView() const { return Builder.View(); }
  [[nodiscard]] Field FieldView() const { return { "u", Values.View(), mapping_ }; }

  MeshBuilder Builder;
  ExpansionBuilder Values;
  Mapping mapping_;
};

/// A world point, its approximate preimage, the true values and their enclosures.
struct EnclosedPoint
{
  Vec3 x;
  Vec3 xi;
  std::vector<Quad> truth;
  std::vector<double> plain;
  std::vector<Interval> interval;
};

/// Lower and upper bounds at points of one element; x and xi point by point.
inline std::vector<std::vector<Interval>> Enclose(const Mesh& mesh, const Field& field,
  std::span<const Vec3> xi, std::span<const Vec3> x, const EnclosureOptions& options = {})
{
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  const auto components = static_cast<std::size_t>(field.values.components);
  std::vector<double> lanes((6 + 2 * components) * stride);
  const auto array = [&](std::size_t k) { return &lanes[k * stride]; };
  for (std::size_t i = 0; i < stride; ++i)
  {
    const std::size_t from = std::min(i, xi.size() - 1);
    for (int d = 0; d < 3; ++d)
    {
      array(d)[i] = xi[from][d];
      array(3 + d)[i] = x[from][d];
    }
  }
  std::vector<double*> lower;
  std::vector<double*> upper;
  for (std::size_t c = 0; c < components; ++c)
  {
    lower.push_back(array(6 + c));
    upper.push_back(array(6 + components + c));
  }
  const int count = static_cast<int>(xi.size());
  EncloseValues(mesh, field, 0, { { array(0), array(1), array(2) }, count },
    { { array(3), array(4), array(5) }, count }, { lower.data(), upper.data() }, options);
  std::vector<std::vector<Interval>> result(xi.size());
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      result[i].emplace_back(lower[c][i], upper[c][i]);
    }
  }
  return result;
}

/// Random points of the element, as a locator would give them: the preimage is off by some
/// `inversionError`.
inline std::vector<EnclosedPoint> EnclosePoints(const EnclosureElement& element, int count,
  double inversionError, Random& random, const EnclosureOptions& options = {})
{
  const Mesh mesh = element.MeshView();
  const Field field = element.FieldView();
  std::vector<Vec3> xi(static_cast<std::size_t>(count));
  std::vector<Vec3> x(xi.size());
  for (auto& point : xi)
  {
    point = random.Inside(mesh.ShapeOf(0));
  }
  MapForward(mesh, 0, xi, x);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    const QuadVec3 exact = InvertQuad(mesh, 0, x[i], xi[i]);
    for (int d = 0; d < 3; ++d)
    {
      xi[i][d] = static_cast<double>(exact[d]) + inversionError * random();
    }
  }
  const auto intervals = Enclose(mesh, field, xi, x, options);
  std::vector<double> plain(xi.size() * static_cast<std::size_t>(field.values.components));
  EvaluateAt(mesh, field, 0, xi, plain, {});
  std::vector<EnclosedPoint> points;
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    const auto width = static_cast<std::ptrdiff_t>(field.values.components);
    const auto first = plain.begin() + static_cast<std::ptrdiff_t>(i) * width;
    points.push_back(
      { x[i], xi[i], WorldValuesQuad(mesh, field, 0, InvertQuad(mesh, 0, x[i], xi[i])),
        { first, first + width }, intervals[i] });
  }
  return points;
}

/// Written so that a NaN is no member.
inline bool Holds(const Interval& interval, const Quad& value)
{
  return Quad(interval.lower).v <= value.v && value.v <= Quad(interval.upper).v;
}
} // namespace pixelexact::testing
