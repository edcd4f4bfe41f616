// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/Integrate.h"

#include "Core/Base/Error.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Element/Validity.h"
#include "Core/Faces/ReferenceFace.h"
#include "Core/Integral/FaceSums.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Location/Sample.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

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

/// Throws where sizes would over- or underflow: functions of the place of degree n are of the size
/// of lengths^n, and the integrals of these times lengths^3.
void CheckSizes(const IntegralQuestion& question)
{
  constexpr double kLargest = 1e100;
  const bool isOfPlace = question.cut != nullptr && question.cut->MadeOf() == nullptr;
  int factor = isOfPlace ? question.cut->Factor() : 1;
  for (const ImplicitPolynomial& clip : question.clips)
  {
    factor = std::max(factor, clip.Degree());
  }
  const double largest = factor == 1 ? kLargest : std::ldexp(1.0, 400 / (factor + 1));
  for (int e = 0; e < question.mesh.Elements(); ++e)
  {
    const double size = question.mesh.size[static_cast<std::size_t>(e)];
    if (size > 0.0 && !(size <= largest && size >= 1.0 / largest))
    {
      std::ostringstream text;
      text << "integrals"
           << (factor > 2      ? " over tori"
                  : factor > 1 ? " over quadrics"
                               : "")
           << " are taken where elements are of sizes from " << 1.0 / largest << " to " << largest
           << "; element " << e << " is of size " << size << ". Give the mesh in other units.";
      throw Unsupported(text.str());
    }
  }
}

bool IsFunction(const IntegralQuestion& question)
{
  return question.field != nullptr && question.field->function != nullptr;
}

bool IsNumeric(const IntegralQuestion& question)
{
  return IsFunction(question) &&
    std::ranges::any_of(question.mesh.map.spaces,
      [&question](const Space& space)
      { return !question.field->function->HasModels(space.shape); });
}

/// Functions without coefficients may be of any kind, so their default limit is a minute.
double SecondsFor(const IntegralQuestion& question, const IntegralEffort& effort)
{
  constexpr double kOfFunctions = 60.0;
  return IsFunction(question) ? std::min(effort.seconds, kOfFunctions) : effort.seconds;
}

/// Whether a face lies in the surface and belongs to this element's integral.
bool IsOurs(const Mesh& mesh, const FaceOwner& owner, int element, int face)
{
  const ReferenceFace& reference = ReferenceFaceOf(mesh.ShapeOf(element), face);
  CurvePoint point;
  point.xi = reference.At({ 1.0 / 3.0, 1.0 / 3.0 });
  MapForward(mesh, element, std::span(&point.xi, 1), std::span(&point.x, 1));
  return !owner.IsAnothers(element, face, point);
}

/// Elements and faces that a cut meets.
struct MetParts
{
  std::vector<int> inside;
  std::vector<SeenFace> held;
  /// Faces on which it lies, unless it lies in the interior of the element behind them.
  std::vector<SeenFace> unsure;
};

/// Adds the faces of an element that lie in the surface. Elements decide that with their own
/// uncertainties, which differ with their sizes: a face that one element holds may be clear of the
/// surface, or cut by it, for the other ones.
class HeldFaces
{
public:
  /// `near`: in ascending order, with their meetings.
  HeldFaces(const IntegralQuestion& question, const Locator& locator, const FaceTable& faces,
    std::span<const int> near, std::span<const ElementMeeting> meetings)
    : question_(question)
    , locator_(locator)
    , Faces(faces)
    , Owner(locator, faces)
    , Near(near)
    , Meetings(meetings)
  {
  }

  void Add(int element, const ElementMeeting& meeting, MetParts& met) const
  {
    for (int f = 0; f < 6; ++f)
    {
      if (meeting.Holds(f))
      {
        const FaceKind kind = Faces.KindOf(element, f);
        const Count counts = kind == FaceKind::Interior ? BesideOne(element, meeting, f)
          : kind == FaceKind::Boundary                  ? Count::Whole
                                                        : BesideSeveral(element, meeting, f);
        const SeenFace seen{ { element, f }, meeting.above ? -1.0 : 1.0 };
        if (counts == Count::Unsure)
        {
          met.unsure.push_back(seen);
        }
        else if (counts == Count::Alone ||
          (counts == Count::Whole && IsOurs(question_.mesh, Owner, element, f)))
        {
          met.held.push_back(seen);
        }
      }
    }
  }

private:
  enum class Count : std::uint8_t
  {
    Never,  ///< the surface is in the interior, or on another face, of the elements behind
    Unsure, ///< the face's integral or nothing
    Whole,  ///< once, for this element or another one that holds it (IsOurs)
    Alone   ///< the elements behind are clear of the surface
  };

