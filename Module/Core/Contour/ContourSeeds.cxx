// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/ContourSeeds.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Contour/SeedList.h"
#include "Core/Contour/TurnSearch.h"
#include "Core/Faces/FacePlane.h"
#include "Core/Shape/ShapeFace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Directions along which closed contours are searched for after that of a known piece. They are
/// not parallel to axes, so that faces aligned with axes are not normal to them.
constexpr Vec3 kAlong[2] = { { 0.7304251, 0.5231847, 0.4391063 },
  { -0.4137902, 0.6920318, 0.5914827 } };
/// A seed found by Newton's iteration is the isolated root if it is at most this far away in xi.
/// For an interpolated surface the distance may be larger.
constexpr double kRefined = 2e-6;
constexpr double kFoundNear = 0.1;

/// Whether f is zero to within the bound of its own rounding.
bool IsZero(const BoxPolynomial& f)
{
  return LargestMagnitude(f.b) <= f.error;
}

/// f - lambda s, where lambda is the ratio of the slopes of f and s. It equals f wherever s is
/// zero.
BoxPolynomial LessMultiple(const BoxPolynomial& f, const BoxPolynomial& s)
{
  Degrees degree;
  std::ranges::transform(
    f.degree, s.degree, degree.begin(), [](int a, int b) { return std::max(a, b); });
  const auto raised = [&degree](const BoxPolynomial& one)
  {
    BoxPolynomial result{ degree, std::vector<double>(CoefficientCount(degree)), 0.0 };
    Elevate(one.degree, degree, one.b, result.b);
    result.error = rounding::Above(one.error + ElevationError(degree, LargestMagnitude(one.b)));
    return result;
  };
  const BoxPolynomial high = raised(f);
  const BoxPolynomial low = raised(s);
  const auto [least, most] = std::ranges::minmax_element(low.b);
  const auto from = static_cast<std::size_t>(least - low.b.begin());
  const auto to = static_cast<std::size_t>(most - low.b.begin());
  const double rise = low.b[to] - low.b[from];
  return Combine(1.0, high, rise > 0.0 ? (high.b[from] - high.b[to]) / rise : 0.0, low);
}

class Search
{
public:
  Search(const CurveEquations& equations, CurveEvaluator& evaluator, Shape shape, double value,
    const SeedEffort& effort)
    : Equations(equations)
    , Evaluator(evaluator)
    , shape_(shape)
    , Value(value)
    , Accuracy{ equations.IsExact() ? kRefined : kFoundNear, effort.boxes }
    , List(shape, equations.IsExact(), effort.open)
  {
  }

  SeedSearchResult Run()
  {
    const int level = Equations.IsExact() ? Equations.Level() : std::max(Equations.Level(), 1);
    const int pieces = 1 << level;
    std::vector<CurvePart> parts;
    for (int i = 0; i < pieces * pieces * pieces; ++i)
    {
      const Vec3 at(i / (pieces * pieces), i / pieces % pieces, i % pieces);
      const double side = 2.0 / pieces;
      const Box3 box{ Vec3(-1.0) + side * at, Vec3(-1.0) + side * (at + 1.0) };
      BoxPolynomial s = Equations.CutOver(level, box);
      if (!s.Hull().Contains(0.0))
      {
        continue;
      }
      parts.push_back({ box, { Equations.FieldOver(level, box, Value), std::move(s) } });
    }
    FindHeldFaces(parts);
    if (List.result.constant)
    {
      return std::move(List.result);
    }
    std::erase_if(parts,
      [](const CurvePart& part)
      {
        const auto& [f, s] = part.polynomials;
        return !LessMultiple(f, s).Hull().Contains(0.0);
      });
    for (const CurvePart& part : parts)
    {
      if (part.polynomials.MayVanish())
      {
        Ends(part);
      }
    }
    SearchTurns(parts);
    return std::move(List.result);
  }

private:
  /// Searches along one direction after the other, until one leaves nothing undecided.
  void SearchTurns(const std::vector<CurvePart>& parts)
  {
    std::vector<Vec3> directions(std::begin(kAlong), std::end(kAlong));
    if (!List.result.seeds.empty())
    {
      directions.insert(directions.begin(), AlongEta(List.result.seeds.front().point));
    }
    const SeedSearchResult ends = List.result;
    for (const Vec3& direction : directions)
    {
      List.result = ends;
      TurnSearch search(Evaluator, shape_, direction, Accuracy, List);
      for (const CurvePart& part : parts)
      {
        search.Search(part);
      }
      if (List.result.complete || !ends.complete)
      {
        return;
      }
    }
  }

