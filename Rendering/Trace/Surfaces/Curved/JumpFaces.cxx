// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/JumpFaces.h"

#include "Core/Faces/BehindFace.h"
#include "Core/Faces/FaceSampler.h"
#include "Core/Index/ValueIndex.h"
#include "Core/Location/Sample.h"
#include "Core/Questions/Questions.h"
#include "Trace/Scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Of the values' size: what rounding, and the solver's own, leave of a jump that is none.
constexpr double kNoJump = 1e-12;
constexpr double kUnknownJump = std::numeric_limits<double>::infinity();

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

/// A polynomial is no larger than so many times its largest value at n x n Gauss points: for each
/// direction the Lebesgue constant, which is below 2 sqrt(n) for n up to 40; twice as much is
/// taken.
double BeyondPoints(std::size_t points)
{
  return 8.0 * std::sqrt(static_cast<double>(points));
}

struct Chosen
{
  CurvedPart part;
  double jump;
};

class Chooser
{
public:
  Chooser(const Locator& locator, const FaceTable& table, const CurvedEquation& equation)
    : TheLocator(locator)
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
      double jump = 0.0;
      if (kind == FaceKind::Interior && other.element > element &&
        MayBeBetween(mine, Ranges.RangeOf(other.element)))
      {
        jump = JumpOf({ element, f });
      }
      else if ((kind == FaceKind::Hanging || kind == FaceKind::Partly) &&
        MayBeBesideAny(element, mine))
      {
        jump = kUnknownJump;
      }
      if (jump > 0.0)
      {
        parts.push_back({ { element, f }, jump });
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
    TheLocator.Index().FindNear(TheLocator.Index().ElementBox(element), near);
    return std::ranges::any_of(near,
      [&](int other) { return other != element && MayBeBetween(mine, Ranges.RangeOf(other)); });
  }

  /// 0 where both sides agree.
  [[nodiscard]] double JumpOf(const ElementFace& face) const
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
    FindBehind(TheLocator, face, xi, x, behind);
    std::vector<Vec3> there;
    for (const BehindFace& at : behind)
    {
      if (at.verdict != Verdict::Inside || at.element != neighbour)
      {
        return kUnknownJump;
      }
      there.push_back(at.xi);
    }
    const double jump = Difference(ValuesAt(face.element, xi), ValuesAt(neighbour, there));
    const double size =
      std::max(Ranges.RangeOf(face.element).Magnitude(), Ranges.RangeOf(neighbour).Magnitude());
    if (jump <= kNoJump * size)
    {
      return 0.0;
    }
    // What pyramids hold may be rational on their faces.
    const bool isPolynomial =
      mesh.ShapeOf(face.element) != Shape::Pyramid && mesh.ShapeOf(neighbour) != Shape::Pyramid;
    return isPolynomial ? BeyondPoints(xi.size()) * (jump + kNoJump * size) : kUnknownJump;
  }

  [[nodiscard]] std::vector<double> ValuesAt(int element, std::span<const Vec3> xi) const
  {
    std::vector<double> values(
      xi.size() * static_cast<std::size_t>(Equation.field->values.components));
    EvaluateAt(Equation.mesh, *Equation.field, element, xi, values, {});
    return values;
  }

  /// The largest, of what is compared; of a magnitude, of the vector. Infinite where a value is no
  /// number.
  [[nodiscard]] double Difference(const std::vector<double>& a, const std::vector<double>& b) const
  {
    const auto components = static_cast<std::size_t>(Equation.field->values.components);
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      if (Equation.component != kMagnitude &&
        static_cast<int>(i % components) != Equation.component)
      {
        continue;
      }
      const double apart = std::fabs(a[i] - b[i]);
      largest = std::isnan(apart) ? kUnknownJump : std::max(largest, apart);
    }
    return Equation.component == kMagnitude ? std::sqrt(static_cast<double>(components)) * largest
                                            : largest;
  }

  const Locator& TheLocator;
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
      jumps.push_back(one.jump);
    }
  }
}
} // namespace pixelexact
