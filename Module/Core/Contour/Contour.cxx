// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/Contour.h"

#include "Core/Base/Error.h"
#include "Core/Contour/FaceOwner.h"
#include "Core/Contour/LineAssembly.h"
#include "Core/Contour/SeedList.h"
#include "Core/Faces/FacePlane.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

namespace pixelexact
{
namespace
{
/// The smallest tolerance, relative to the mesh's diagonal. A line as long as the diagonal has some
/// 100,000 points at this tolerance.
constexpr double kMinTolerance = 1e-10;

/// The contours of one element, for the values that the hulls do not exclude, in the order of the
/// values.
struct FoundInElement
{
  struct OfValue
  {
    std::size_t value = 0;
    ElementContour contour;
  };
  std::vector<OfValue> contours;
  bool finite = true;
};

/// The budget of the first pass, per element and value. It suffices for most. The second pass
/// divides the total effort between the pairs for which it did not suffice.
constexpr ContourEffort kFirst{ { 400, 32 }, 30'000 };
constexpr std::size_t kWholeEfforts = 64;

FoundInElement TraceAll(const ContourQuestion& question, int element, const ContourRequest& request)
{
  FoundInElement found;
  const CurveEquations equations(question, element);
  found.finite = equations.IsFinite();
  for (std::size_t v = 0; v < request.values.size() && equations.MayMeetCut(); ++v)
  {
    const double value = request.values[v];
    // A vector's norm is 0 at points, not on lines.
    if ((!question.IsMagnitude() || value > 0.0) && equations.MayHave(value))
    {
      found.contours.push_back(
        { v, TraceElement(question, equations, element, value, request.tolerance, kFirst) });
    }
  }
  return found;
}

/// Returns the effort for each of `pairs` pairs of element and value in the second pass; none where
/// it does not exceed that of the first.
std::optional<ContourEffort> EffortForEachOf(std::size_t pairs)
{
  const ContourEffort whole;
  const double part = std::min(
    1.0, static_cast<double>(kWholeEfforts) / static_cast<double>(std::max<std::size_t>(pairs, 1)));
  const ContourEffort effort{ { static_cast<int>(part * whole.seeds.boxes),
                                static_cast<std::size_t>(
                                  part * static_cast<double>(whole.seeds.open)) },
    static_cast<int>(part * whole.steps) };
  return effort.seeds.boxes > kFirst.seeds.boxes ? std::optional(effort) : std::nullopt;
}

void Check(const ContourRequest& request, const Box3& box)
{
  for (const double value : request.values)
  {
    if (!std::isfinite(value))
    {
      throw InvalidData(
        "contours of the value " + std::to_string(value) + " were asked for; give finite values.");
    }
  }
  if (!(request.tolerance > 0.0 && std::isfinite(request.tolerance)))
  {
    throw InvalidData("the tolerance of contours must be greater than 0, in world units.");
  }
  const double diagonal = glm::length(box.upper - box.lower);
  if (box.lower.x <= box.upper.x && request.tolerance < kMinTolerance * diagonal)
  {
    std::ostringstream text;
    text << "a tolerance of contours of " << request.tolerance << ": it may be 1e-10 of the mesh's "
         << "diagonal, " << diagonal << ", or larger.";
    throw InvalidData(text.str());
  }
}

/// Whether another element draws a piece, which lies in a face that the surface contains.
bool IsAnothers(const CurvePiece& piece, const ElementContour& contour, const Mesh& mesh,
  const FaceOwner& owner, int element)
{
  return std::ranges::any_of(contour.heldFaces,
    [&](int face)
    {
      const FacePlane& plane = FacePlanesOf(mesh.ShapeOf(element))[static_cast<std::size_t>(face)];
      return std::ranges::all_of(piece.points,
               [&](const CurvePoint& point)
               { return std::fabs(plane.Distance(point.xi)) <= kOnFace; }) &&
        owner.IsAnothers(element, face, piece.points[piece.points.size() / 2]);
    });
}
} // namespace

ContourSet TraceContours(const ContourQuestion& question, const Locator& locator,
  const FaceTable& faces, const ContourRequest& request)
{
  Check(request, locator.Bounds());
  ContourSet set;
  const auto count = static_cast<std::size_t>(question.mesh.Elements());
  std::vector<FoundInElement> found(count);
  const auto forEach = [&question](std::size_t all, const auto& visit)
  {
    if (question.cut->NeedsCallingThread())
    {
      for (std::size_t i = 0; i < all; ++i)
      {
        visit(i);
      }
    }
    else
    {
      tbb::parallel_for(std::size_t{ 0 }, all, visit);
    }
  };
  forEach(
    count, [&](std::size_t e) { found[e] = TraceAll(question, static_cast<int>(e), request); });
  // Second pass: the pairs of elements and values whose budget was exhausted share the total
  // effort.
  std::vector<std::pair<int, FoundInElement::OfValue*>> hard;
  for (std::size_t e = 0; e < count; ++e)
  {
    for (FoundInElement::OfValue& one : found[e].contours)
    {
      if (one.contour.spent)
      {
        hard.emplace_back(static_cast<int>(e), &one);
      }
    }
  }
  if (const std::optional<ContourEffort> effort = EffortForEachOf(hard.size()))
  {
    forEach(hard.size(),
      [&](std::size_t i)
      {
        const auto& [element, one] = hard[i];
        const CurveEquations equations(question, element);
        one->contour = TraceElement(
          question, equations, element, request.values[one->value], request.tolerance, *effort);
      });
  }

  const FaceOwner owner(locator, faces);
  ContourReport& report = set.report;
  report.notFinite =
    std::ranges::count_if(found, [](const FoundInElement& one) { return !one.finite; });
  std::vector<std::vector<PlacedPiece>> pieces(request.values.size());
  for (std::size_t e = 0; e < count; ++e)
  {
    const auto element = static_cast<int>(e);
    for (auto& [v, contour] : found[e].contours)
    {
      ++report.elements;
      report.undecided += contour.complete ? 0 : 1;
      report.spent += contour.spent ? 1 : 0;
      report.touched += contour.touched;
      report.constant += contour.constant ? 1 : 0;
      report.tooHigh += contour.tooHigh ? 1 : 0;
      for (CurvePiece& piece : contour.pieces)
      {
        if (!IsAnothers(piece, contour, question.mesh, owner, element))
        {
          ++report.pieces;
          report.unproven += piece.certain ? 0 : 1;
          report.lost += piece.lost ? 1 : 0;
          pieces[v].push_back({ element, std::move(piece), contour.complete });
        }
      }
    }
  }
  for (std::size_t v = 0; v < pieces.size(); ++v)
  {
    report.normsOfZero += question.IsMagnitude() && request.values[v] == 0.0 ? 1 : 0;
    AssembleLines(question.mesh, faces, std::move(pieces[v]), v, set);
  }
  return set;
}

ContourReport& ContourReport::operator+=(const ContourReport& more)
{
  for (const auto count : { &ContourReport::elements, &ContourReport::undecided,
         &ContourReport::pieces, &ContourReport::unproven, &ContourReport::lost,
         &ContourReport::spent, &ContourReport::touched, &ContourReport::constant,
         &ContourReport::notFinite, &ContourReport::tooHigh, &ContourReport::endsInside,
         &ContourReport::ambiguous, &ContourReport::normsOfZero, &ContourReport::uncertified })
  {
    this->*count += more.*count;
  }
  return *this;
}

void Append(ContourSet&& more, std::size_t valuesBefore, ContourSet& all)
{
  const auto before = static_cast<std::int64_t>(all.vertices.size());
  std::ranges::move(more.vertices, std::back_inserter(all.vertices));
  for (ContourLine& line : more.lines)
  {
    line.value += valuesBefore;
    for (std::int64_t& id : line.vertices)
    {
      id += before;
    }
    all.lines.push_back(std::move(line));
  }
  all.report += more.report;
}

ContourSet TraceContours(const ContourQuestion& question, std::span<const SurfacePatch> patches,
  const Locator& locator, const FaceTable& faces, const ContourRequest& request)
{
  ContourSet all;
  for (const SurfacePatch& patch : patches)
  {
    const PolynomialCut cut(patch.surface);
    ContourQuestion part = question;
    part.cut = &cut;
    part.clips = patch.clips;
    Append(TraceContours(part, locator, faces, request), 0, all);
  }
  std::ranges::stable_sort(all.lines, {}, &ContourLine::value);
  return all;
}
} // namespace pixelexact
