// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

#include "Trace/Camera.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Tracer.h"

#include <cmath>
#include <deque>
#include <memory>
#include <numbers>

// A mesh to look at, and rays in closed form.
namespace pixelexact::testing
{
/// A cube [-1,1]^3 of 2 x 2 x 2 elements, inner faces bent, with the field x + 10 y + 100 z and a
/// second component that is NaN in the first element.
class Block
{
public:
  Block()
  {
    const Space space = UniformSpace(Shape::Hexahedron, 4);
    for (int e = 0; e < 8; ++e)
    {
      const auto map = [e](const LongVec3& xi) { return Map(e, xi); };
      Elements.Add(space, map);
      Values.Add(space,
        [&](const LongVec3& xi, long double* u)
        {
          const LongVec3 x = map(xi);
          u[0] = x[0] + 10 * x[1] + 100 * x[2];
          u[1] = 1;
        });
    }
    Values.Coefficients[static_cast<std::size_t>(space.Modes())] = std::nan("");
    field_ = { "u", Values.View() };
    locator_ = std::make_unique<Locator>(Elements.View());
    scene_.locator = locator_.get();
  }

  /// Element e's map.
  static LongVec3 Map(int e, const LongVec3& xi)
  {
    const long double a = (xi[0] + (e & 1 ? 1 : -1)) / 2;
    const long double b = (xi[1] + (e & 2 ? 1 : -1)) / 2;
    const long double c = (xi[2] + (e & 4 ? 1 : -1)) / 2;
    // Vanishes on the cube's boundary where it must: the cube stays a cube.
    return { a + 0.2L * (1 - a * a) * b * c, b + 0.2L * (1 - b * b) * a, c };
  }

  /// The value is at most 13 in the cube, the components of its gradient at most 8.
  static long double CurvedAt(const LongVec3& x)
  {
    return 1 + 2 * x[0] - 3 * x[1] + x[0] * x[0] - 2 * x[0] * x[1] + 3 * x[1] * x[2] + x[2] * x[2];
  }

  Scene& WithPlane(const Vec3& origin, const Vec3& normal)
  {
    scene_.layers.push_back({ std::make_shared<Plane>(origin, normal), &field_ });
    return scene_;
  }

  /// Replaces the field by CurvedAt.
  void MakeCurved()
  {
    field_ = Add(1, [](const LongVec3& x, long double* u) { u[0] = CurvedAt(x); });
  }

  /// Another field: polynomials of degree 2 at most.
  const Field& Add(
    int components, const std::function<void(const LongVec3& x, long double* u)>& function)
  {
    ExpansionBuilder& values = Others.emplace_back(components);
    for (int e = 0; e < 8; ++e)
    {
      values.Add(UniformSpace(Shape::Hexahedron, 4),
        [&](const LongVec3& xi, long double* u) { function(Map(e, xi), u); });
    }
    return Fields.emplace_back("u", values.View());
  }

  Field field_;
  Scene scene_;

private:
  MeshBuilder Elements;
  ExpansionBuilder Values{ 2 };
  // Do not move: scenes refer to them.
  std::deque<ExpansionBuilder> Others;
  std::deque<Field> Fields;
  std::unique_ptr<Locator> locator_;
};

inline Camera ViewAlongZ(int width, int height, double scale = 1.25)
{
  CameraView view;
  view.position = { 0.0, 0.0, 5.0 };
  view.parallel = true;
  view.parallelScale = scale;
  return { view, width, height };
}

inline constexpr Buffer kAll = Buffer::Value | Buffer::Position | Buffer::Normal | Buffer::Xi |
  Buffer::Element | Buffer::Depth | Buffer::Verdict;

struct LongRay
{
  LongVec3 origin;
  LongVec3 direction; ///< of unit length
};

/// The ray through an image position, in pixels, by vtkCamera's meaning of a view.
inline LongRay RayThrough(
  const CameraView& view, int width, int height, long double px, long double py)
{
  const LongVec3 forward = Unit(Minus(ToLong(view.focalPoint), ToLong(view.position)));
  const LongVec3 right = Unit(Cross(forward, ToLong(view.viewUp)));
  const LongVec3 up = Cross(right, forward);
  const long double half = view.parallel
    ? static_cast<long double>(view.parallelScale)
    : std::tan(view.viewAngle * std::numbers::pi_v<long double> / 360);
  // The position in half-heights of the image from its middle.
  const long double aspect = static_cast<long double>(width) / height;
  const long double x = aspect * (2 * px / width - 1 + view.windowCenter[0]);
  const long double y = 2 * py / height - 1 + view.windowCenter[1];
  const LongVec3 aside = Plus(Times(half * x, right), Times(half * y, up));
  return view.parallel ? LongRay{ Plus(ToLong(view.position), aside), forward }
                       : LongRay{ ToLong(view.position), Unit(Plus(forward, aside)) };
}
} // namespace pixelexact::testing
