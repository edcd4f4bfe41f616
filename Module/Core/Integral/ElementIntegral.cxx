// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/ElementIntegral.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Integral/AreaBounds.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// An integral over a box with a relative error below this is exact up to rounding.
constexpr double kRounding = 4e-12;
/// Children that are together wider than this fraction of their parent show no gain. After kStalls
/// subdivisions in a row without gain, only rounding remains. A subdivision along the right
/// direction removes at least half of a reducible error, but the direction may be wrong once or
/// twice.
constexpr double kNoGain = 0.75;
constexpr int kStalls = 3;

bool IsRounding(const Sums& sums, const std::vector<double>& magnitudes)
{
  for (std::size_t q = 0; q < sums.size(); ++q)
  {
    if (!(sums[q].Width() <= kRounding * magnitudes[q]))
    {
      return false;
    }
  }
  return true;
}

double WidthOf(const Interval& value)
{
  return std::isfinite(value.lower) && std::isfinite(value.upper)
    ? value.Width()
    : std::numeric_limits<double>::infinity();
}
} // namespace

int LongestSide(ElementFunctions& functions, const PieceBox& box)
{
  int longest = -1;
  double most = 0.0;
  std::array<BoxPolynomial, 3> map{ functions.Map3(box, 0), functions.Map3(box, 1),
    functions.Map3(box, 2) };
  for (int d = 0; d < 3; ++d)
  {
    if (!(box.upper[d] - box.lower[d] > kSmallestIntegralBox))
    {
      continue;
    }
    double length = 0.0;
    for (const BoxPolynomial& y : map)
    {
      length += std::pow(y.Variation(d, 1), 2);
    }
    if (length > most || longest < 0)
    {
      most = length;
      longest = d;
    }
  }
  return longest;
}

int MostBentSide(ElementFunctions& functions, const PieceBox& box)
{
  const BoxPolynomial cut = functions.Cut(box);
  std::array<double, 3> bend{};
  double error = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const BoxPolynomial slope = Derivative(cut, c);
    error = std::max(error, slope.error);
    for (int d = 0; d < 3; ++d)
    {
      const bool wide = box.upper[d] - box.lower[d] > kSmallestIntegralBox;
      bend[static_cast<std::size_t>(d)] += wide ? slope.Variation(d, 1) : 0.0;
    }
  }
  const double most = std::ranges::max(bend);
  if (!(most > 2.0 * error))
  {
    return -1;
  }
  int best = -1;
  double longest = -1.0;
  for (int d = 0; d < 3; ++d)
  {
    double length = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      length += std::pow(functions.Map3(box, c).Variation(d, 1), 2);
    }
    if (bend[static_cast<std::size_t>(d)] >= 0.5 * most && length > longest)
    {
      longest = length;
      best = d;
    }
  }
  return best;
}

double CutTolerance(ElementFunctions& functions, const PieceBox& box)
{
  const BoxPolynomial cut = functions.Cut(box); // which makes the unit
  return 4.0 * cut.error +
    2.0 * functions.Unit() * functions.Question().cut->Uncertainty(functions, box);
}

namespace
{
/// Whether `sign` times the cut's function is nowhere below zero by more than its tolerance, where
/// this holds for the piece as a whole. The tolerance falls with the function's gradient, so that a
/// vertex may hold a surface that is small compared with the piece's tolerance.
bool IsOnSide(ElementFunctions& functions, const PieceBox& piece, double sign)
{
  constexpr std::size_t kMaxBoxes = 128;
  std::vector<std::pair<double, PieceBox>> open{ { 0.0, piece } }; // the lowest on top
  const auto isHigher = [](const auto& a, const auto& b) { return a.first > b.first; };
  for (std::size_t looked = 0; looked < kMaxBoxes && !open.empty(); ++looked)
  {
    std::ranges::pop_heap(open, isHigher);
    const PieceBox box = open.back().second;
    open.pop_back();
    const int direction = LongestSide(functions, box);
    for (const bool isUpper : { false, true })
    {
      PieceBox half = box;
      (isUpper ? half.lower : half.upper)[std::max(direction, 0)] =
        0.5 * (box.lower[std::max(direction, 0)] + box.upper[std::max(direction, 0)]);
      const Interval hull = functions.Cut(half).Hull();
      const double least = sign > 0.0 ? hull.lower : -hull.upper;
      const double tolerance = CutTolerance(functions, half);
      if (least < -tolerance)
      {
        return false;
      }
      if (least < 0.0 && direction >= 0)
      {
        open.emplace_back(least / tolerance, half);
        std::ranges::push_heap(open, isHigher);
      }
    }
  }
  return true;
}

} // namespace

