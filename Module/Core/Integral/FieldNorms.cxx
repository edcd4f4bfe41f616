// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/FieldNorms.h"

#include "Core/Base/Error.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Element/MeshRanges.h"
#include "Core/Element/ParallelProgress.h"
#include "Core/Integral/NormQuadrature.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace pixelexact
{
namespace
{
/// Relative rounding of sums, as an estimate.
constexpr double kSumRounding = 0x1p-44;

/// The magnitude that an error of a quantity is relative to.
double SizeOf(const std::vector<double>& totals, std::size_t quantity)
{
  return totals[quantity >= NormQuadrature::kFirstComponent ? NormQuadrature::kAbsolute : quantity];
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
    one.volume = estimate(NormQuadrature::kVolume);
    one.absolute = estimate(NormQuadrature::kAbsolute);
    one.square = estimate(NormQuadrature::kSquare);
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
  norms.volume = { sums[NormQuadrature::kVolume], errors[NormQuadrature::kVolume] };
  norms.l1 = { sums[NormQuadrature::kAbsolute], errors[NormQuadrature::kAbsolute] };
  const double square = sums[NormQuadrature::kSquare];
  norms.l2.value = std::sqrt(square);
  norms.l2.error = std::max(std::sqrt(square + errors[NormQuadrature::kSquare]) - norms.l2.value,
    norms.l2.value - std::sqrt(std::max(square - errors[NormQuadrature::kSquare], 0.0)));
  for (std::size_t q = NormQuadrature::kFirstComponent; q < quantities; ++q)
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
  const NormQuadrature finder(mesh, field, isPlane, effort.order);
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
