// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/MeshRanges.h"

#include "Core/Element/ParallelProgress.h"
#include "Core/Element/Validity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pixelexact
{
namespace
{
/// Boxes per element in the first round of refinement; each further round has eight times as many.
constexpr int kFirstBudget = 16;
/// Boxes after which an unbounded expression is abandoned: it has a pole, or is not defined.
constexpr int kMaxUnbounded = 1000;

/// A range in units of 2^exponent.
struct ElementFinding
{
  CertifiedRange range;
  int exponent = 0;
  bool givenUp = false;
};

/// Converts an attained range to other units, rounded inwards.
Interval Inside(const Interval& attained, int exponent)
{
  return { Scaled(Interval(attained.lower), exponent).upper,
    Scaled(Interval(attained.upper), exponent).lower };
}

class Rounds
{
public:
  Rounds(const Mesh& mesh, const RangeQuestion& question, const RangeEffort& effort)
    : mesh_(mesh)
    , Question(question)
    , Effort(effort)
    , Findings(static_cast<std::size_t>(mesh.Elements()))
  {
  }

  void LookAt(const std::vector<int>& elements, int budget, ParallelProgress& progress)
  {
    const double gap = AllowedGap(Range, Effort.tolerance);
    tbb::parallel_for(std::size_t{ 0 }, elements.size(),
      [&](std::size_t i)
      {
        Findings[static_cast<std::size_t>(elements[i])] = Look(elements[i], gap, budget);
        progress.Add();
      });
    Gather(elements);
  }

  /// Abandons elements that stay unbounded: they are not valid, or an expression is not defined in
  /// them.
  void GiveUpUnboundedElements()
  {
    const bool isExpression = Question.field != nullptr && Question.field->function != nullptr;
    tbb::parallel_for(std::size_t{ 0 }, Findings.size(),
      [&](std::size_t e)
      {
        ElementFinding& finding = Findings[e];
        if (finding.range.finite && !finding.range.outer.IsFinite() && !finding.givenUp)
        {
          finding.givenUp = (isExpression && finding.range.boxes >= kMaxUnbounded) ||
            ValidityOf(mesh_, static_cast<int>(e), Effort).validity != Validity::Valid;
        }
      });
  }

  /// Elements that may hold values outside the allowed range.
  [[nodiscard]] std::vector<int> Candidates() const
  {
    const double gap = AllowedGap(Range, Effort.tolerance);
    std::vector<int> candidates;
    for (std::size_t e = 0; e < Findings.size(); ++e)
    {
      const CertifiedRange one = InOurUnits(Findings[e]);
      if (one.finite && !Findings[e].givenUp &&
        !(Range.attained.lower - one.outer.lower <= gap &&
          one.outer.upper - Range.attained.upper <= gap))
      {
        candidates.push_back(static_cast<int>(e));
      }
    }
    return candidates;
  }

  [[nodiscard]] MeshRange Result() const
  {
    MeshRange result = Found;
    result.range = Scaled(Range, Exponent);
    return result;
  }

private:
  [[nodiscard]] ElementFinding Look(int element, double gap, int budget) const;
  [[nodiscard]] CertifiedRange InOurUnits(const ElementFinding& finding) const
  {
    return Scaled(finding.range, finding.exponent - Exponent);
  }
  void ChooseUnits();
  void Gather(const std::vector<int>& looked);

  const Mesh& mesh_;
  RangeQuestion Question;
  RangeEffort Effort;
  std::vector<ElementFinding> Findings;
  MeshRange Found;
  /// The range over the mesh, in units of 2^Exponent, relative to the largest element's
  /// coefficients.
  CertifiedRange Range;
  int Exponent = 0;
};

/// Refines one element in a round until its bounds exceed the attained range by at most `gap`.
ElementFinding Rounds::Look(int element, double gap, int budget) const
{
  const ElementRange range(mesh_, element, Question);
  ElementFinding finding;
  finding.exponent = range.Exponent();
  finding.range.finite = range.IsFinite();
  if (finding.range.finite)
  {
    const int shift = Exponent - finding.exponent;
    const auto search = range.Begin(Inside(Range.attained, shift));
    finding.range = SearchRange(*search, 0.0, std::ldexp(gap, shift), budget);
  }
  return finding;
}

void Rounds::ChooseUnits()
{
  bool any = false;
  for (const ElementFinding& finding : Findings)
  {
    if (finding.range.finite)
    {
      Exponent = any ? std::max(Exponent, finding.exponent) : finding.exponent;
      any = true;
    }
  }
}

void Rounds::Gather(const std::vector<int>& looked)
{
  if (Found.boxes == 0)
  {
    ChooseUnits();
  }
  for (const int e : looked)
  {
    const CertifiedRange one = InOurUnits(Findings[static_cast<std::size_t>(e)]);
    Found.boxes += one.boxes;
    if (one.attained.lower < Range.attained.lower)
    {
      Range.attained.lower = one.attained.lower;
      Found.lowerElement = e;
      Found.lowerPoint = one.lowerPoint;
    }
    if (one.attained.upper > Range.attained.upper)
    {
      Range.attained.upper = one.attained.upper;
      Found.upperElement = e;
      Found.upperPoint = one.upperPoint;
    }
  }
  Found.notFinite = 0;
  Found.unbounded = 0;
  Range.outer = CertifiedRange{}.attained;
  for (const ElementFinding& finding : Findings)
  {
    if (!finding.range.finite)
    {
      ++Found.notFinite;
      continue;
    }
    const CertifiedRange one = InOurUnits(finding);
    Found.unbounded += one.outer.IsFinite() ? 0 : 1;
    Range.outer = Join(Range.outer, one.outer);
  }
  Range.met = IsWithin(Range, Effort.tolerance);
}
} // namespace

std::vector<CertifiedRange> ElementRanges(const Mesh& mesh, const RangeQuestion& question,
  const RangeEffort& effort, const RangeProgress& progress)
{
  std::vector<CertifiedRange> ranges(static_cast<std::size_t>(mesh.Elements()));
  ParallelProgress done(progress, 0.0, 1.0, ranges.size());
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e)
    {
      ranges[static_cast<std::size_t>(e)] = RangeOf(mesh, e, question, effort);
      done.Add();
    });
  done.Finish();
  return ranges;
}

MeshRange RangeOf(const Mesh& mesh, const RangeQuestion& question, const RangeEffort& effort,
  const RangeProgress& progress)
{
  RequireAnswer(question);
  Rounds rounds(mesh, question, effort);
  std::vector<int> elements(static_cast<std::size_t>(mesh.Elements()));
  std::iota(elements.begin(), elements.end(), 0);
  double done = 0.0;
  for (int budget = 1; !elements.empty(); budget = std::min(budget * 8, effort.boxes))
  {
    const double next = done + (1.0 - done) / 2.0;
    ParallelProgress part(progress, done, next, elements.size());
    rounds.LookAt(elements, budget, part);
    done = next;
    if (budget >= effort.boxes || mesh.Elements() == 0)
    {
      break;
    }
    if (budget >= kFirstBudget)
    {
      rounds.GiveUpUnboundedElements();
    }
    elements = rounds.Candidates();
    budget = std::max(budget, kFirstBudget / 8);
  }
  if (progress)
  {
    progress(1.0);
  }
  return rounds.Result();
}
} // namespace pixelexact
