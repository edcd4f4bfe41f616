// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/Reference.h"

#include "Stability/ModesVisit.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
QuadVec3 ToQuad(const Vec3& x)
{
  return { x.x, x.y, x.z };
}

Vec3 ToDouble(const QuadVec3& x)
{
  return { static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]) };
}

QuadSample Evaluate(const Space& space, const double* coefficients, const QuadVec3& xi)
{
  return VisitModes<Quad, true>(space, xi,
    [&](const auto& modes)
    {
      const auto e = modes.Evaluate(coefficients);
      return QuadSample{ e.value, { e.gradient[0], e.gradient[1], e.gradient[2] } };
    });
}

std::vector<Quad> Modes(const Space& space, const QuadVec3& xi)
{
  std::vector<Quad> values(space.Modes());
  VisitModes<Quad, false>(space, xi,
    [&](const auto& modes)
    {
      ForEachMode(
        space, [&](int p, int q, int r, int mode) { values[mode] = modes.Mode(p, q, r); });
    });
  return values;
}

Quad Magnitude(const Space& space, const double* coefficients, const QuadVec3& xi)
{
  return VisitModes<Quad, false>(space, xi,
    [&](const auto& modes)
    {
      Quad sum;
      ForEachMode(space,
        [&](int p, int q, int r, int mode)
        { sum = sum + Abs(Quad(coefficients[mode]) * modes.Mode(p, q, r)); });
      return sum;
    });
}

Quad Margin(Shape shape, const QuadVec3& xi)
{
  const auto [a, b, c] = xi;
  const Quad low = Min(Min(1 + a, 1 + b), 1 + c);
  switch (shape)
  {
    case Shape::Hexahedron:
      return Min(low, Min(Min(1 - a, 1 - b), 1 - c));
    case Shape::Prism:
      return Min(low, Min(1 - b, -(a + c)));
    case Shape::Tetrahedron:
      return Min(low, -(1 + a + b + c));
    default:
      return Min(low, Min(-(a + c), -(b + c)));
  }
}

QuadVec3 Continued(Shape shape, const QuadVec3& xi)
{
  const Quad width = 1 - xi[2];
  if (shape != Shape::Pyramid || !(Abs(width) < Quad(2e-8)))
  {
    return xi;
  }
  const auto clamp = [&](Quad at) { return Max(Min(at + 1, Max(width, 0)), Min(width, 0)) - 1; };
  return { clamp(xi[0]), clamp(xi[1]), xi[2] };
}

QuadMat3 Inverse(const QuadMat3& m)
{
  QuadMat3 adjugate;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const auto& r1 = m[(j + 1) % 3];
      const auto& r2 = m[(j + 2) % 3];
      adjugate[i][j] = r1[(i + 1) % 3] * r2[(i + 2) % 3] - r1[(i + 2) % 3] * r2[(i + 1) % 3];
    }
  }
  const Quad det = m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
  for (auto& row : adjugate)
  {
    for (auto& entry : row)
    {
      entry = entry / det;
    }
  }
  return adjugate;
}

QuadImage MapInUnits(const Mesh& mesh, int element, const QuadVec3& xi)
{
  const Space& space = mesh.map.SpaceOf(element);
  QuadImage image;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto e = Evaluate(
      space, mesh.map.Coefficients(element) + c * static_cast<std::size_t>(space.Modes()), xi);
    image.y[c] = e.value;
    image.jacobian[c] = e.gradient;
  }
  return image;
}

Vec3 MapToWorld(const Mesh& mesh, int element, const QuadVec3& xi)
{
  const QuadVec3 y = MapInUnits(mesh, element, xi).y;
  Vec3 x;
  for (int d = 0; d < 3; ++d)
  {
    x[d] =
      static_cast<double>(Quad(mesh.centre[3 * element + d]) + Quad(mesh.size[element]) * y[d]);
  }
  return x;
}

QuadVec3 ToUnits(const Mesh& mesh, int element, const Vec3& x)
{
  QuadVec3 y;
  for (int d = 0; d < 3; ++d)
  {
    y[d] = (Quad(x[d]) - Quad(mesh.centre[3 * element + d])) / Quad(mesh.size[element]);
  }
  return y;
}

QuadPreimage FindPreimage(const Mesh& mesh, int element, const Vec3& x, const QuadVec3& near)
{
  constexpr int kMaxSteps = 200;
  // Near a vanishing determinant convergence is linear at first, and its limit is rounding times
  // conditioning of Quad, far below the resolution of double.
  constexpr double kEnough = 1e-24;
  const QuadVec3 y = ToUnits(mesh, element, x);
  QuadPreimage result{ near, {}, {}, 1.0 };
  for (int step = 0; step < kMaxSteps && result.lastStep > kEnough; ++step)
  {
    const QuadImage image = MapInUnits(mesh, element, result.xi);
    result.jacobian = image.jacobian;
    result.inverse = Inverse(image.jacobian);
    Quad longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      Quad delta = 0;
      for (std::size_t j = 0; j < 3; ++j)
      {
        delta = delta + result.inverse[i][j] * (image.y[j] - y[j]);
      }
      result.xi[i] = result.xi[i] - delta;
      longest = Max(longest, Abs(delta));
    }
    result.lastStep = static_cast<double>(longest);
  }
  return result;
}
} // namespace pixelexact::testing
