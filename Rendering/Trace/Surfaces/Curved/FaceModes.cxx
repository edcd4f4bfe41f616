// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/FaceModes.h"

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Faces/FacePlane.h"
#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace pixelexact
{
namespace
{
/// None if the face's functions are not polynomials of u and v.
std::optional<Space> SpaceOn(const Space& space, const FaceChart& chart)
{
  if (space.MaxOrder() > FaceRestriction::kHighestOrder ||
    (chart.collapses && space.form == Form::Tensor))
  {
    return std::nullopt;
  }
  if (chart.collapses)
  {
    // The order along xi3 is the total order.
    const std::uint8_t total = space.order[2];
    return Space{ Shape::Prism, Form::Collapsed, { total, 0, total } };
  }
  const std::array<int, 3> degree = space.TensorDegree();
  const auto along = [&](std::size_t j)
  { return static_cast<std::uint8_t>(degree[static_cast<std::size_t>(chart.free[j])]); };
  return Space{ Shape::Hexahedron, Form::Collapsed, { along(0), 0, along(1) } };
}

/// The largest magnitude of each mode.
std::vector<double> ModeBounds(const Space& space)
{
  std::vector<double> largest;
  ForEachMode(space,
    [&](int p, int q, int r, int /*mode*/) { largest.push_back(ModeBound(space, p, q, r)); });
  return largest;
}

/// The largest, over the three components, of the sums of |coefficient| |mode|.
double LargestSum(std::span<const double> coefficients, std::span<const double> modes)
{
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    double sum = 0.0;
    for (std::size_t m = 0; m < modes.size(); ++m)
    {
      sum += std::fabs(coefficients[c * modes.size() + m]) * modes[m];
    }
    largest = std::max(largest, sum);
  }
  return rounding::Above(largest * (1.0 + 1e-12));
}

/// Error of the matrix from its solution in long doubles, relative to the sum of the element's
/// modes: thousands of long double roundings.
constexpr double kOfMatrix = 0x1p-52;
} // namespace

BoxPolynomial OverFace(const FaceChart& chart, const RangeIngredient& ingredient, int level,
  const PieceForm::Piece& piece)
{
  const auto u = static_cast<std::size_t>(chart.free[0]);
  const auto v = static_cast<std::size_t>(chart.free[1]);
  BoxPolynomial over = ingredient.Over(level, { piece[u], 0, piece[v] }, { Vec3(-1.0), Vec3(1.0) });
  // In the order of the element's directions, so that the coefficients keep their places.
  const int degree[2] = { over.degree[0], over.degree[2] };
  over.degree = {};
  over.degree[u] = degree[0];
  over.degree[v] = degree[1];
  return over;
}

FaceMap::FaceMap(const Mesh& mesh, const CurvedPart& part, const FaceModes* modes)
  : chart_(ChartOf(mesh.ShapeOf(part.element), part.face))
  , Inwards(FacePlanesOf(mesh.ShapeOf(part.element))[static_cast<std::size_t>(part.face)].gradient)
  , Modes(modes)
  , InElement(mesh.map.SpaceOf(part.element))
  , Coefficients(mesh.map.Coefficients(part.element))
{
}

void FaceMap::Evaluate(const LanePoints& xi, double* const value[3], double* const slope[7]) const
{
  if (Modes == nullptr)
  {
    EvaluateInElement(xi, value, slope);
    return;
  }
  const double* const u = xi.x[chart_.free[0]];
  const double* const v = xi.x[chart_.free[1]];
  double* const none = slope[6];
  double* const by[9] = { slope[0], none, slope[1], slope[2], none, slope[3], slope[4], none,
    slope[5] };
  KernelsFor(Modes->space)
    .gradient(Modes->space, Modes->coefficients.data(), 3, { { u, u, v }, xi.count }, value, by);
}

double FaceMap::OutwardSign() const
{
  Vec3 tangent[2]{};
  for (std::size_t j = 0; j < 2; ++j)
  {
    tangent[j][chart_.free[j]] = 1.0;
    tangent[j][chart_.across] = chart_.along[j];
  }
  // Distances increase inwards.
  return glm::dot(glm::cross(tangent[0], tangent[1]), Inwards) < 0.0 ? 1.0 : -1.0;
}

void FaceMap::EvaluateInElement(
  const LanePoints& xi, double* const value[3], double* const slope[7]) const
{
  const auto count = static_cast<std::size_t>(PaddedCount(xi.count));
  std::vector<double> room(9 * count);
  double* by[9];
  for (std::size_t k = 0; k < 9; ++k)
  {
    by[k] = room.data() + k * count;
  }
  KernelsFor(InElement).gradient(InElement, Coefficients, 3, xi, value, by);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double* const across = by[3 * c + static_cast<std::size_t>(chart_.across)];
    for (std::size_t j = 0; j < 2; ++j)
    {
      const double* const along = by[3 * c + static_cast<std::size_t>(chart_.free[j])];
      for (std::size_t i = 0; i < count; ++i)
      {
        slope[2 * c + j][i] = along[i] + chart_.along[j] * across[i];
      }
    }
  }
}

const FaceRestriction::Change* FaceRestriction::ChangeFor(
  const Space& space, std::int32_t face) const
{
  const std::scoped_lock lock(Making);
  const auto [at, isNew] = Made.try_emplace({ space, face });
  const FaceChart chart = ChartOf(space.shape, face);
  const std::optional<Space> onFace = isNew ? SpaceOn(space, chart) : std::nullopt;
  if (onFace)
  {
    const auto atChart = [&](const LongVec3& uv, long double* values)
    {
      LongVec3 xi;
      xi[static_cast<std::size_t>(chart.free[0])] = uv[0];
      xi[static_cast<std::size_t>(chart.free[1])] = uv[2];
      xi[static_cast<std::size_t>(chart.across)] =
        chart.constant + chart.along[0] * uv[0] + chart.along[1] * uv[2];
      EvaluateModes(space, xi, values);
    };
    at->second = std::make_unique<const Change>(
      Change{ ChangeOfBasis::FromFunctions(*onFace, space.Modes(), atChart), ModeBounds(*onFace),
        ModeBounds(space) });
  }
  return at->second.get();
}

std::optional<FaceModes> FaceRestriction::Of(const Mesh& mesh, const CurvedPart& part) const
{
  const Space& space = mesh.map.SpaceOf(part.element);
  const Change* change = ChangeFor(space, part.face);
  if (change == nullptr)
  {
    return std::nullopt;
  }
  FaceModes modes{ change->matrix.Target(), {} };
  const std::span inElement(mesh.map.Coefficients(part.element), 3 * change->inElement.size());
  modes.coefficients.resize(3 * change->largest.size());
  const std::array<double, 3> shifts{};
  ChangeOfBasis::Scratch scratch;
  change->matrix.Apply(inElement, shifts, modes.coefficients, scratch);
  // Each coefficient is rounded once; the matrix was computed in long doubles.
  modes.error = kUnitRoundoff * LargestSum(modes.coefficients, change->largest) +
    kOfMatrix * LargestSum(inElement, change->inElement);
  return modes;
}
} // namespace pixelexact
