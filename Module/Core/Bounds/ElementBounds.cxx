// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bounds/ElementBounds.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Bounds/Injectivity.h"
#include "Core/Bounds/MapCurvature.h"
#include "Core/Math/Mat.h"
#include "Core/Math/Rounding.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace pixelexact
{
namespace
{
/// Bounds the rounding of one evaluation of Phi by the kernels, per unit of the sum of |c| |mode|:
/// the number of successive operations of recurrences and sums.
double EvaluationError(const Space& space)
{
  return Gamma(4 * (space.order[0] + space.order[1] + space.order[2]) + 16);
}

/// Phi's value and Jacobian (row-major) at the shape's centre.
void EvaluateCentre(const Space& space, const double* coefficients, double* value, double* jacobian)
{
  const Vec3 centre = Centre(space.shape);
  double x[3][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(x[d], kLanePadding, centre[d]);
  }
  double out[3][kLanePadding];
  double gradient[9][kLanePadding];
  double* outTo[3];
  double* gradientTo[9];
  for (int c = 0; c < 3; ++c)
  {
    outTo[c] = out[c];
  }
  for (int k = 0; k < 9; ++k)
  {
    gradientTo[k] = gradient[k];
  }
  KernelsFor(space).gradient(
    space, coefficients, 3, { { x[0], x[1], x[2] }, 1 }, outTo, gradientTo);
  for (int c = 0; c < 3; ++c)
  {
    value[c] = out[c][0];
  }
  for (int k = 0; k < 9; ++k)
  {
    jacobian[k] = gradient[k][0];
  }
}

/// Returns false where the matrix (row-major) cannot be inverted.
bool Invert(const double* matrix, double* inverse)
{
  // GLM's matrices are column-major.
  const glm::dmat3 columns = glm::transpose(glm::make_mat3(matrix));
  const glm::dmat3 result = glm::transpose(glm::inverse(columns));
  std::copy_n(glm::value_ptr(result), 9, inverse);
  return std::all_of(inverse, inverse + 9, [](double v) { return std::isfinite(v); });
}

struct ComponentHulls
{
  std::vector<double> bernstein[3];
  double error[3];     ///< of every coefficient
  double magnitude[3]; ///< bound of the sum of |c| |mode|
  double first[3];     ///< the first mode's coefficient
  double spread[3];    ///< bound of the distance from it
};

/// Bounds of the space's modes.
std::vector<double> ModeBounds(const Space& space)
{
  std::vector<double> bounds;
  bounds.reserve(static_cast<std::size_t>(space.Modes()));
  ForEachMode(
    space, [&](int p, int q, int r, int /*mode*/) { bounds.push_back(ModeBound(space, p, q, r)); });
  return bounds;
}

/// Bounds the sum over all modes but the first, which is 1, of |c| |mode|. Unlike hulls, which are
/// useless at order 20, the bound does not suffer from the growth of Bernstein coefficients with
/// the order.
double SpreadOf(const std::vector<double>& modeBounds, const double* component)
{
  double sum = 0.0;
  for (std::size_t mode = 1; mode < modeBounds.size(); ++mode)
  {
    sum += std::fabs(component[mode]) * modeBounds[mode];
  }
  // Covers the rounding of the sum and of the mode bounds.
  return sum * (1.0 + Gamma(static_cast<int>(modeBounds.size()) + 64));
}

enum class Errors : std::uint8_t
{
  Sharp,
  Quick
};

/// Data computed once per space and kept by each thread.
struct SpaceTools
{
  const BernsteinForm* form = nullptr;
  std::vector<double> modeBounds;

  static const SpaceTools& Of(const Space& space)
  {
    thread_local std::map<Space, SpaceTools> tools;
    SpaceTools& found = tools[space];
    if (!found.form)
    {
      found = { &BernsteinForm::Of(space), ModeBounds(space) };
    }
    return found;
  }
};

ComponentHulls MakeHulls(const Space& space, const double* coefficients, Errors errors)
{
  const SpaceTools& tools = SpaceTools::Of(space);
  const int modes = space.Modes();
  ComponentHulls hulls;
  for (int c = 0; c < 3; ++c)
  {
    const double* component = coefficients + static_cast<std::ptrdiff_t>(c) * modes;
    hulls.bernstein[c].resize(tools.form->Size());
    tools.form->Convert(component, hulls.bernstein[c]);
    hulls.error[c] = errors == Errors::Sharp ? tools.form->ErrorBound(component)
                                             : tools.form->QuickErrorBound(component);
    hulls.spread[c] = SpreadOf(tools.modeBounds, component);
    hulls.first[c] = component[0];
    hulls.magnitude[c] = std::fabs(component[0]) + hulls.spread[c];
  }
  return hulls;
}

/// Slack in world units, for coordinates of at most this magnitude: a point meant to lie on a face
/// is known to half an ulp of its coordinates, the face to the mesh's uncertainty.
double SlackOf(const Mesh& mesh, int element, double largest)
{
  return mesh.uncertainty[element] + 4.0 * kUnitRoundoff * largest;
}

void MakeBox(const Mesh& mesh, int element, const ComponentHulls& hulls, ElementBounds& bounds)
{
  const double size = mesh.size[element];
  for (int c = 0; c < 3; ++c)
  {
    const Hull hull = HullOf(hulls.bernstein[c]);
    const double centre = mesh.centre[3 * static_cast<std::size_t>(element) + c];
    const double least =
      std::max(NextDown(hull.lower - hulls.error[c]), NextDown(hulls.first[c] - hulls.spread[c]));
    const double most =
      std::min(NextUp(hull.upper + hulls.error[c]), NextUp(hulls.first[c] + hulls.spread[c]));
    const double lower = NextDown(centre + NextDown(size * least));
    const double upper = NextUp(centre + NextUp(size * most));
    const double slack = SlackOf(mesh, element, std::max(std::fabs(lower), std::fabs(upper)));
    bounds.box.lower[c] = NextDown(lower - slack);
    bounds.box.upper[c] = NextUp(upper + slack);
    const double evaluation = EvaluationError(mesh.map.SpaceOf(element)) * hulls.magnitude[c];
    bounds.uncertainty[c] = slack / size + evaluation;
  }
}

void MakeFrame(const Space& space, const double* coefficients, const ComponentHulls& hulls,
  ElementBounds& bounds)
{
  double jacobian[9];
  EvaluateCentre(space, coefficients, bounds.origin, jacobian);
  bounds.framed = Invert(jacobian, bounds.inverse);
  if (!bounds.framed)
  {
    return;
  }
  const auto& form = BernsteinForm::Of(space);
  const Vec3 centre = Centre(space.shape);
  std::fill_n(bounds.lower, 3, std::numeric_limits<double>::infinity());
  std::fill_n(bounds.upper, 3, -std::numeric_limits<double>::infinity());
  const auto [P, Q, R] = form.Degree();
  std::size_t at = 0;
  for (int i = 0; i <= P; ++i)
  {
    for (int j = 0; j <= Q; ++j)
    {
      for (int k = 0; k <= R; ++k, ++at)
      {
        // xi is affine in each eta, so its Bernstein coefficients are its values on the grid.
        const Vec3 xi = TensorToReference(space.shape, form.GridPoint(i, j, k));
        for (int d = 0; d < 3; ++d)
        {
          double t = centre[d] - xi[d];
          for (int c = 0; c < 3; ++c)
          {
            t += bounds.inverse[3 * d + c] * (hulls.bernstein[c][at] - bounds.origin[c]);
          }
          bounds.lower[d] = std::min(bounds.lower[d], t);
          bounds.upper[d] = std::max(bounds.upper[d], t);
        }
      }
    }
  }
  double largest = 0.0;
  double rounding = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    largest = std::max({ largest, -bounds.lower[d], bounds.upper[d] });
    // Covers the hull's own error, that of Phi and y, and of the products here and in MightContain,
    // whose factors y are of size 1.
    double slack = Gamma(16) * 4.0;
    for (int c = 0; c < 3; ++c)
    {
      const double weight = std::fabs(bounds.inverse[3 * d + c]);
      slack += weight *
        (hulls.error[c] + 2.0 * bounds.uncertainty[c] + Gamma(16) * (4.0 + hulls.magnitude[c]));
    }
    rounding = std::max(rounding, slack);
    bounds.lower[d] -= slack;
    bounds.upper[d] += slack;
  }
  bounds.affine = largest <= rounding;
  bounds.injectiveMargin = bounds.affine ? std::numeric_limits<double>::infinity()
                                         : InjectiveMargin(space, coefficients, bounds.inverse);
}
} // namespace

