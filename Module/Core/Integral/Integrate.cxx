// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/Integrate.h"

#include "Core/Base/Error.h"
#include "Core/Element/Validity.h"
#include "Core/Integral/CutParts.h"
#include "Core/Integral/FaceSums.h"
#include "Core/Integral/IntegralCut.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
/// Boxes per element in the first round.
constexpr std::int64_t kFirstBoxes = 16;
/// The growth of the number of boxes per round. Each round recomputes the allowed widths, so that
/// elements share a limited time evenly.
constexpr std::int64_t kMoreBoxes = 3;

void Check(const IntegralEffort& effort)
{
  if (!(effort.tolerance > 0.0 && std::isfinite(effort.tolerance)))
  {
    throw InvalidData("the tolerance of an integral must be greater than 0 and finite.");
  }
  if (!(effort.seconds > 0.0))
  {
    throw InvalidData("the seconds for an integral must be more than 0.");
  }
}

/// Functions without coefficients may be of any kind, so their default limit is a minute.
double SecondsFor(const IntegralQuestion& question, const IntegralEffort& effort)
{
  constexpr double kOfFunctions = 60.0;
  return question.IsFunction() ? std::min(effort.seconds, kOfFunctions) : effort.seconds;
}

/// Sums of which each may also be zero.
void JoinZero(Sums& sums)
{
  for (Interval& sum : sums)
  {
    sum = Join(sum, Interval(0.0));
  }
}
} // namespace

SurfaceIntegral IntegrateCut(const IntegralQuestion& question, const Locator& locator,
  const FaceTable& faces, const IntegralEffort& effort)
{
  Check(effort);
  CheckSizes(question);
  const Deadline deadline(SecondsFor(question, effort));
  const CutParts met = FindCutParts(question, locator, faces);
  SurfaceIntegral result;
  result.sums.resize(question.Quantities());
  result.notFinite = met.notFinite;
  result.tooHigh = met.tooHigh;
  result.flat = met.flat;
  const std::vector<int>& inside = met.inside;
  SurfaceIntegral ofFaces = OverFaces(question, met.held, effort, deadline);
  if (!met.unsure.empty())
  {
    SurfaceIntegral unsure = OverFaces(question, met.unsure, effort, deadline);
    JoinZero(unsure.sums);
    AddTo(ofFaces, unsure);
  }
  Rounds rounds(question.Quantities(), effort);
  std::vector<std::optional<ElementIntegral>> parts(inside.size());
  const auto stop = [&deadline] { return deadline.IsOver(); };
  tbb::parallel_for(
    std::size_t{ 0 }, inside.size(), [&](std::size_t k) { parts[k].emplace(question, inside[k]); });
  for (std::int64_t boxes = kFirstBoxes;; boxes *= kMoreBoxes)
  {
    Sums total = ofFaces.sums;
    rounds.Magnitudes = ofFaces.magnitudes;
    std::size_t meeting = 0;
    for (const auto& part : parts)
    {
      AddTo(total, part->Total());
      const std::vector<double> magnitudes = part->Magnitudes();
      for (std::size_t q = 0; q < magnitudes.size(); ++q)
      {
        rounds.Magnitudes[q] += magnitudes[q];
      }
      meeting += part->IsEmpty() ? 0 : 1;
    }
    result.sums = total;
    result.met = rounds.IsMet(total);
    result.elements = static_cast<std::int64_t>(meeting);
    if (result.met || boxes > effort.boxes || deadline.IsOver())
    {
      break;
    }
    const std::vector<double> allowed = rounds.Share(meeting);
    tbb::parallel_for(std::size_t{ 0 }, inside.size(),
      [&](std::size_t k) { parts[k]->Refine(allowed, boxes, stop); });
  }
  result.magnitudes = rounds.Magnitudes;
  result.timeIsOver = deadline.IsOver() && !result.met;
  result.faces = static_cast<std::int64_t>(met.held.size() + met.unsure.size());
  std::atomic<std::int64_t> notValid{ 0 };
  tbb::parallel_for(std::size_t{ 0 }, inside.size(),
    [&](std::size_t k)
    {
      if (!parts[k]->IsEmpty() && ValidityOf(question.mesh, inside[k]).validity != Validity::Valid)
      {
        ++notValid;
      }
    });
  result.notValid = notValid + ofFaces.notValid;
  result.boxes = ofFaces.boxes;
  for (const auto& part : parts)
  {
    result.boxes += part->Boxes();
    result.rounded += part->Rounded();
    result.unresolved += part->Unresolved();
  }
  result.isNumeric = IsNumeric(question);
  return result;
}

void AddTo(SurfaceIntegral& sum, const SurfaceIntegral& more)
{
  if (sum.sums.empty())
  {
    sum = more;
    return;
  }
  AddTo(sum.sums, more.sums);
  for (std::size_t q = 0; q < sum.magnitudes.size(); ++q)
  {
    sum.magnitudes[q] += more.magnitudes[q];
  }
  sum.met = sum.met && more.met;
  sum.elements += more.elements;
  sum.faces += more.faces;
  sum.boxes += more.boxes;
  sum.rounded += more.rounded;
  sum.unresolved += more.unresolved;
  sum.notFinite = std::max(sum.notFinite, more.notFinite);
  sum.tooHigh = std::max(sum.tooHigh, more.tooHigh);
  sum.flat = std::max(sum.flat, more.flat);
  sum.notValid = std::max(sum.notValid, more.notValid);
  sum.covered += more.covered;
  sum.timeIsOver = sum.timeIsOver || more.timeIsOver;
  sum.isNumeric = sum.isNumeric || more.isNumeric;
}

SurfaceIntegral IntegrateFaces(const IntegralQuestion& question, std::span<const ElementFace> faces,
  const IntegralEffort& effort)
{
  Check(effort);
  CheckSizes(question);
  std::vector<SeenFace> seen;
  for (const ElementFace& face : faces)
  {
    seen.push_back({ face });
  }
  SurfaceIntegral result =
    OverFaces(question, seen, effort, Deadline(SecondsFor(question, effort)));
  result.isNumeric = IsNumeric(question);
  return result;
}
} // namespace pixelexact
