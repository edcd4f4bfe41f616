// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/FieldNorms.h"

#include "Core/Base/Error.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Element/JacobianAlgebra.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Element/MeshRanges.h"
#include "Core/Element/ParallelProgress.h"
#include "Core/Faces/FacePlaces.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Vec.h"
#include "Core/Shape/ShapeFace.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numeric>
#include <span>

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
/// Relative rounding of sums, as an estimate.
constexpr double kSumRounding = 0x1p-44;

// Numbers of the quantities that are integrated; the components follow.
constexpr std::size_t kVolume = 0;
constexpr std::size_t kAbsolute = 1;
/// Rules converge slowly where |f| has a kink, so that their difference may be less than the error.
constexpr double kKinkSafety = 4.0;
constexpr std::size_t kSquare = 2;
constexpr std::size_t kFirstComponent = 3;

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

/// The rule's result over a box.
struct BoxSums
{
  std::vector<double> sums; ///< by quantity
  double largest = -1.0;
  Vec3 xi{ 0.0 };
  bool isFinite = true;
  bool isFolded = false;
};

struct NormBox
{
  Box3 box;
  std::vector<double> sums;
  std::vector<double> errors;
};

/// The quadrature of one element.
class ElementQuadrature
{
public:
  std::vector<NormBox> boxes;
  ElementNorms norms;
  std::int64_t looked = 0;

  [[nodiscard]] double Sum(std::size_t quantity) const { return Total(&NormBox::sums, quantity); }
  [[nodiscard]] double Error(std::size_t quantity) const
  {
    return Total(&NormBox::errors, quantity);
  }

private:
  [[nodiscard]] double Total(std::vector<double> NormBox::*of, std::size_t quantity) const
  {
    double sum = 0.0;
    for (const NormBox& box : boxes)
    {
      sum += (box.*of)[quantity];
    }
    return sum;
  }
};

class NormFinder
{
public:
  NormFinder(const Mesh& mesh, const Field& field, bool isPlane, int order)
    : mesh_(mesh)
    , field_(field)
    , Components(static_cast<std::size_t>(field.values.components))
    , IsPlane(isPlane)
  {
    const int map = HighestDegreeOf(mesh.map);
    const bool isPolynomial = field.function == nullptr && field.mapping == Mapping::Identity;
    const int ofField = field.function == nullptr ? HighestDegreeOf(field.values) : order;
    // |f|^2 det J and the collapse have degree 2 ofField + 3 map + 2 at most.
    Coarse = isPolynomial ? (2 * ofField + 3 * map + 2) / 2 + 1 : ofField + map + kMorePoints;
    Rules[0] = MakeGaussRule(Coarse);
    Rules[1] = MakeGaussRule(Coarse + kFinerBy);
  }

  [[nodiscard]] std::size_t Quantities() const { return kFirstComponent + Components; }

  /// The number of points of both rules.
  [[nodiscard]] std::int64_t PointsOfBox() const
  {
    std::int64_t points = 0;
    for (const GaussRule& rule : Rules)
    {
      const auto n = static_cast<std::int64_t>(rule.points.size());
      points += n * n * (IsPlane ? 1 : n);
    }
    return points;
  }

  void Begin(int element, ElementQuadrature& quadrature) const
  {
    Add(element, { Vec3(-1.0), Vec3(1.0) }, quadrature);
  }

  /// Subdivides the boxes with the largest errors until the errors are at most `allowed`, or there
  /// are `boxes` of them.
  void Refine(int element, const std::vector<double>& allowed, std::int64_t boxes,
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

private:
  /// The direction of eta across the slab; -1: there is none.
  [[nodiscard]] int Across(int element) const
  {
    return IsPlane ? AcrossSlab(mesh_.ShapeOf(element)) : -1;
  }

  /// Adds the children's errors to `errors`.
  template <class IsWorse>
  void Subdivide(int element, const Box3& box, const IsWorse& isWorse,
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

  void Add(int element, const Box3& box, ElementQuadrature& quadrature) const
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

  [[nodiscard]] BoxSums Over(int element, const Box3& box, const GaussRule& rule) const
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
      AddBatch(element, std::span(eta).subspan(from, count),
        std::span(weights).subspan(from, count), result);
    }
    return result;
  }

  /// det J by xi, in world units.
  [[nodiscard]] std::vector<double> Determinants(int element, std::span<const Vec3> xi) const
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