Box3 MakeElementBox(const Mesh& mesh, int element)
{
  ElementBounds bounds;
  MakeBox(mesh, element,
    MakeHulls(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), Errors::Quick), bounds);
  return bounds.box;
}

Vec3 ImageUncertainty(const Mesh& mesh, int element)
{
  const Space& space = mesh.map.SpaceOf(element);
  const auto& modeBounds = SpaceTools::Of(space).modeBounds;
  Vec3 uncertainty;
  for (int c = 0; c < 3; ++c)
  {
    const double* component =
      mesh.map.Coefficients(element) + static_cast<std::size_t>(c) * modeBounds.size();
    const double magnitude =
      mesh.size[element] * (std::fabs(component[0]) + SpreadOf(modeBounds, component));
    const double centre = std::fabs(mesh.centre[3 * static_cast<std::size_t>(element) + c]);
    uncertainty[c] =
      SlackOf(mesh, element, centre + magnitude) + EvaluationError(space) * magnitude;
  }
  return uncertainty;
}

ElementBounds MakeElementBounds(const Mesh& mesh, int element)
{
  const Space& space = mesh.map.SpaceOf(element);
  const double* coefficients = mesh.map.Coefficients(element);
  const ComponentHulls hulls = MakeHulls(space, coefficients, Errors::Sharp);
  ElementBounds bounds;
  MakeBox(mesh, element, hulls, bounds);
  MakeFrame(space, coefficients, hulls, bounds);
  if (bounds.framed && !bounds.affine)
  {
    bounds.curvature = MapCurvature(space, coefficients);
    bounds.bend = MapBend(space, coefficients);
    bounds.guess = MakeInverseGuess(MakeInverseProblem(mesh, element, bounds));
  }
  return bounds;
}

