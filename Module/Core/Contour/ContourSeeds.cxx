// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/ContourSeeds.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Bernstein/RootFinder.h"
#include "Core/Faces/FacePlane.h"
#include "Core/Questions/Questions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Directions along which closed contours are searched for after that of a known piece: no axes,
/// so that what is aligned in a mesh is not normal to them.
constexpr Vec3 kAlong[2] = { { 0.7304251, 0.5231847, 0.4391063 },
  { -0.4137902, 0.6920318, 0.5914827 } };
/// Boxes in which the root finder is to settle a part that could still be halved.
constexpr int kTry = 48;
constexpr int kLast = 1000;
/// Of a box, as part of one of the element's. In a smaller one the errors of noisy coefficients,
/// some 1e-12, would leave no root provable.
constexpr double kSmallest = 0x1p-32;
/// Halvings of a piece before the root finder is asked, and at most.
constexpr int kFirstAsked = 3;
constexpr int kDeepest = 15;
/// Seeds nearer to each other than this in xi are one.
constexpr double kSame = 1e-11;
/// A seed found by Newton's iteration is the root that was isolated if it is as near in xi; where
/// the root is that of an interpolated surface, it may be off by more.
constexpr double kRefined = 2e-6;
constexpr double kFoundNear = 0.1;
/// A polynomial as small as this on a face, relative to its size in the element, is zero there.
constexpr double kHeld = 1e-13;

double Size(const BoxPolynomial& f)
{
  return f.Hull().Magnitude();
}

class Search
{
public:
  Search(const CurveEquations& equations, CurveEvaluator& evaluator, Shape shape, double value,
    const SeedEffort& effort)
    : Equations(equations)
    , Evaluator(evaluator)
    , TheShape(shape)
    , Value(value)
    , Reach(equations.IsExact() ? kRefined : kFoundNear)
    , Boxes(effort.boxes)
  {
  }

  SeedSearchResult Run()
  {
    const int level = Equations.IsExact() ? Equations.Level() : std::max(Equations.Level(), 1);
    const int pieces = 1 << level;
    std::vector<Part> parts;
    for (int i = 0; i < pieces * pieces * pieces; ++i)
    {
      const Vec3 at(i / (pieces * pieces), i / pieces % pieces, i % pieces);
      const double side = 2.0 / pieces;
      const Box3 box{ Vec3(-1.0) + side * at, Vec3(-1.0) + side * (at + 1.0) };
      BoxPolynomial s = Equations.CutOver(level, box);
      SizeOfS = std::max(SizeOfS, Size(s));
      if (!s.Hull().Contains(0.0))
      {
        continue;
      }
      parts.push_back({ box, { Equations.FieldOver(level, box, Value), std::move(s) } });
      SizeOfF = std::max(SizeOfF, Size(parts.back().polynomials.f));
    }
    FindHeldFaces(parts);
    if (Result.constant)
    {
      return std::move(Result);
    }
    for (const Part& part : parts)
    {
      if (part.polynomials.MayVanish())
      {
        Ends(part);
      }
    }
    SearchTurns(parts);
    return std::move(Result);
  }

private:
  struct Part
  {
    Box3 box;
    CurvePolynomials polynomials;
  };

  /// Along one direction after the other, until one tells all.
  void SearchTurns(const std::vector<Part>& parts)
  {
    std::vector<Vec3> directions(std::begin(kAlong), std::end(kAlong));
    if (!Result.seeds.empty())
    {
      directions.insert(directions.begin(), AlongEta(Result.seeds.front().point));
    }
    const SeedSearchResult ends = Result;
    for (const Vec3& direction : directions)
    {
      Along = direction;
      Left = Boxes;
      Result = ends;
      for (const Part& part : parts)
      {
        Turns(part, 0);
      }
      if (Result.complete || !ends.complete)
      {
        return;
      }
    }
  }

  /// The curve's direction in eta.
  [[nodiscard]] Vec3 AlongEta(const CurvePoint& point) const
  {
    constexpr double kStep = 1e-4;
    const Vec3 inside = point.xi + kStep * (Centre(TheShape) - point.xi);
    const Vec3 along = ReferenceToTensor(TheShape, inside + kStep * kStep * point.direction) -
      ReferenceToTensor(TheShape, inside - kStep * kStep * point.direction);
    const double length = glm::length(along);
    return length > 0.0 && std::isfinite(length) ? along / length : kAlong[0];
  }

  [[nodiscard]] static bool Reaches(const Part& part, const ShapeFace& face)
  {
    return face.upper ? part.box.upper[face.direction] == 1.0
                      : part.box.lower[face.direction] == -1.0;
  }