ElementMeeting MeetingOf(ElementFunctions& functions)
{
  ElementMeeting meeting;
  if (!functions.IsFinite() || functions.IsTooHigh())
  {
    meeting.problem = functions.IsFinite() ? ElementProblem::TooHigh : ElementProblem::NotFinite;
    return meeting;
  }
  const std::span<const ShapeFace> faces = FacesOf(functions.GetShape());
  unsigned held = (1U << faces.size()) - 1;
  bool positive = true;
  bool negative = true;
  bool meets = false;
  bool off = true;
  for (const PieceBox& piece : functions.Pieces())
  {
    off = off && IsClippedOff(functions, piece);
    const BoxPolynomial cut = functions.Cut(piece);
    const double tolerance = CutTolerance(functions, piece);
    const Interval hull = cut.Hull();
    const bool isCurved = functions.Question().cut->Factor() > 1;
    positive = positive && hull.lower >= -tolerance &&
      (hull.lower >= 0.0 || !isCurved || IsOnSide(functions, piece, 1.0));
    negative = negative && hull.upper <= tolerance &&
      (hull.upper <= 0.0 || !isCurved || IsOnSide(functions, piece, -1.0));
    meets = meets || hull.Contains(0.0);
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      if (functions.IsOnCube(piece, faces[f].direction, faces[f].upper))
      {
        const Interval end = cut.AtEnd(faces[f].direction, faces[f].upper).Hull();
        held &= end.Magnitude() <= tolerance ? ~0U : ~(1U << f);
      }
    }
  }
  if (off)
  {
    return meeting;
  }
  meeting.isClear = !meets;
  if (positive && negative)
  {
    // The element is thinner than its uncertainty: what the surface has in it is small, but it is
    // not a face of it. A field that has the value throughout is no surface.
    const bool isOfPlace = functions.Question().cut->MadeOf() == nullptr;
    meeting.problem = isOfPlace ? ElementProblem::None : ElementProblem::Flat;
    meeting.inside = isOfPlace && meets;
    return meeting;
  }
  meeting.faces = held;
  meeting.above = positive;
  meeting.inside = meets && !positive && !negative;
  return meeting;
}

ElementIntegral::ElementIntegral(const IntegralQuestion& question, int element)
  : Question(question)
  , Element(element)
{
  ElementFunctions functions(question, element);
  for (const PieceBox& piece : functions.Pieces())
  {
    Tolerance = std::max(Tolerance, CutTolerance(functions, piece));
    Look(functions, piece);
  }
}

ElementIntegral::~ElementIntegral() = default;
ElementIntegral::ElementIntegral(ElementIntegral&&) noexcept = default;

Sums ElementIntegral::Total() const
{
  Sums total(Question.Quantities());
  for (const Part& part : Parts)
  {
    AddTo(total, part.sums);
  }
  return total;
}

std::vector<double> ElementIntegral::Magnitudes() const
{
  std::vector<double> sum(Question.Quantities());
  for (const Part& part : Parts)
  {
    for (std::size_t q = 0; q < sum.size(); ++q)
    {
      sum[q] += part.magnitudes[q];
    }
  }
  return sum;
}

double ElementIntegral::Unresolved() const
{
  double area = 0.0;
  for (const Part& part : Parts)
  {
    area += part.resolved ? 0.0 : part.sums[0].upper;
  }
  return area;
}

std::int64_t ElementIntegral::Rounded() const
{
  return std::ranges::count_if(
    Parts, [](const Part& part) { return part.stalled >= kStalls || part.direction < 0; });
}

void ElementIntegral::AddUnresolved(ElementFunctions& functions, const PieceBox& box, int direction)
{
  Sums bounds = BoundIn(functions, box);
  DropZeroField(functions, bounds);
  Parts.push_back(
    { box, std::move(bounds), std::vector<double>(Question.Quantities()), direction, false });
}

void ElementIntegral::NoteGain(std::size_t first, int stalled, double before, double after)
{
  for (std::size_t k = first; k < Parts.size(); ++k)
  {
    Parts[k].stalled = after >= kNoGain * before ? stalled + 1 : 0;
    Parts[k].direction = Parts[k].stalled < kStalls ? Parts[k].direction : -1;
  }
}