InverseProblem MakeInverseProblem(const Mesh& mesh, int element, const ElementBounds& bounds)
{
  InverseProblem problem{};
  problem.space = mesh.map.SpaceOf(element);
  problem.coefficients = mesh.map.Coefficients(element);
  problem.inverseSize = 1.0 / mesh.size[element];
  const Vec3 start = Centre(problem.space.shape);
  for (int d = 0; d < 3; ++d)
  {
    problem.centre[d] = mesh.centre[3 * static_cast<std::size_t>(element) + d];
    problem.origin[d] = bounds.origin[d];
    problem.start[d] = start[d];
    problem.uncertainty[d] = bounds.uncertainty[d];
  }
  // Without a frame, Newton's iteration begins at the shape's centre.
  std::copy_n(bounds.inverse, 9, problem.inverse);
  if (!bounds.framed)
  {
    std::fill_n(problem.inverse, 9, 0.0);
  }
  problem.affine = bounds.affine;
  problem.curvature = bounds.curvature;
  problem.bend = bounds.affine ? 0.0 : bounds.bend;
  if (bounds.guess.IsKnown())
  {
    problem.guess = bounds.guess.terms.data();
    std::ranges::copy(bounds.guess.centre, problem.guessCentre);
    std::ranges::copy(bounds.guess.scale, problem.guessScale);
  }
  return problem;
}
} // namespace pixelexact
