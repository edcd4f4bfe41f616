// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/EvaluationStudy.h"

#include "Stability/Reference.h"
#include "Stability/RoundingTape.h"
#include "Stability/Samplers.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Element/Kernels.h"

#include <tbb/parallel_for.h>

#include <chrono>

namespace pixelexact::testing
{
namespace
{
/// One point in all lanes, one component.
struct OnePoint
{
  OnePoint(const Space& space, const double* coefficients, const Vec3& xi)
  {
    double x[3][kLanePadding];
    for (int d = 0; d < 3; ++d)
    {
      std::fill_n(x[d], kLanePadding, xi[d]);
    }
    double out[4][kLanePadding];
    double* valueTo[1] = { out[0] };
    double* gradientTo[3] = { out[1], out[2], out[3] };
    const LanePoints at{ { x[0], x[1], x[2] }, 1 };
    const KernelSet kernels = KernelsFor(space);
    kernels.value(space, coefficients, 1, at, valueTo);
    value = out[0][0];
    kernels.gradient(space, coefficients, 1, at, valueTo, gradientTo);
    valueWithGradient = out[0][0];
    gradient = { out[1][0], out[2][0], out[3][0] };
  }
  double value;
  double valueWithGradient;
  std::array<double, 3> gradient;
};

std::vector<double> MakeCoefficients(const Space& space, Coefficients kind, Random& random)
{
  std::vector<double> result;
  ForEachMode(space,
    [&](int p, int q, int r, int)
    {
      const double plain = random() / ModeBound(space, p, q, r);
      switch (kind)
      {
        case Coefficients::Decaying:
          return result.push_back(plain * std::pow(0.7, p + q + r));
        case Coefficients::Huge:
          return result.push_back(plain * 1e300);
        case Coefficients::Tiny:
          return result.push_back(plain * 1e-300);
        case Coefficients::Mixed:
          return result.push_back(plain * std::pow(10.0, random(-300.0, 300.0)));
        default:
          return result.push_back(plain);
      }
    });
  return result;
}

/// Shifts the first mode, which is 1, so that little is left of the sum at xi.
void Cancel(const Space& space, std::vector<double>& coefficients, const Vec3& xi, Random& random)
{
  coefficients[0] = 0.0;
  const double rest = static_cast<double>(Evaluate(space, coefficients.data(), ToQuad(xi)).value);
  coefficients[0] = -rest * (1.0 + std::pow(10.0, random(-17.0, 0.0)));
}

Vec3 PointOf(Shape shape, Random& random)
{
  for (;;)
  {
    Vec3 xi = AnywhereInside(shape, random);
    if (random() < 0.0 && shape != Shape::Hexahedron)
    {
      Vec3 eta(random(), random(), random());
      const int direction = shape == Shape::Tetrahedron && random() < 0.0 ? 1 : 2;
      eta[direction] = 1.0 - std::pow(10.0, random(-16.0, 0.0));
      xi = TensorToReference(shape, eta);
    }
    // At a pyramid's apex the gradient is undefined.
    if (!(Margin(shape, ToQuad(xi)) < 0) && (shape != Shape::Pyramid || xi.z < 1.0))
    {
      return xi;
    }
  }
}

/// sum |c| |d mode|, for each direction, from the modes' own gradients.
std::array<double, 3> GradientMagnitude(
  const Space& space, const std::vector<double>& coefficients, const QuadVec3& xi)
{
  // One sum per mode would cost the square of the number of modes; random signs give a similar
  // size.
  Random random(5);
  std::array<double, 3> largest{};
  std::vector<double> signs(coefficients);
  for (int trial = 0; trial < 3; ++trial)
  {
    for (std::size_t k = 0; k < signs.size(); ++k)
    {
      signs[k] = random() < 0.0 ? -coefficients[k] : coefficients[k];
    }
    const auto sample = Evaluate(space, signs.data(), xi);
    for (std::size_t d = 0; d < 3; ++d)
    {
      largest[d] = std::max(largest[d], std::fabs(static_cast<double>(sample.gradient[d])));
    }
  }
  return largest;
}

struct Measured
{
  QuadSample reference;
  double magnitude = 0.0;
  std::array<double, 3> gradientMagnitude{};
  double valueBound = 0.0;
  std::array<double, 4> bounds{};
  double errors[5] = {}; ///< value alone, value and gradient together
};

Measured Measure(const Space& space, const std::vector<double>& coefficients, const Vec3& xi)
{
  Measured result;
  const QuadVec3 at = ToQuad(xi);
  result.reference = Evaluate(space, coefficients.data(), at);
  result.magnitude = static_cast<double>(Magnitude(space, coefficients.data(), at));
  result.gradientMagnitude = GradientMagnitude(space, coefficients, at);
  result.valueBound = ValueRounding(space, coefficients.data(), xi);
  result.bounds = GradientRounding(space, coefficients.data(), xi);
  const OnePoint found(space, coefficients.data(), xi);
  const auto off = [](double value, Quad reference)
  { return static_cast<double>(Quad(value) - reference); };
  result.errors[0] = off(found.value, result.reference.value);
  result.errors[1] = off(found.valueWithGradient, result.reference.value);
  for (std::size_t d = 0; d < 3; ++d)
  {
    result.errors[2 + d] = off(found.gradient[d], result.reference.gradient[d]);
  }
  return result;
}
} // namespace

const char* Name(Coefficients kind)
{
  switch (kind)
  {
    case Coefficients::Equal:
      return "equal coefficients";
    case Coefficients::Decaying:
      return "decaying coefficients";
    case Coefficients::Huge:
      return "coefficients of 1e300";
    case Coefficients::Tiny:
      return "coefficients of 1e-300";
    case Coefficients::Mixed:
      return "coefficients of 1e-300 to 1e300";
    default:
      return "cancelling coefficients";
  }
}

std::vector<Space> EvaluationSpaces(int order)
{
  std::vector<Space> spaces;
  for (const Shape shape : kShapes)
  {
    spaces.push_back(UniformSpace(shape, order));
  }
  spaces.push_back(spaces.back());
  spaces.back().form = Form::Tensor;
  return spaces;
}

Row StudyEvaluation(
  const Space& space, Coefficients kind, int points, std::vector<ScatterPoint>* scatter)
{
  const auto start = std::chrono::steady_clock::now();
  Row row;
  row.sweep = Name(kind);
  row.shape = Name(space.shape);
  row.shape += space.form == Form::Tensor ? ", Tensor" : "";
  row.order = space.MaxOrder();
  row.parameter = "order";
  row.at = row.order;
  std::vector<Measured> measured(points);
  tbb::parallel_for(0, points,
    [&](int i)
    {
      Random random(1000 * static_cast<std::uint64_t>(row.order) + static_cast<std::uint64_t>(i));
      const Vec3 xi = PointOf(space.shape, random);
      auto coefficients = MakeCoefficients(space, kind, random);
      if (kind == Coefficients::Cancelling)
      {
        Cancel(space, coefficients, xi, random);
      }
      measured[i] = Measure(space, coefficients, xi);
    });
  for (const Measured& at : measured)
  {
    const auto value = static_cast<double>(at.reference.value);
    row.value.Add(at.errors[0], value, at.magnitude, at.valueBound);
    row.value.Add(at.errors[1], value, at.magnitude, at.bounds[0]);
    for (std::size_t d = 0; d < 3; ++d)
    {
      // Next to a pyramid's apex a gradient may be more than a double can be.
      if (!std::isfinite(static_cast<double>(at.reference.gradient[d])))
      {
        continue;
      }
      row.gradient.Add(at.errors[2 + d], static_cast<double>(at.reference.gradient[d]),
        at.gradientMagnitude[d], at.bounds[1 + d]);
    }
    const double condition =
      static_cast<double>(Quad(at.magnitude) / Max(Abs(at.reference.value), Quad(1e-330L)));
    Raise(row.condition, condition);
    if (scatter)
    {
      scatter->push_back({ row.sweep, row.shape, row.at, condition, InUlps(at.errors[0], value),
        InUlps(at.valueBound, value) });
    }
  }
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return row;
}
} // namespace pixelexact::testing
