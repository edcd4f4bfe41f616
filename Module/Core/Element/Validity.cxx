// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Validity.h"

#include "Core/Element/ParallelProgress.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
/// The memory limit of one element: 64 MiB.
constexpr std::size_t kMaxHeld = std::size_t{ 1 } << 23U;
/// Subdivision finds no point that is proven to be negative where a box's enclosure reaches below
/// zero by less than this many times the width of the enclosure of a point.
constexpr double kRoundingOnly = 8.0;

/// Whether subdivision can neither prove that the function is positive in a box nor that it is
/// negative somewhere: a corner's value is zero within rounding, and no value is below that.
bool IsZeroWithinRounding(const RangeBox& box)
{
  return box.lowestCorner <= 0.0 && -box.bound.lower <= kRoundingOnly * box.rounding;
}

/// Searches for a point where a function is not positive, or for a proof that there is none.
class SignSearch
{
public:
  explicit SignSearch(const ElementRange& element)
    : Function(element.Function())
  {
    element.ForEachBox([this](RangeBox box) { Add(std::move(box)); });
  }

  void Run(int budget)
  {
    while (!Boxes.empty() && Found.attained.lower > 0.0 && Found.boxes < budget)
    {
      RangeBox lower = Take();
      if (IsZeroWithinRounding(lower))
      {
        Touching = true;
        Found.outer = Join(Found.outer, lower.bound);
        continue;
      }
      RangeBox upper = lower.Subdivide(Function);
      Add(std::move(lower));
      Add(std::move(upper));
    }
    for (const RangeBox& box : Boxes)
    {
      Found.outer = Join(Found.outer, box.bound);
    }
  }

  [[nodiscard]] Validity Verdict() const
  {
    if (Found.attained.lower <= 0.0)
    {
      return Validity::Inverted;
    }
    return Boxes.empty() && !Touching ? Validity::Valid : Validity::Undecided;
  }
  [[nodiscard]] const CertifiedRange& Range() const { return Found; }

private:
  void Add(RangeBox box)
  {
    const Interval attained = box.Look(Function).values;
    Found.attained = Join(Found.attained, attained);
    ++Found.boxes;
    if (box.bound.lower > 0.0)
    {
      Found.outer = Join(Found.outer, box.bound);
      return;
    }
    if (box.remake)
    {
      box.polynomials.clear();
      box.polynomials.shrink_to_fit();
    }
    Held += box.Held();
    Boxes.push_back(std::move(box));
  }

  /// Takes the box whose enclosure reaches lowest. Where memory gets short, takes the latest box,
  /// so that few boxes wait.
  RangeBox Take()
  {
    if (Held <= kMaxHeld)
    {
      std::swap(
        *std::ranges::min_element(Boxes,
          [](const RangeBox& a, const RangeBox& b) { return a.bound.lower < b.bound.lower; }),
        Boxes.back());
    }
    RangeBox box = std::move(Boxes.back());
    Boxes.pop_back();
    Held -= box.Held();
    return box;
  }

  const RangeFunction& Function;
  std::vector<RangeBox> Boxes; ///< in which the function may be not positive
  CertifiedRange Found{ CertifiedRange{}.attained };
  std::size_t Held = 0;
  bool Touching = false; ///< a box was given up, for rounding
};
} // namespace

const char* Name(Validity validity)
{
  switch (validity)
  {
    case Validity::Valid:
      return "valid";
    case Validity::Inverted:
      return "inverted";
    default:
      return "undecided";
  }
}

ElementValidity ValidityOf(const Mesh& mesh, int element, const RangeEffort& effort)
{
  // The range is in the element's units, where det J does not underflow.
  const ElementRange range(mesh, element, { Quantity::Jacobian });
  SignSearch search(range);
  search.Run(effort.boxes);
  return { search.Verdict(), Scaled(search.Range(), range.Exponent()) };
}

std::vector<ElementValidity> ValidityOf(
  const Mesh& mesh, const RangeEffort& effort, const RangeProgress& progress)
{
  std::vector<ElementValidity> all(static_cast<std::size_t>(mesh.Elements()));
  ParallelProgress done(progress, 0.0, 1.0, all.size());
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e)
    {
      all[static_cast<std::size_t>(e)] = ValidityOf(mesh, e, effort);
      done.Add();
    });
  done.Finish();
  return all;
}
} // namespace pixelexact