  /// The curve's direction in eta.
  [[nodiscard]] Vec3 AlongEta(const CurvePoint& point) const
  {
    constexpr double kStep = 1e-4;
    const Vec3 inside = point.xi + kStep * (Centre(shape_) - point.xi);
    const Vec3 along = ReferenceToTensor(shape_, inside + kStep * kStep * point.direction) -
      ReferenceToTensor(shape_, inside - kStep * kStep * point.direction);
    const double length = glm::length(along);
    return length > 0.0 && std::isfinite(length) ? along / length : kAlong[0];
  }

  [[nodiscard]] static bool Reaches(const CurvePart& part, const ShapeFace& face)
  {
    return face.upper ? part.box.upper[face.direction] == 1.0
                      : part.box.lower[face.direction] == -1.0;
  }

  void FindHeldFaces(const std::vector<CurvePart>& parts)
  {
    const auto faces = FacesOf(shape_);
    for (std::size_t k = 0; k < faces.size(); ++k)
    {
      bool fIsZero = true;
      bool sIsZero = true;
      bool reached = false;
      for (const CurvePart& part : parts)
      {
        if (Reaches(part, faces[k]))
        {
          reached = true;
          const auto& [f, s] = part.polynomials;
          fIsZero = fIsZero && IsZero(f.AtEnd(faces[k].direction, faces[k].upper));
          sIsZero = sIsZero && IsZero(s.AtEnd(faces[k].direction, faces[k].upper));
        }
      }
      if (reached && (fIsZero || sIsZero))
      {
        List.result.heldFaces.push_back(static_cast<int>(k));
        List.result.constant = List.result.constant || (fIsZero && sIsZero);
      }
    }
    List.result.constant = List.result.constant ||
      (!parts.empty() &&
        std::ranges::all_of(parts,
          [](const CurvePart& part)
          {
            const auto& [f, s] = part.polynomials;
            return IsZero(f) || IsZero(s) || IsZero(LessMultiple(f, s));
          }));
  }

  [[nodiscard]] bool IsHeld(std::size_t face) const
  {
    return std::ranges::find(List.result.heldFaces, static_cast<int>(face)) !=
      List.result.heldFaces.end();
  }

  /// Crossings with the element's faces.
  void Ends(const CurvePart& part)
  {
    const auto faces = FacesOf(shape_);
    for (std::size_t k = 0; k < faces.size(); ++k)
    {
      if (IsHeld(k) || !Reaches(part, faces[k]))
      {
        continue;
      }
      const auto fixed = static_cast<std::size_t>(faces[k].direction);
      const std::size_t first = fixed == 0 ? 1 : 0;
      const std::size_t second = fixed == 2 ? 1 : 2;
      std::vector<TensorPolynomial> system;
      for (const BoxPolynomial* one : { &part.polynomials.f, &part.polynomials.s })
      {
        BoxPolynomial end = one->AtEnd(faces[k].direction, faces[k].upper);
        system.push_back(
          { { end.degree[first], end.degree[second], 0 }, std::move(end.b), end.error });
      }
      const auto toEta = [&](const Parameters& t)
      {
        Vec3 eta;
        eta[faces[k].direction] = faces[k].upper ? 1.0 : -1.0;
        eta[static_cast<int>(first)] = part.Between(first, t[0]);
        eta[static_cast<int>(second)] = part.Between(second, t[1]);
        return eta;
      };
      RootSearch options;
      options.budget = std::min(kLastBoxes, Accuracy.boxes);
      options.smallest = kSmallestBox;
      const RootSearchResult found = FindRoots(PolynomialSystem(2, system), options);
      List.result.spent = List.result.spent || found.budgetSpent;
      const FacePlane& plane = FacePlanesOf(shape_)[k];
      const CurvePlane inFace{ plane.gradient, -plane.constant };
      for (const IsolatedRoot& root : found.roots)
      {
        const Vec3 xi = TensorToReference(shape_, toEta(MiddleOf(root.enclosure)));
        List.AddRoot(Evaluator.InPlane(xi, inFace, Accuracy.reach), 1U << k);
      }
      for (const ParameterBox& box : found.undecided)
      {
        const Vec3 xi = TensorToReference(shape_, toEta(MiddleOf(box)));
        List.AddUndecided(Evaluator.InPlane(xi, inFace, kNear), 1U << k, xi);
      }
    }
  }

  const CurveEquations& Equations;
  CurveEvaluator& Evaluator;
  Shape shape_;
  double Value;
  SeedAccuracy Accuracy;
  SeedList List;
};
} // namespace

SeedSearchResult FindContourSeeds(const CurveEquations& equations, CurveEvaluator& evaluator,
  Shape shape, double value, const SeedEffort& effort)
{
  return Search(equations, evaluator, shape, value, effort).Run();
}
} // namespace pixelexact