void ElementIntegral::Look(ElementFunctions& functions, const PieceBox& box)
{
  ++Looked;
  const CutInBox found = LookAtCut(functions, box, Tolerance);
  if (found.empty || IsClippedOff(functions, found.box))
  {
    return;
  }
  Sums sums(Question.Quantities());
  std::vector<double> magnitudes(Question.Quantities());
  bool resolved = found.decided;
  int direction = -1;
  bool anyRange = false;
  for (std::size_t g = 0; g < found.graphs.size() && resolved; ++g)
  {
    const auto part = Integrate(functions, found.graphs[g]);
    resolved = part.has_value();
    if (resolved)
    {
      AddTo(sums, part->sums);
      direction = part->roughest;
      anyRange = anyRange || part->anyRange;
      for (std::size_t q = 0; q < magnitudes.size(); ++q)
      {
        magnitudes[q] += part->magnitudes[q];
      }
    }
  }
  if (!resolved)
  {
    AddUnresolved(functions, found.box,
      found.decided ? LongestSide(functions, found.box) : MostBentSide(functions, found.box));
    return;
  }
  for (const CutGraph& strip : found.rest)
  {
    AddTo(sums, BoundOn(functions, strip));
  }
  DropZeroField(functions, sums);
  if (direction >= 0)
  {
    if (IsRounding(sums, magnitudes))
    {
      Parts.push_back({ found.box, sums, magnitudes, -1, true });
      return;
    }
    const bool wide =
      found.box.upper[direction] - found.box.lower[direction] > kSmallestIntegralBox;
    Parts.push_back({ found.box, sums, magnitudes,
      wide ? direction : LongestSide(functions, found.box), true, anyRange });
  }
  else if (!found.rest.empty())
  {
    Parts.push_back({ found.box, sums, magnitudes, LongestSide(functions, found.box), true });
  }
}

bool ElementIntegral::Refine(
  const std::vector<double>& allowed, std::int64_t boxes, const std::function<bool()>& stop)
{
  const auto badness = [&allowed](const Sums& sums)
  {
    double worst = 0.0;
    for (std::size_t q = 0; q < sums.size(); ++q)
    {
      worst = std::max(worst, WidthOf(sums[q]) / allowed[q]);
    }
    return worst;
  };
  if (badness(Total()) <= 1.0)
  {
    return true;
  }
  ElementFunctions functions(Question, Element);
  std::vector<std::pair<double, std::size_t>> heap; // of parts that can be subdivided
  // The error of all parts together, or an upper bound: the number of unbounded ones and the sum of
  // the others.
  int unbounded = 0;
  double known = 0.0;
  const auto count = [&](double bad, int sign)
  {
    unbounded += std::isfinite(bad) ? 0 : sign;
    known += std::isfinite(bad) ? sign * bad : 0.0;
  };
  const auto push = [&](std::size_t at)
  {
    const double bad = badness(Parts[at].sums);
    count(bad, 1);
    if (Parts[at].direction >= 0)
    {
      heap.emplace_back(bad, at);
      std::ranges::push_heap(heap);
    }
  };
  for (std::size_t at = 0; at < Parts.size(); ++at)
  {
    push(at);
  }
  std::vector<char> gone(Parts.size(), 0);
  const std::int64_t last = Looked + boxes;
  while (!heap.empty() && (unbounded > 0 || known > 0.99) && Looked < last && !stop())
  {
    std::ranges::pop_heap(heap);
    const auto [bad, at] = heap.back();
    count(bad, -1);
    heap.pop_back();
    gone[at] = 1;
    const Part part = Parts[at];
    PieceBox lower = part.box;
    PieceBox upper = part.box;
    const int d = part.direction;
    const double middle =
      part.box.lower[d] + kBoxDivision * (part.box.upper[d] - part.box.lower[d]);
    lower.upper[d] = middle;
    upper.lower[d] = middle;
    const std::size_t first = Parts.size();
    Look(functions, lower);
    Look(functions, upper);
    gone.resize(Parts.size(), 0);
    double after = 0.0;
    bool resolved = part.resolved;
    for (std::size_t k = first; k < Parts.size(); ++k)
    {
      after += badness(Parts[k].sums);
      resolved = resolved && Parts[k].resolved;
    }
    // Rims of clips gain in another direction than the surface does, and kinks need two directions.
    if (resolved && std::isfinite(bad) && Question.clips.empty() && !Question.below &&
      !part.anyRange)
    {
      NoteGain(first, part.stalled, bad, after);
    }
    for (std::size_t k = first; k < Parts.size(); ++k)
    {
      push(k);
    }
  }
  std::vector<Part> left;
  for (std::size_t k = 0; k < Parts.size(); ++k)
  {
    if (gone[k] == 0)
    {
      left.push_back(std::move(Parts[k]));
    }
  }
  Parts = std::move(left);
  return badness(Total()) <= 1.0;
}
} // namespace pixelexact
