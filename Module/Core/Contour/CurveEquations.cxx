// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/CurveEquations.h"

#include "Core/Base/Error.h"
#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Contour/ElementPolynomial.h"
#include "Core/Contour/SampledPolynomial.h"
#include "Core/Element/Ranges.h"
#include "Core/Location/Sample.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pixelexact
{
namespace
{
/// Degree of the polynomial that stands for a function that is none.
constexpr int kSampledDegree = 8;

ScaledModes ModesOf(const ContourQuestion& question, int element)
{
  const Field& field = *question.field;
  RequirePolynomials(field, "contours as lines");
  if (field.mapping != Mapping::Identity)
  {
    throw Unsupported("contours of field '" + field.name +
      "', an H(curl), H(div) or density field, are not available; project it on a nodal field.");
  }
  const Space& space = field.values.SpaceOf(element);
  const double* modes = field.values.Coefficients(element);
  if (question.IsMagnitude())
  {
    return { space, modes, field.values.components };
  }
  const auto skipped =
    static_cast<std::size_t>(question.Component()) * static_cast<std::size_t>(space.Modes());
  return { space, modes + skipped, 1 };
}

} // namespace

bool CurvePolynomials::MayVanish() const
{
  return s.Hull().Contains(0.0) && f.Hull().Contains(0.0);
}

CurvePolynomials CurvePolynomials::Subdivide(int direction)
{
  return { f.Subdivide(direction), s.Subdivide(direction) };
}

CurveEquations::CurveEquations(const ContourQuestion& question, int element)
  : Question(question)
  , Element(element)
  , shape_(question.mesh.ShapeOf(element))
  , Map(question.mesh.map.SpaceOf(element), question.mesh.map.Coefficients(element), 3)
  , Modes(ModesOf(question, element))
{
  Finite = Map.finite && Modes.finite;
  if (!Finite)
  {
    return;
  }
  std::vector<RangeIngredient> all{ { &Map, 0, Part::Value }, { &Map, 1, Part::Value },
    { &Map, 2, Part::Value } };
  for (int c = 0; c < (question.IsMagnitude() ? question.field->values.components : 1); ++c)
  {
    all.push_back({ &Modes, c, Part::Value });
  }
  level_ = LevelFor(all);
  const ImplicitPolynomial* const surface = question.cut->Polynomial();
  const int ofCut = surface != nullptr
    ? std::ranges::max(Map.space.TensorDegree()) * surface->Degree()
    : kSampledDegree;
  const int ofField =
    std::ranges::max(Modes.space.TensorDegree()) * (question.IsMagnitude() ? 2 : 1);
  TooHigh = ofCut + ofField > kMaxDegree;
  const Box3 whole{ Vec3(-1.0), Vec3(1.0) };
  MeetsCut = !IsExact() || CutOver(0, whole).Hull().Contains(0.0);
  for (const ImplicitPolynomial& clip : question.clips)
  {
    const BoxPolynomial over = PolynomialOver(question.mesh, element, Map, clip, 0, whole).s;
    MeetsCut = MeetsCut && !(over.Hull().lower > 0.0);
  }
  if (MeetsCut)
  {
    Reached = FieldOver(0, whole, 0.0).Hull();
  }
}

Interval CurveEquations::InModesUnits(double value) const
{
  const Interval scaled = Scaled(Interval(value), -Modes.exponent);
  return Question.IsMagnitude() ? Square(scaled) : scaled;
}

bool CurveEquations::MayHave(double value) const
{
  return !Intersect(Reached, InModesUnits(value)).IsEmpty();
}

BoxPolynomial CurveEquations::FieldOver(int level, const Box3& box, double value) const
{
  BoxPolynomial f = ValuesOver(Modes, 0, level, box);
  if (Question.IsMagnitude())
  {
    f = Multiply(f, f);
    for (int c = 1; c < Question.field->values.components; ++c)
    {
      const BoxPolynomial next = ValuesOver(Modes, c, level, box);
      f = Combine(1.0, f, 1.0, Multiply(next, next));
    }
  }
  Add(-InModesUnits(value), f);
  return f;
}

BoxPolynomial CurveEquations::CutOver(int level, const Box3& box) const
{
  const ImplicitPolynomial* const surface = Question.cut->Polynomial();
  return surface != nullptr ? PolynomialOver(Question.mesh, Element, Map, *surface, level, box).s
                            : SampledOver(box);
}

BoxPolynomial CurveEquations::SampledOver(const Box3& box) const
{
  return SamplePolynomial(kSampledDegree, box,
    [this](std::span<const Vec3> eta, std::span<double> values)
    {
      std::vector<Vec3> xi;
      for (const Vec3& point : eta)
      {
        xi.push_back(TensorToReference(shape_, point));
      }
      std::vector<Vec3> x(eta.size());
      MapForward(Question.mesh, Element, xi, x);
      Question.cut->Values(x, values);
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        if (!std::isfinite(values[i]))
        {
          std::ostringstream text;
          text << "the cut function is " << values[i] << " at (" << x[i].x << ", " << x[i].y << ", "
               << x[i].z << "); give one that is finite on all of the mesh.";
          throw InvalidData(text.str());
        }
      }
    });
}
} // namespace pixelexact
