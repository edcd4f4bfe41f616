// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/CurvePoint.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

/// Step of differences, in xi: far more than rounding, and far less than functions bend in.
constexpr double kDifference = 1e-5;

/// The largest coefficients of the components that are contoured in an element: the constant ones
/// and the others.
std::array<double, 2> LargestOf(const ContourQuestion& question, int element)
{
  const Expansion& values = question.field->values;
  const int modes = values.SpaceOf(element).Modes();
  const int first = question.IsMagnitude() ? 0 : question.Component();
  const int last = question.IsMagnitude() ? values.components - 1 : first;
  std::array<double, 2> largest{};
  for (int c = first; c <= last; ++c)
  {
    const double* own = values.Coefficients(element) + std::ptrdiff_t{ c } * modes;
    for (int m = 0; m < modes; ++m)
    {
      double& of = largest[m == 0 ? 0 : 1];
      of = std::max(of, std::fabs(own[m]));
    }
  }
  return largest;
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
  const Space& space = question.field->values.SpaceOf(element);
  const auto [constant, varying] = LargestOf(question, element);
  Digits = kUnitRoundoff * SumOfModeBounds(space) * std::max(constant, varying);
  // By Markov's inequality the second derivatives of a polynomial of degree n on [-1,1] are at most
  // M = n^2 (n^2 - 1) / 3 times its largest value. Where the slope is less than sqrt(2 M rounding),
  // two lines may be as close as rounding can move one. Here the rounding of a few operations
  // counts, because lines that are not followed are undecided anyway.
  const double n = std::ranges::max(space.TensorDegree());
  const double steepest = n * n * (n * n - 1.0) / 3.0 * varying;
  const double rounding = 8.0 * kUnitRoundoff * std::max(constant, varying);
  Flattest = std::sqrt(2.0 * steepest * rounding) + rounding;
}

Mat3 CurveEvaluator::TurnByXi(const Vec3& xi)
{
  Mat3 change;
  for (int d = 0; d < 3; ++d)
  {
    Vec3 turn[2];
    for (const bool ahead : { false, true })
    {
      Vec3 at = xi;
      at[d] += ahead ? kDifference : -kDifference;
      const CurvePoint point = FieldAt(at);
      turn[ahead ? 1 : 0] = glm::cross(point.residualByXi, point.sByXi);
    }
    change[d] = (turn[1] - turn[0]) / (2.0 * kDifference);
  }
  return change;
}

CurvePoint CurveEvaluator::At(const Vec3& xi)
{
  CurvePoint point = FieldAt(xi);
  if (Along)
  {
    point.residual = glm::dot(*Along, glm::cross(point.residualByXi, point.sByXi));
    point.residualByXi = *Along * TurnByXi(xi);
  }
  const Vec3 turn = glm::cross(point.residualByXi, Unit(point.sByXi));
  const bool isFlat = !Along && !(glm::length(turn) > Flattest);
  point.direction =
    isFlat ? Vec3(0.0) : Unit(glm::cross(Unit(point.residualByXi), Unit(point.sByXi)));
  point.worldDirection = point.jacobian * point.direction;
  return point;
}

CurvePoint CurveEvaluator::FieldAt(const Vec3& xi)
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
  // Uses y rather than x, which has lost digits far from the world's origin that xi has.
  const Vec3 centre(
    Question.mesh.centre[3 * e], Question.mesh.centre[3 * e + 1], Question.mesh.centre[3 * e + 2]);
  const Vec3 y(arrays[0][0], arrays[1][0], arrays[2][0]);
  if (const ImplicitPolynomial* const surface = Question.cut->Polynomial())
  {
    const Vec3 z = (centre - surface->origin) + size * y;
    point.s = surface->ValueAround(z);
    point.sByXi = surface->GradientAround(z) * jacobian;
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
    point.residualByXi = slopeOf(Question.Component());
  }
  else
  {
    for (int c = 0; c < values.components; ++c)
    {
      point.value = std::hypot(point.value, valueOf(c));
      point.residualByXi += valueOf(c) * slopeOf(c);
    }
    point.residualByXi /= point.value;
  }
  // d value / d x = J^-T d value / d xi.
  point.gradient = point.residualByXi * glm::inverse(jacobian);
  point.residual = point.value - Value;
  point.jacobian = jacobian;
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
    const double rows[3] = { Longest(point.residualByXi), Longest(point.sByXi), Longest(normal) };
    if (!(rows[0] > 0.0 && rows[1] > 0.0 && rows[2] > 0.0))
    {
      return std::nullopt;
    }
    const Mat3 matrix =
      glm::transpose(Mat3(point.residualByXi / rows[0], point.sByXi / rows[1], normal / rows[2]));
    const Vec3 residual(point.residual / rows[0], point.s / rows[1],
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
