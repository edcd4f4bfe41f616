// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/JumpFaces.h"

#include "Core/Faces/BehindFace.h"
#include "Core/Faces/FaceSampler.h"
#include "Core/Index/ValueIndex.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"
#include "Trace/Scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Relative to the values' magnitude: bound of rounding, including the solver's, without a jump.
constexpr double kNoJump = 1e-12;
/// Largest difference in xi of points of one face in two elements.
constexpr double kSameWay = 1e-9;

ValueIndex RangesFor(const CurvedEquation& equation)
{
  const bool squares = equation.component == kMagnitude;
  return ValueIndex(equation.mesh,
    { squares ? Quantity::Magnitude : Quantity::Component, equation.field,
      squares ? 0 : equation.component });
}

int HighestOrder(const Expansion& values)
{
  int order = 1;
  for (const Space& space : values.spaces)
  {
    order = std::max(order, space.MaxOrder());
  }
  return order;
}

struct Chosen
{
  CurvedPart part;
  AcrossFace across;
};

/// The affine map that takes n x n points of a face to those of another face; none if no affine map
/// does.
AcrossFace WayAcross(int element, std::span<const Vec3> from, std::span<const Vec3> to)
{
  const auto side =
    static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(from.size()))));
  const std::size_t second = side - 1;
  const std::size_t third = from.size() - side;
  const Vec3 a = from[second] - from[0];
  const Vec3 b = from[third] - from[0];
  AcrossFace across{ element, from[0], to[0],
    Mat3(to[second] - to[0], to[third] - to[0], Vec3(0.0)) *
      glm::inverse(Mat3(a, b, glm::cross(a, b))) };
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const Vec3 off = glm::abs(across.At(from[i]) - to[i]);
    // The comparison rejects a NaN.
    if (!(std::max({ off.x, off.y, off.z }) <= kSameWay))
    {
      across.element = -1;
    }
  }
  return across;
}

class Chooser
{
public:
  Chooser(const Locator& locator, const FaceTable& table, const CurvedEquation& equation)
    : locator_(locator)
    , Table(table)
    , Equation(equation)
    , Ranges(RangesFor(equation))
    , Grids(HighestOrder(equation.field->values))
  {
  }

  [[nodiscard]] std::vector<Chosen> Of(int element) const
  {
    std::vector<Chosen> parts;
    const Interval& mine = Ranges.RangeOf(element);
    const auto faces = static_cast<int>(FacesOf(Equation.mesh.ShapeOf(element)).size());
    for (int f = 0; f < faces && !mine.IsEmpty(); ++f)
    {
      const FaceKind kind = Table.KindOf(element, f);
      const ElementFace other = Table.NeighbourOf(element, f);
      const bool isOne = kind == FaceKind::Interior && other.element > element &&
        MayBeBetween(mine, Ranges.RangeOf(other.element));
      const bool isOfSeveral =
        (kind == FaceKind::Hanging || kind == FaceKind::Partly) && MayBeBesideAny(element, mine);
      AcrossFace across;
      if (isOfSeveral || (isOne && Jumps({ element, f }, across)))
      {
        parts.push_back({ { element, f }, across });
      }
    }
    return parts;
  }

private:
  [[nodiscard]] bool MayBeBetween(const Interval& a, const Interval& b) const
  {
    return !b.IsEmpty() && Join(a, b).Contains(Equation.value);
  }

  [[nodiscard]] bool MayBeBesideAny(int element, const Interval& mine) const
  {
    std::vector<int> near;
    locator_.Index().FindNear(locator_.Index().ElementBox(element), near);
    return std::ranges::any_of(near,
      [&](int other) { return other != element && MayBeBetween(mine, Ranges.RangeOf(other)); });
  }

  /// The values on the two sides differ, or this is unknown.
  [[nodiscard]] bool Jumps(const ElementFace& face, AcrossFace& across) const
  {
    const Mesh& mesh = Equation.mesh;
    const Expansion& values = Equation.field->values;
    const int neighbour = Table.NeighbourOf(face.element, face.face).element;
    const ReferenceFace& reference = ReferenceFaceOf(mesh.ShapeOf(face.element), face.face);
    const int order =
      std::max(values.SpaceOf(face.element).MaxOrder(), values.SpaceOf(neighbour).MaxOrder());
    std::vector<Vec3> xi;
    for (const FacePoint& point : Grids.Open(reference.corners, order))
    {
      xi.push_back(reference.At(point));
    }
    std::vector<Vec3> x(xi.size());
    MapForward(mesh, face.element, xi, x);
    std::vector<BehindFace> behind(xi.size());
    FindBehind(locator_, face, xi, x, behind);
    std::vector<Vec3> there;
    for (const BehindFace& at : behind)
    {
      if (at.verdict != Verdict::Inside || at.element != neighbour)
      {
        return true;
      }
      there.push_back(at.xi);
    }
    across = WayAcross(neighbour, xi, there);
    return Differ(ValuesAt(face.element, xi), ValuesAt(neighbour, there),
      std::max(Ranges.RangeOf(face.element).Magnitude(), Ranges.RangeOf(neighbour).Magnitude()));
  }

  [[nodiscard]] std::vector<double> ValuesAt(int element, std::span<const Vec3> xi) const
  {
    std::vector<double> values(
      xi.size() * static_cast<std::size_t>(Equation.field->values.components));
    EvaluateAt(Equation.mesh, *Equation.field, element, xi, values, {});
    return values;
  }

  [[nodiscard]] bool Differ(
    const std::vector<double>& a, const std::vector<double>& b, double size) const
  {
    const auto components = static_cast<std::size_t>(Equation.field->values.components);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      const bool counts =
        Equation.component == kMagnitude || static_cast<int>(i % components) == Equation.component;
      // The comparison counts a NaN as a difference.
      if (counts && !(std::fabs(a[i] - b[i]) <= kNoJump * size))
      {
        return true;
      }
    }
    return false;
  }

  const Locator& locator_;
  const FaceTable& Table;
  CurvedEquation Equation;
  ValueIndex Ranges;
  FaceGrids Grids;
};
} // namespace

JumpFaces::JumpFaces(const Locator& locator, const FaceTable& table, const CurvedEquation& equation)
{
  const Chooser chooser(locator, table, equation);
  std::vector<std::vector<Chosen>> ofElement(static_cast<std::size_t>(equation.mesh.Elements()));
  tbb::parallel_for(0, equation.mesh.Elements(),
    [&](int element) { ofElement[static_cast<std::size_t>(element)] = chooser.Of(element); });
  for (const std::vector<Chosen>& some : ofElement)
  {
    for (const Chosen& one : some)
    {
      parts.push_back(one.part);
      across.push_back(one.across);
    }
  }
}
} // namespace pixelexact