  [[nodiscard]] const ElementMeeting* MeetingOf(int element) const
  {
    const auto found = std::ranges::lower_bound(Near, element);
    return found != Near.end() && *found == element
      ? &Meetings[static_cast<std::size_t>(found - Near.begin())]
      : nullptr;
  }

  [[nodiscard]] Count BesideOne(int element, const ElementMeeting& meeting, int face) const
  {
    const ElementFace behind = Faces.NeighbourOf(element, face);
    const ElementMeeting* const other = behind.element >= 0 ? MeetingOf(behind.element) : nullptr;
    if (other == nullptr || other->problem != ElementProblem::None)
    {
      return Count::Whole;
    }
    if (other->inside)
    {
      return meeting.isClear ? Count::Never : Count::Unsure;
    }
    if (other->Holds(behind.face))
    {
      return Count::Whole;
    }
    // If neither is proven clear of it, the surface may be in this one, or on another face of the
    // other one alone.
    return other->isClear && !meeting.isClear ? Count::Alone
      : meeting.isClear && other->faces != 0  ? Count::Never
                                              : Count::Unsure;
  }

  /// Elements behind a hanging face are among those whose boxes meet the element's.
  [[nodiscard]] Count BesideSeveral(int element, const ElementMeeting& meeting, int face) const
  {
    const ReferenceFace& reference = ReferenceFaceOf(question_.mesh.ShapeOf(element), face);
    std::vector<int> beside;
    locator_.Index().FindNear(BoxOfCorners(element, reference), beside);
    bool areHolding = true;
    bool areInside = true;
    for (const int other : beside)
    {
      const ElementMeeting* const own = other == element ? nullptr : MeetingOf(other);
      if (own != nullptr && own->problem == ElementProblem::None)
      {
        areHolding = areHolding && !own->inside && own->faces != 0;
        areInside = areInside && own->inside;
      }
    }
    return areHolding ? Count::Whole : areInside && meeting.isClear ? Count::Never : Count::Unsure;
  }

  /// The box of the images of a face's corners.
  [[nodiscard]] Box3 BoxOfCorners(int element, const ReferenceFace& reference) const
  {
    const auto corners = static_cast<std::size_t>(reference.corners);
    std::vector<Vec3> x(corners);
    MapForward(question_.mesh, element, std::span(reference.corner).first(corners), x);
    Box3 box{ x.front(), x.front() };
    for (const Vec3& corner : x)
    {
      box.lower = glm::min(box.lower, corner);
      box.upper = glm::max(box.upper, corner);
    }
    return box;
  }

  const IntegralQuestion& question_;
  const Locator& locator_;
  const FaceTable& Faces;
  FaceOwner Owner;
  std::span<const int> Near;
  std::span<const ElementMeeting> Meetings;
};

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
  std::vector<int> near(static_cast<std::size_t>(question.mesh.Elements()));
  std::iota(near.begin(), near.end(), 0);
  if (question.within)
  {
    locator.Index().FindNear(*question.within, near);
    std::ranges::sort(near);
  }
  std::vector<ElementMeeting> meetings(near.size());
  tbb::parallel_for(std::size_t{ 0 }, near.size(),
    [&](std::size_t k)
    {
      ElementFunctions functions(question, near[k]);
      meetings[k] = MeetingOf(functions);
    });

  SurfaceIntegral result;
  result.sums.resize(question.Quantities());
  MetParts met;
  const HeldFaces heldFaces(question, locator, faces, near, meetings);
  for (std::size_t k = 0; k < near.size(); ++k)
  {
    const ElementMeeting& meeting = meetings[k];
    result.notFinite += meeting.problem == ElementProblem::NotFinite ? 1 : 0;
    result.tooHigh += meeting.problem == ElementProblem::TooHigh ? 1 : 0;
    result.flat += meeting.problem == ElementProblem::Flat ? 1 : 0;
    if (meeting.inside)
    {
      met.inside.push_back(near[k]);
    }
    else
    {
      heldFaces.Add(near[k], meeting, met);
    }
  }
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
