// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/CurvePoint.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr std::size_t kLanes = kLanePadding;

double Longest(const Vec3& v)
{
  return std::max({ std::fabs(v.x), std::fabs(v.y), std::fabs(v.z) });
}

/// Unit length; zero where there is none.
Vec3 Unit(const Vec3& v)
{
  const double longest = Longest(v);
  return longest > 0.0 && std::isfinite(longest) ? glm::normalize(v / longest) : Vec3(0.0);
}
} // namespace

bool CurvePoint::IsRegular() const
{
  const double length = glm::dot(worldDirection, worldDirection);
  return length > 0.0 && std::isfinite(length);
}

CurveEvaluator::CurveEvaluator(const ContourQuestion& question, int element, double value)
  : Question(question)
  , Element(element)
  , Value(value)
  , MapKernels(KernelsFor(question.mesh.map.SpaceOf(element)))
  , FieldKernels(KernelsFor(question.field->values.SpaceOf(element)))
  , Lanes(
      (3 + 4 * static_cast<std::size_t>(std::max(3, question.field->values.components))) * kLanes)
{
}

CurvePoint CurveEvaluator::At(const Vec3& xi)
{
  const Expansion& map = Question.mesh.map;
  const Expansion& values = Question.field->values;
  const auto count = static_cast<std::size_t>(std::max(3, values.components));
  std::vector<double*> arrays(4 * count);
  for (std::size_t k = 0; k < arrays.size(); ++k)
  {
    arrays[k] = &Lanes[(3 + k) * kLanes];
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    std::fill_n(&Lanes[d * kLanes], kLanes, xi[static_cast<int>(d)]);
  }
  const LanePoints points{ { Lanes.data(), &Lanes[kLanes], &Lanes[2 * kLanes] }, 1 };

  CurvePoint point;
  point.xi = xi;
  MapKernels.gradient(
    map.SpaceOf(Element), map.Coefficients(Element), 3, points, arrays.data(), &arrays[count]);
  const auto e = static_cast<std::size_t>(Element);
  const double size = Question.mesh.size[e];
  Mat3 jacobian;
  for (int c = 0; c < 3; ++c)
  {
    const auto row = static_cast<std::size_t>(c);
    point.x[c] = std::fma(size, arrays[row][0], Question.mesh.centre[3 * e + row]);
    for (int d = 0; d < 3; ++d)
    {
      jacobian[d][c] = size * arrays[count + 3 * row + static_cast<std::size_t>(d)][0];
    }
  }
  const Vec3 y(arrays[0][0], arrays[1][0], arrays[2][0]);
  if (const QuadricForm* quadric = Question.cut->Quadric())
  {
    // Not of x, which far from the world's origin has lost digits that xi has.
    const Vec3 centre(Question.mesh.centre[3 * e], Question.mesh.centre[3 * e + 1],
      Question.mesh.centre[3 * e + 2]);
    const Vec3 z = (centre - quadric->origin) + size * y;
    point.s = quadric->ValueAround(z);
    point.sByXi = quadric->GradientAround(z) * jacobian;
  }
  else
  {
    point.s = Question.cut->Value(point.x);
    point.sByXi = Question.cut->Gradient(point.x) * jacobian;
  }

  const Space& space = values.SpaceOf(Element);
  FieldKernels.gradient(
    space, values.Coefficients(Element), values.components, points, arrays.data(), &arrays[count]);
  const auto valueOf = [&](int c) { return arrays[static_cast<std::size_t>(c)][0]; };
  const auto slopeOf = [&](int c)
  {
    const std::size_t first = count + 3 * static_cast<std::size_t>(c);
    return Vec3(arrays[first][0], arrays[first + 1][0], arrays[first + 2][0]);
  };
  if (!Question.IsMagnitude())
  {
    point.value = valueOf(Question.Component());
    point.valueByXi = slopeOf(Question.Component());
  }
  else
  {
    for (int c = 0; c < values.components; ++c)
    {
      point.value = std::hypot(point.value, valueOf(c));
      point.valueByXi += valueOf(c) * slopeOf(c);
    }
    point.valueByXi /= point.value;
  }
  // d value / d x = J^-T d value / d xi.
  point.gradient = point.valueByXi * glm::inverse(jacobian);
  point.direction = Unit(glm::cross(Unit(point.valueByXi), Unit(point.sByXi)));
  point.worldDirection = jacobian * point.direction;
  return point;
}

std::optional<CurvePoint> CurveEvaluator::InPlane(
  const Vec3& xi, const CurvePlane& plane, double reach)
{
  return Iterate(xi, &plane, reach);
}

std::optional<CurvePoint> CurveEvaluator::Near(const Vec3& xi, double reach)
{
  return Iterate(xi, nullptr, reach);
}

std::optional<CurvePoint> CurveEvaluator::Iterate(
  const Vec3& xi, const CurvePlane* plane, double reach)
{
  constexpr int kSteps = 20;
  /// Steps that no longer shrink are rounding, if they are as small as this.
  constexpr double kSettled = 1e-10;
  Vec3 at = xi;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kSteps; ++step)
  {
    const CurvePoint point = At(at);
    const Vec3 normal = plane != nullptr ? plane->normal : point.direction;
    // Rows are scaled to one, so that the field's and the surface's units do not matter.
    const double rows[3] = { Longest(point.valueByXi), Longest(point.sByXi), Longest(normal) };
    if (!(rows[0] > 0.0 && rows[1] > 0.0 && rows[2] > 0.0))
    {
      return std::nullopt;
    }
    const Mat3 matrix =
      glm::transpose(Mat3(point.valueByXi / rows[0], point.sByXi / rows[1], normal / rows[2]));
    const Vec3 residual((point.value - Value) / rows[0], point.s / rows[1],
      plane != nullptr ? (glm::dot(normal, at) - plane->offset) / rows[2] : 0.0);
    const Vec3 move = glm::inverse(matrix) * residual;
    const double length = Longest(move);
    if (!std::isfinite(length))
    {
      return std::nullopt;
    }
    if (length >= 0.5 * last && length <= kSettled)
    {
      return point;
    }
    last = length;
    at -= move;
    if (!(Longest(at - xi) <= reach))
    {
      return std::nullopt;
    }
    if (length <= 4e-16)
    {
      return At(at);
    }
  }
  return std::nullopt;
}
} // namespace pixelexact
