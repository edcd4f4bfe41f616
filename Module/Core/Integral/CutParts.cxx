// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/CutParts.h"

#include "Core/Base/Error.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Faces/ReferenceFace.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Location/Sample.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <sstream>

namespace pixelexact
{
namespace
{
/// Whether a face lies in the surface and belongs to this element's integral.
bool IsOurs(const Mesh& mesh, const FaceOwner& owner, int element, int face)
{
  const ReferenceFace& reference = ReferenceFaceOf(mesh.ShapeOf(element), face);
  CurvePoint point;
  point.xi = reference.At({ 1.0 / 3.0, 1.0 / 3.0 });
  MapForward(mesh, element, std::span(&point.xi, 1), std::span(&point.x, 1));
  return !owner.IsAnothers(element, face, point);
}

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

  void Add(int element, const ElementMeeting& meeting, CutParts& met) const
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
} // namespace

CutParts FindCutParts(
  const IntegralQuestion& question, const Locator& locator, const FaceTable& faces)
{
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

  CutParts met;
  const HeldFaces heldFaces(question, locator, faces, near, meetings);
  for (std::size_t k = 0; k < near.size(); ++k)
  {
    const ElementMeeting& meeting = meetings[k];
    met.notFinite += meeting.problem == ElementProblem::NotFinite ? 1 : 0;
    met.tooHigh += meeting.problem == ElementProblem::TooHigh ? 1 : 0;
    met.flat += meeting.problem == ElementProblem::Flat ? 1 : 0;
    if (meeting.inside)
    {
      met.inside.push_back(near[k]);
    }
    else
    {
      heldFaces.Add(near[k], meeting, met);
    }
  }
  return met;
}

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

bool IsNumeric(const IntegralQuestion& question)
{
  return question.IsFunction() &&
    std::ranges::any_of(question.mesh.map.spaces,
      [&question](const Space& space)
      { return !question.field->function->HasModels(space.shape); });
}
} // namespace pixelexact