  void AddBatch(
    int element, std::span<const Vec3> eta, std::span<const double> weights, BoxSums& result) const
  {
    std::vector<Vec3> xi(eta.size());
    std::ranges::transform(eta, xi.begin(),
      [&](const Vec3& at) { return TensorToReference(mesh_.ShapeOf(element), at); });
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

  const Mesh& mesh_;
  const Field& field_;
  std::size_t Components;
  bool IsPlane;
  int Coarse = 0;
  std::array<GaussRule, 2> Rules;
};

/// The magnitude that an error of a quantity is relative to.
double SizeOf(const std::vector<double>& totals, std::size_t quantity)
{
  return totals[quantity >= kFirstComponent ? kAbsolute : quantity];
}

void Summarise(std::vector<ElementQuadrature>& all, std::size_t quantities, double tolerance,
  double thickness, FieldNorms& norms)
{
  std::vector<double> sums(quantities, 0.0);
  std::vector<double> errors(quantities, 0.0);
  for (std::size_t e = 0; e < all.size(); ++e)
  {
    ElementNorms& one = all[e].norms;
    norms.boxes += all[e].looked;
    norms.folded += one.isFolded ? 1 : 0;
    if (!one.isFinite)
    {
      ++norms.notFinite;
      ElementNorms& left = norms.elements.emplace_back();
      left.isFinite = false;
      left.isFolded = one.isFolded;
      continue;
    }
    const auto estimate = [&](std::size_t q) {
      return Estimate{ all[e].Sum(q) / thickness, all[e].Error(q) / thickness };
    };
    one.volume = estimate(kVolume);
    one.absolute = estimate(kAbsolute);
    one.square = estimate(kSquare);
    for (std::size_t q = 0; q < quantities; ++q)
    {
      sums[q] += all[e].Sum(q) / thickness;
      errors[q] += all[e].Error(q) / thickness;
    }
    if (one.largest > norms.largest || norms.largestElement < 0)
    {
      norms.largest = one.largest;
      norms.largestElement = static_cast<int>(e);
    }
    norms.elements.push_back(one);
  }
  norms.met = true;
  for (std::size_t q = 0; q < quantities; ++q)
  {
    norms.met = norms.met && errors[q] <= tolerance * SizeOf(sums, q);
    errors[q] += kSumRounding * SizeOf(sums, q);
  }
  norms.volume = { sums[kVolume], errors[kVolume] };
  norms.l1 = { sums[kAbsolute], errors[kAbsolute] };
  const double square = sums[kSquare];
  norms.l2.value = std::sqrt(square);
  norms.l2.error = std::max(std::sqrt(square + errors[kSquare]) - norms.l2.value,
    norms.l2.value - std::sqrt(std::max(square - errors[kSquare], 0.0)));
  for (std::size_t q = kFirstComponent; q < quantities; ++q)
  {
    norms.integrals.push_back({ sums[q], errors[q] });
  }
}
} // namespace

FieldNorms FindNorms(const Mesh& mesh, const Field& field, double thickness,
  const NormEffort& effort, const std::function<void(double)>& progress)
{
  if (field.function != nullptr &&
    (field.function->NeedsNormals() || field.function->NeedsNeighbours()))
  {
    throw Unsupported("There are no norms of '" + field.name + "' over the mesh: " +
      (field.function->NeedsNormals() ? "it needs the normal of a surface."
                                      : "it has jumps between elements."));
  }
  const bool isPlane = thickness > 0.0;
  const NormFinder finder(mesh, field, isPlane, effort.order);
  const auto count = static_cast<std::size_t>(mesh.Elements());
  std::vector<ElementQuadrature> all(count);
  ParallelProgress first(progress, 0.0, 0.3, count);
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e)
    {
      finder.Begin(e, all[static_cast<std::size_t>(e)]);
      first.Add();
    });
  std::vector<double> totals(finder.Quantities(), 0.0);
  std::size_t finite = 0;
  for (const ElementQuadrature& one : all)
  {
    finite += one.norms.isFinite ? 1 : 0;
    for (std::size_t q = 0; one.norms.isFinite && q < totals.size(); ++q)
    {
      totals[q] += one.Sum(q);
    }
  }
  // Each element is to use half of its share, so that the sum is within the tolerance.
  std::vector<double> allowed(totals.size());
  for (std::size_t q = 0; q < totals.size(); ++q)
  {
    allowed[q] = 0.5 * effort.tolerance * SizeOf(totals, q) /
      static_cast<double>(std::max<std::size_t>(finite, 1));
  }
  const std::int64_t boxes = 1 +
    effort.evaluations /
      (finder.PointsOfBox() * std::max<std::int64_t>(static_cast<std::int64_t>(count), 1));
  ParallelProgress second(progress, 0.3, 1.0, count);
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e)
    {
      finder.Refine(e, allowed, boxes, all[static_cast<std::size_t>(e)]);
      second.Add();
    });
  FieldNorms norms;
  Summarise(all, finder.Quantities(), effort.tolerance, isPlane ? thickness : 1.0, norms);
  return norms;
}

std::optional<Interval> LargestMagnitude(
  const Mesh& mesh, const Field& field, const std::function<void(double)>& progress)
{
  constexpr RangeEffort kEffort{ 1e-4, 256 };
  const bool isVector = field.values.components > 1;
  const RangeQuestion question{ isVector ? Quantity::Magnitude : Quantity::Component, &field };
  if (!IsAnswerable(question))
  {
    return std::nullopt;
  }
  const MeshRange found = RangeOf(mesh, question, kEffort, progress);
  if (found.unbounded > 0 || found.lowerElement < 0)
  {
    return std::nullopt;
  }
  const auto sizeOf = [isVector](const Interval& range)
  { return isVector ? range.upper : std::max(-range.lower, range.upper); };
  return Interval(std::max(sizeOf(found.range.attained), 0.0), sizeOf(found.range.outer));
}

std::vector<int> OrderBySquare(const FieldNorms& norms)
{
  std::vector<int> order(norms.elements.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>(),
    [&norms](int e) { return norms.elements[static_cast<std::size_t>(e)].square.value; });
  return order;
}

int CountWithPart(const FieldNorms& norms, double part)
{
  const double total = norms.l2.value * norms.l2.value;
  double sum = 0.0;
  int count = 0;
  for (const int e : OrderBySquare(norms))
  {
    // The last ones are zero where rounding makes the sum too small.
    const double square = norms.elements[static_cast<std::size_t>(e)].square.value;
    if (sum >= part * total || square == 0.0)
    {
      break;
    }
    sum += square;
    ++count;
  }
  return count;
}
} // namespace pixelexact