  void FindHeldFaces(const std::vector<Part>& parts)
  {
    const auto faces = FacesOf(TheShape);
    for (std::size_t k = 0; k < faces.size(); ++k)
    {
      double f = 0.0;
      double s = 0.0;
      bool reached = false;
      for (const Part& part : parts)
      {
        if (Reaches(part, faces[k]))
        {
          reached = true;
          f = std::max(f, Size(part.polynomials.f.AtEnd(faces[k].direction, faces[k].upper)));
          s = std::max(s, Size(part.polynomials.s.AtEnd(faces[k].direction, faces[k].upper)));
        }
      }
      const bool fIsZero = f <= kHeld;
      const bool sIsZero = s <= kHeld * SizeOfS;
      if (reached && (fIsZero || sIsZero))
      {
        Result.heldFaces.push_back(static_cast<int>(k));
        Result.constant = Result.constant || (fIsZero && sIsZero);
      }
    }
    Result.constant =
      Result.constant || (!parts.empty() && (SizeOfF <= kHeld || SizeOfS <= 0x1p-900));
  }

  [[nodiscard]] bool IsHeld(std::size_t face) const
  {
    return std::ranges::find(Result.heldFaces, static_cast<int>(face)) != Result.heldFaces.end();
  }

  /// Crossings with the element's faces.
  void Ends(const Part& part)
  {
    const auto faces = FacesOf(TheShape);
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
        eta[static_cast<int>(first)] = Between(part.box, first, t[0]);
        eta[static_cast<int>(second)] = Between(part.box, second, t[1]);
        return eta;
      };
      RootSearch options;
      options.budget = kLast;
      options.smallest = kSmallest;
      const RootSearchResult found = FindRoots(PolynomialSystem(2, system), options);
      const FacePlane& plane = FacePlanesOf(TheShape)[k];
      for (const IsolatedRoot& root : found.roots)
      {
        const Vec3 xi = TensorToReference(
          TheShape, toEta({ root.enclosure[0].Middle(), root.enclosure[1].Middle(), 0.0 }));
        const auto point = Evaluator.InPlane(xi, { plane.gradient, -plane.constant }, Reach);
        Result.complete = Result.complete && point.has_value();
        if (point && Margin(TheShape, point->xi) >= -1e-9)
        {
          AddSeed(*point, true, Equations.IsExact());
        }
      }
      for (const ParameterBox& box : found.undecided)
      {
        Result.complete = false;
        const Vec3 xi = TensorToReference(TheShape, toEta(MiddleOf(box)));
        AddFound(Evaluator.InPlane(xi, { plane.gradient, -plane.constant }, 1e-2), true);
      }
    }
  }

  /// Points where closed contours turn.
  void Turns(Part part, int depth)
  {
    if (!part.polynomials.MayVanish())
    {
      return;
    }
    if (Left <= 0)
    {
      Result.complete = false;
      AddFound(Evaluator.Near(MiddleOf(part.box), 0.5), false);
      return;
    }
    --Left;
    if (HasNoTurn(part))
    {
      return;
    }
    const bool last = depth >= kDeepest;
    if ((depth >= kFirstAsked || last) && AskForTurns(part, last))
    {
      return;
    }
    const int direction = DirectionOf(part);
    const double middle = (part.box.lower[direction] + part.box.upper[direction]) / 2.0;
    Part upper{ part.box, part.polynomials.Halve(direction) };
    upper.box.lower[direction] = middle;
    part.box.upper[direction] = middle;
    Turns(std::move(part), depth + 1);
    Turns(std::move(upper), depth + 1);
  }

  /// Whether c . (grad f x grad s) has one sign: of hulls of the derivatives.
  [[nodiscard]] bool HasNoTurn(const Part& part) const
  {
    Interval f[3];
    Interval s[3];
    for (int d = 0; d < 3; ++d)
    {
      const Interval perWidth = Interval(1.0) / Interval(part.box.upper[d] - part.box.lower[d]);
      const auto slope = [&](const BoxPolynomial& one)
      { return EncloseDerivative(one.degree, d, one.b, one.error, 0.0) * perWidth; };
      f[d] = slope(part.polynomials.f);
      s[d] = slope(part.polynomials.s);
    }
    Interval turn = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      const int i = (d + 1) % 3;
      const int j = (d + 2) % 3;
      turn += Interval(Along[d]) * (f[i] * s[j] - f[j] * s[i]);
    }
    return !turn.Contains(0.0);
  }

  /// The root finder. False where it could not tell, and a smaller part may.
  bool AskForTurns(const Part& part, bool last)
  {
    BoxPolynomial f[3];
    BoxPolynomial s[3];
    for (int d = 0; d < 3; ++d)
    {
      f[d] = Derivative(part.polynomials.f, d);
      s[d] = Derivative(part.polynomials.s, d);
    }
    BoxPolynomial turn;
    for (int d = 0; d < 3; ++d)
    {
      const int i = (d + 1) % 3;
      const int j = (d + 2) % 3;
      // Derivatives are by the part's own coordinates; any direction will do if all of the element
      // is searched along the same.
      const double factor = Along[d] * (part.box.upper[d] - part.box.lower[d]);
      const BoxPolynomial one =
        Combine(factor, Multiply(f[i], s[j]), -factor, Multiply(f[j], s[i]));
      turn = d == 0 ? one : Combine(1.0, turn, 1.0, one);
    }
    std::vector<TensorPolynomial> system;
    for (const BoxPolynomial* one :
      { &part.polynomials.f, &part.polynomials.s, static_cast<const BoxPolynomial*>(&turn) })
    {
      system.push_back({ one->degree, one->b, one->error });
    }
    RootSearch options;
    options.budget = last ? kLast : kTry;
    options.smallest = kSmallest;
    const RootSearchResult found = FindRoots(PolynomialSystem(3, system), options);
    Left -= static_cast<int>(found.boxes / 8);
    if (!last && !found.undecided.empty())
    {
      return false;
    }
    const auto toXi = [&](const Parameters& t)
    {
      return TensorToReference(TheShape,
        Vec3(Between(part.box, 0, t[0]), Between(part.box, 1, t[1]), Between(part.box, 2, t[2])));
    };
    for (const IsolatedRoot& root : found.roots)
    {
      const auto point = Evaluator.Near(toXi({ root.enclosure[0].Middle(),
                                          root.enclosure[1].Middle(), root.enclosure[2].Middle() }),
        Reach);
      Result.complete = Result.complete && point.has_value();
      if (point)
      {
        AddSeed(*point, false, Equations.IsExact());
      }
    }
    for (const ParameterBox& box : found.undecided)
    {
      Result.complete = false;
      AddFound(Evaluator.Near(toXi(MiddleOf(box)), 1e-2), false);
    }
    return true;
  }

  [[nodiscard]] static int DirectionOf(const Part& part)
  {
    int best = 0;
    double most = -1.0;
    for (int d = 0; d < 3; ++d)
    {
      const auto bend = [&](const BoxPolynomial& one)
      { return one.Variation(d, 2) / std::max(Size(one), 1e-300); };
      const double width = part.box.upper[d] - part.box.lower[d];
      const double score = bend(part.polynomials.f) + bend(part.polynomials.s) + 1e-3 * width;
      if (score > most)
      {
        most = score;
        best = d;
      }
    }
    return best;
  }

  [[nodiscard]] static double Between(const Box3& box, std::size_t d, double t)
  {
    const auto k = static_cast<int>(d);
    return std::clamp(box.lower[k] + t * (box.upper[k] - box.lower[k]), -1.0, 1.0);
  }
  [[nodiscard]] static Parameters MiddleOf(const ParameterBox& box)
  {
    Parameters middle{};
    for (std::size_t d = 0; d < 3; ++d)
    {
      middle[d] = (box.lower[d] + box.upper[d]) / 2.0;
    }
    return middle;
  }
  [[nodiscard]] Vec3 MiddleOf(const Box3& box) const
  {
    return TensorToReference(TheShape, (box.lower + box.upper) / 2.0);
  }

  void AddFound(const std::optional<CurvePoint>& point, bool onBoundary)
  {
    if (point && Margin(TheShape, point->xi) >= -1e-9)
    {
      AddSeed(*point, onBoundary, false);
    }
  }

  void AddSeed(const CurvePoint& point, bool onBoundary, bool certain)
  {
    for (ContourSeed& known : Result.seeds)
    {
      if (glm::length(known.point.xi - point.xi) <= kSame)
      {
        known.onBoundary = known.onBoundary || onBoundary;
        known.certain = known.certain || certain;
        return;
      }
    }
    if (!point.IsRegular())
    {
      // A contour that crosses itself, or a plateau: nothing is followed from there.
      Result.complete = false;
      return;
    }
    Result.seeds.push_back({ point, onBoundary, certain });
  }

  const CurveEquations& Equations;
  CurveEvaluator& Evaluator;
  Shape TheShape;
  double Value;
  double Reach;
  int Boxes;
  int Left = 0;
  Vec3 Along{ 0.0 };
  double SizeOfF = 0.0;
  double SizeOfS = 0.0;
  SeedSearchResult Result;
};
} // namespace

SeedSearchResult FindContourSeeds(const CurveEquations& equations, CurveEvaluator& evaluator,
  Shape shape, double value, const SeedEffort& effort)
{
  return Search(equations, evaluator, shape, value, effort).Run();
}
} // namespace pixelexact
