// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/NormQuadrature.h"

#include "Core/Element/FieldFunction.h"
#include "Core/Element/JacobianAlgebra.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace pixelexact
{
namespace
{
/// Points of the coarser rule beyond the order of the field and the map's order, where the rule is
/// not exact.
constexpr int kMorePoints = 3;
/// Points of the finer rule beyond the coarser one.
constexpr int kFinerBy = 2;
/// Points that are evaluated together.
constexpr std::size_t kNormBatch = 1024;
/// Rules converge slowly where |f| has a kink, so that their difference may be less than the error.
constexpr double kKinkSafety = 4.0;

int HighestDegreeOf(const Expansion& values)
{
  int degree = 1;
  for (const Space& space : values.spaces)
  {
    degree = std::max(degree, std::ranges::max(space.TensorDegree()));
  }
  return degree;
}

/// det dxi / deta.
double CollapseAt(Shape shape, const Vec3& eta)
{
  const double third = 0.5 * (1.0 - eta.z);
  switch (shape)
  {
    case Shape::Tetrahedron:
      return 0.5 * (1.0 - eta.y) * third * third;
    case Shape::Pyramid:
      return third * third;
    case Shape::Prism:
      return third;
    default:
      return 1.0;
  }
}
} // namespace

/// The rule's result over a box.
struct NormQuadrature::BoxSums
{
  std::vector<double> sums; ///< by quantity
  double largest = -1.0;
  Vec3 xi{ 0.0 };
  bool isFinite = true;
  bool isFolded = false;
};

double ElementQuadrature::Total(std::vector<double> NormBox::*of, std::size_t quantity) const
{
  double sum = 0.0;
  for (const NormBox& box : boxes)
  {
    sum += (box.*of)[quantity];
  }
  return sum;
}

NormQuadrature::NormQuadrature(const Mesh& mesh, const Field& field, bool isPlane, int order)
  : mesh_(mesh)
  , field_(field)
  , Components(static_cast<std::size_t>(field.values.components))
  , IsPlane(isPlane)
{
  const int map = HighestDegreeOf(mesh.map);
  const bool isPolynomial = field.function == nullptr && field.mapping == Mapping::Identity;
  const int ofField = field.function == nullptr ? HighestDegreeOf(field.values) : order;
  // |f|^2 det J and the collapse have degree 2 ofField + 3 map + 2 at most.
  const int coarse =
    isPolynomial ? (2 * ofField + 3 * map + 2) / 2 + 1 : ofField + map + kMorePoints;
  Rules[0] = MakeGaussRule(coarse);
  Rules[1] = MakeGaussRule(coarse + kFinerBy);
}

std::int64_t NormQuadrature::PointsOfBox() const
{
  std::int64_t points = 0;
  for (const GaussRule& rule : Rules)
  {
    const auto n = static_cast<std::int64_t>(rule.points.size());
    points += n * n * (IsPlane ? 1 : n);
  }
  return points;
}

void NormQuadrature::Begin(int element, ElementQuadrature& quadrature) const
{
  Add(element, { Vec3(-1.0), Vec3(1.0) }, quadrature);
}

void NormQuadrature::Refine(int element, const std::vector<double>& allowed, std::int64_t boxes,
  ElementQuadrature& quadrature) const
{
  const auto badness = [&allowed](const std::vector<double>& errors)
  {
    double worst = 0.0;
    for (std::size_t q = 0; q < errors.size(); ++q)
    {
      worst = std::max(worst, errors[q] > 0.0 ? errors[q] / allowed[q] : 0.0);
    }
    return worst;
  };
  const auto isWorse = [&badness](const NormBox& a, const NormBox& b)
  { return badness(a.errors) < badness(b.errors); };
  const int children = IsPlane ? 4 : 8;
  std::vector<double> errors(Quantities());
  for (std::size_t q = 0; q < errors.size(); ++q)
  {
    errors[q] = quadrature.Error(q);
  }
  while (quadrature.norms.isFinite && badness(errors) > 1.0 &&
    static_cast<std::int64_t>(quadrature.boxes.size()) + children - 1 <= boxes)
  {
    std::ranges::pop_heap(quadrature.boxes, isWorse);
    const NormBox worst = std::move(quadrature.boxes.back());
    quadrature.boxes.pop_back();
    for (std::size_t q = 0; q < errors.size(); ++q)
    {
      errors[q] = std::max(errors[q] - worst.errors[q], 0.0);
    }
    Subdivide(element, worst.box, isWorse, quadrature, errors);
  }
}

int NormQuadrature::Across(int element) const
{
  return IsPlane ? AcrossSlab(mesh_.ShapeOf(element)) : -1;
}

template <class IsWorse>
void NormQuadrature::Subdivide(int element, const Box3& box, const IsWorse& isWorse,
  ElementQuadrature& quadrature, std::vector<double>& errors) const
{
  const int across = Across(element);
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  for (unsigned child = 0; child < 8; ++child)
  {
    if (across >= 0 && (child >> static_cast<unsigned>(across) & 1U) != 0)
    {
      continue;
    }
    Box3 part = box;
    for (int d = 0; d < 3; ++d)
    {
      if (d != across)
      {
        ((child >> static_cast<unsigned>(d) & 1U) != 0 ? part.lower : part.upper)[d] = middle[d];
      }
    }
    Add(element, part, quadrature);
    for (std::size_t q = 0; q < errors.size(); ++q)
    {
      errors[q] += quadrature.boxes.back().errors[q];
    }
    std::ranges::push_heap(quadrature.boxes, isWorse);
  }
}

void NormQuadrature::Add(int element, const Box3& box, ElementQuadrature& quadrature) const
{
  const BoxSums coarse = Over(element, box, Rules[0]);
  BoxSums fine = Over(element, box, Rules[1]);
  ElementNorms& norms = quadrature.norms;
  ++quadrature.looked;
  norms.isFinite = norms.isFinite && coarse.isFinite && fine.isFinite;
  norms.isFolded = norms.isFolded || coarse.isFolded || fine.isFolded;
  for (const BoxSums* const sums : std::initializer_list<const BoxSums*>{ &coarse, &fine })
  {
    if (sums->largest > norms.largest || quadrature.boxes.empty())
    {
      norms.largest = sums->largest;
      norms.xi = sums->xi;
    }
  }
  std::vector<double> errors(Quantities());
  for (std::size_t q = 0; q < errors.size(); ++q)
  {
    errors[q] = std::fabs(fine.sums[q] - coarse.sums[q]);
  }
  errors[kAbsolute] *= kKinkSafety;
  quadrature.boxes.push_back({ box, std::move(fine.sums), std::move(errors) });
}

NormQuadrature::BoxSums NormQuadrature::Over(
  int element, const Box3& box, const GaussRule& rule) const
{
  BoxSums result;
  result.sums.resize(Quantities());
  const int across = Across(element);
  const Vec3 extent = box.upper - box.lower;
  std::vector<Vec3> eta;
  std::vector<double> weights;
  const std::size_t n = rule.points.size();
  for (std::size_t k = 0; k < (across == 2 ? 1 : n); ++k)
  {
    for (std::size_t j = 0; j < (across == 1 ? 1 : n); ++j)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        const std::array<std::size_t, 3> at{ i, j, k };
        Vec3 point;
        double weight = 1.0;
        for (int d = 0; d < 3; ++d)
        {
          const std::size_t one = at[static_cast<std::size_t>(d)];
          point[d] = d == across ? 0.0 : box.lower[d] + extent[d] * rule.points[one];
          weight *= extent[d] * (d == across ? 1.0 : rule.weights[one]);
        }
        eta.push_back(point);
        weights.push_back(weight * CollapseAt(mesh_.ShapeOf(element), point));
      }
    }
  }
  for (std::size_t from = 0; from < eta.size(); from += kNormBatch)
  {
    const std::size_t count = std::min(kNormBatch, eta.size() - from);
    AddBatch(element, std::span(eta).subspan(from, count), std::span(weights).subspan(from, count),
      result);
  }
  return result;
}

std::vector<double> NormQuadrature::Determinants(int element, std::span<const Vec3> xi) const
{
  const Space& space = mesh_.map.SpaceOf(element);
  const LaneBuffer lanes(xi);
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  std::vector<double> storage(12 * stride);
  std::array<double*, 12> a{};
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    a[k] = &storage[k * stride];
  }
  KernelsFor(space).gradient(
    space, mesh_.map.Coefficients(element), 3, lanes.View(), a.data(), a.data() + 3);
  const double size = mesh_.size[static_cast<std::size_t>(element)];
  std::vector<double> determinants(xi.size());
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    std::array<double, 9> jacobian{};
    for (std::size_t k = 0; k < jacobian.size(); ++k)
    {
      jacobian[k] = a[3 + k][i];
    }
    determinants[i] = Determinant<double>(jacobian) * size * size * size;
  }
  return determinants;
}

void NormQuadrature::AddBatch(
  int element, std::span<const Vec3> eta, std::span<const double> weights, BoxSums& result) const
{
  std::vector<Vec3> xi(eta.size());
  std::ranges::transform(
    eta, xi.begin(), [&](const Vec3& at) { return TensorToReference(mesh_.ShapeOf(element), at); });
  const std::vector<double> determinants = Determinants(element, xi);
  std::vector<double> values(Components * xi.size());
  EvaluateAt(mesh_, field_, element, xi, values, {});
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    const double* const value = &values[Components * i];
    double norm = 0.0;
    for (std::size_t c = 0; c < Components; ++c)
    {
      norm = Components == 1 ? std::fabs(value[c]) : std::hypot(norm, value[c]);
    }
    const double weight = weights[i] * std::fabs(determinants[i]);
    result.isFinite = result.isFinite && std::isfinite(norm * norm) && std::isfinite(weight);
    result.isFolded = result.isFolded || determinants[i] <= 0.0;
    result.sums[kVolume] += weight;
    result.sums[kAbsolute] += weight * norm;
    result.sums[kSquare] += weight * norm * norm;
    for (std::size_t c = 0; c < Components; ++c)
    {
      result.sums[kFirstComponent + c] += weight * value[c];
    }
    if (norm > result.largest)
    {
      result.largest = norm;
      result.xi = xi[i];
    }
  }
}
} // namespace pixelexact
