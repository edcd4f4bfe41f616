// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/ElementFunctions.h"

#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Contour/SampledPolynomial.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Math/Rounding.h"
#include "Core/Shape/Shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pixelexact
{
namespace
{
// Numbers of functions.
constexpr std::size_t kSlopes = 3;
constexpr std::size_t kValues = 12;
/// The number of functions per component of the field that defines the cut-surface: its value and
/// derivatives.
constexpr std::size_t kOfComponent = 4;

BoxPolynomial Restricted(const BoxPolynomial& over, const PieceBox& box)
{
  BoxPolynomial polynomial = over;
  RestrictTo({ box.lower, box.upper }, polynomial);
  return polynomial;
}
} // namespace

ElementFunctions::ElementFunctions(const IntegralQuestion& question, int element)
  : question_(question)
  , element_(element)
  , Map(question.mesh.map.SpaceOf(element), question.mesh.map.Coefficients(element), 3)
  , FirstOfCut(kValues + static_cast<std::size_t>(question.Components()))
  , radius_(std::ldexp(question.mesh.size[static_cast<std::size_t>(element)], Map.exponent))
{
  const auto modesOf = [element](const Expansion& values)
  {
    return std::make_unique<const ScaledModes>(
      values.SpaceOf(element), values.Coefficients(element), values.components);
  };
  const Field* const ofCut = question.cut != nullptr ? question.cut->MadeOf() : nullptr;
  if (question.field != nullptr)
  {
    const FieldFunction* const function = question.field->function.get();
    Function = function != nullptr ? function->ModelsOnElement(question.mesh, element) : nullptr;
    Modes = function != nullptr ? nullptr : modesOf(question.field->values);
  }
  if (ofCut != nullptr)
  {
    CutModes = modesOf(ofCut->values);
  }
  Finite = Map.finite && (Modes == nullptr || Modes->finite) &&
    (Function == nullptr || Function->IsFinite()) && (CutModes == nullptr || CutModes->finite);
  if (!Finite)
  {
    return;
  }
  std::vector<RangeIngredient> all{ { &Map, 0, Part::Value }, { &Map, 1, Part::Value },
    { &Map, 2, Part::Value } };
  AddDerivatives(Map, 0, 3, all);
  for (int c = 0; Modes != nullptr && c < question.Components(); ++c)
  {
    all.push_back({ Modes.get(), c, Part::Value });
  }
  const auto degreeOf = [](const ScaledModes& modes)
  { return std::ranges::max(modes.space.TensorDegree()); };
  int degree = degreeOf(Map);
  for (const ImplicitPolynomial& clip : question.clips)
  {
    TooHigh = TooHigh || clip.Degree() * degree > kMaxDegree;
  }
  if (ofCut != nullptr)
  {
    degree = degreeOf(*CutModes);
    for (int c = 0; c < ofCut->values.components; ++c)
    {
      all.push_back({ CutModes.get(), c, Part::Value });
    }
    AddDerivatives(*CutModes, 0, ofCut->values.components, all);
  }
  TooHigh = TooHigh || (question.cut != nullptr && question.cut->Factor() * degree > kMaxDegree);
  level_ = std::max(LevelFor(all), Function != nullptr ? Function->Level() : 0);
  Made.resize(FirstOfCut +
    (ofCut != nullptr ? kOfComponent * static_cast<std::size_t>(ofCut->values.components) : 0));
}

bool ElementFunctions::IsZeroField() const
{
  return Modes != nullptr && std::ranges::all_of(Modes->values, [](double c) { return c == 0.0; });
}

std::vector<PieceBox> ElementFunctions::Pieces() const
{
  const int n = 1 << level_;
  std::vector<PieceBox> boxes;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int k = 0; k < n; ++k)
      {
        boxes.push_back({ { i, j, k }, Vec3(-1.0), Vec3(1.0) });
      }
    }
  }
  return boxes;
}

bool ElementFunctions::IsOnCube(const PieceBox& box, int direction, bool upper) const
{
  const int piece = box.piece[static_cast<std::size_t>(direction)];
  return upper ? piece == (1 << level_) - 1 && box.upper[direction] == 1.0
               : piece == 0 && box.lower[direction] == -1.0;
}

Interval ElementFunctions::Middle(const PieceBox& box, int direction) const
{
  const double n = 1 << level_;
  const double first = (2.0 * box.piece[static_cast<std::size_t>(direction)] + 1.0) / n - 1.0;
  const Interval sum = Interval(box.lower[direction]) + Interval(box.upper[direction]);
  return Interval(first) + sum * Interval(0.5 / n);
}

Interval ElementFunctions::HalfWidth(const PieceBox& box, int direction) const
{
  return (Interval(box.upper[direction]) - Interval(box.lower[direction])) *
    Interval(0.5 / (1 << level_));
}

void ElementFunctions::Enter(const PieceForm::Piece& piece)
{
  if (piece != At)
  {
    for (BoxPolynomial& one : Made)
    {
      one = {};
    }
    MadeOfFunction.clear();
    At = piece;
  }
}

const BoxPolynomial& ElementFunctions::Over(const PieceForm::Piece& piece, std::size_t function)
{
  Enter(piece);
  BoxPolynomial& made = Made[function];
  if (!made.b.empty())
  {
    return made;
  }
  const Box3 whole{ Vec3(-1.0), Vec3(1.0) };
  const auto over = [&](const ScaledModes& modes, std::size_t component, Part part) {
    return RangeIngredient{ &modes, static_cast<int>(component), part }.Over(level_, piece, whole);
  };
  if (function < kSlopes)
  {
    made = over(Map, function, Part::Value);
  }
  else if (function < kValues)
  {
    const std::size_t k = function - kSlopes;
    made = over(Map, k / 3, static_cast<Part>(k % 3));
  }
  else if (function < FirstOfCut)
  {
    made = over(*Modes, function - kValues, Part::Value);
  }
  else
  {
    const std::size_t k = function - FirstOfCut;
    const std::size_t part = k % kOfComponent;
    made = over(*CutModes, k / kOfComponent,
      part == 0 ? Part::Value : static_cast<Part>(static_cast<int>(part) - 1));
  }
  return made;
}

Interval ElementFunctions::Shift(const Vec3& origin, int component) const
{
  return Interval(question_.mesh.centre[3 * static_cast<std::size_t>(element_) +
           static_cast<std::size_t>(component)]) -
    Interval(origin[component]);
}

ScaledPolynomial ElementFunctions::Over(const ImplicitPolynomial& surface, const PieceBox& box)
{
  return PolynomialOf(
    question_.mesh, element_, radius_, surface, { Map3(box, 0), Map3(box, 1), Map3(box, 2) }, true);
}

BoxPolynomial ElementFunctions::Cut(const PieceBox& box)
{
  ScaledPolynomial cut = question_.cut->Over(*this, box);
  unit_ = cut.unit;
  return std::move(cut.s);
}

BoxPolynomial ElementFunctions::Map3(const PieceBox& box, int component)
{
  return Restricted(Over(box.piece, static_cast<std::size_t>(component)), box);
}

BoxPolynomial ElementFunctions::Slope(const PieceBox& box, int component, int xi)
{
  return Restricted(Over(box.piece, kSlopes + static_cast<std::size_t>(3 * component + xi)), box);
}

/// Interpolates a function without coefficients at some points of the box, and estimates the
/// polynomial's error from other points.
BoxPolynomial ElementFunctions::SampledValues(const PieceBox& box, int component) const
{
  constexpr int kDegree = 6;
  constexpr double kCaution =
    4.0; // the largest difference is between the points that are looked at
  const Field& field = *question_.field;
  const auto components = static_cast<std::size_t>(field.values.components);
  Box3 inEta;
  for (int d = 0; d < 3; ++d)
  {
    const double middle = Middle(box, d).Middle();
    const double half = HalfWidth(box, d).Middle();
    inEta.lower[d] = middle - half;
    inEta.upper[d] = middle + half;
  }
  const auto evaluate = [&](std::span<const Vec3> eta, std::span<double> values)
  {
    std::vector<Vec3> xi(eta.size());
    std::ranges::transform(
      eta, xi.begin(), [this](const Vec3& at) { return TensorToReference(GetShape(), at); });
    const LaneBuffer lanes(xi);
    const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
    std::vector<double> storage(components * stride);
    std::vector<double*> arrays(components);
    for (std::size_t c = 0; c < components; ++c)
    {
      arrays[c] = &storage[c * stride];
    }
    field.function->Evaluate(question_.mesh, element_, { lanes.View() }, arrays.data(), nullptr);
    std::copy_n(arrays[static_cast<std::size_t>(component)], values.size(), values.begin());
  };
  BoxPolynomial polynomial = SamplePolynomial(kDegree, inEta, evaluate);
  std::vector<std::array<double, 3>> between;
  std::vector<Vec3> eta;
  for (const double a : { -0.93, 0.08, 0.71 })
  {
    for (const double b : { -0.71, -0.08, 0.93 })
    {
      for (const double c : { -0.93, 0.21, 0.87 })
      {
        between.push_back({ a, b, c });
        eta.push_back(inEta.lower + 0.5 * (Vec3(a, b, c) + 1.0) * (inEta.upper - inEta.lower));
      }
    }
  }
  std::vector<double> values(eta.size());
  evaluate(eta, values);
  for (std::size_t k = 0; k < eta.size(); ++k)
  {
    const double off = kCaution * std::fabs(polynomial.At(between[k]).Middle() - values[k]);
    polynomial.error = off <= polynomial.error ? polynomial.error : off;
  }
  if (!std::isfinite(polynomial.error) || !polynomial.Hull().IsFinite())
  {
    polynomial = {};
    polynomial.b = { 0.0 };
    polynomial.error = kInfinity;
  }
  return polynomial;
}

BoxPolynomial ElementFunctions::ValuesOver(const PieceBox& box, int component)
{
  return Modes == nullptr
    ? SampledValues(box, component)
    : Restricted(Over(box.piece, kValues + static_cast<std::size_t>(component)), box);
}

std::vector<BoxPolynomial> ElementFunctions::OfFunction(const PieceBox& box)
{
  Enter(box.piece);
  if (MadeOfFunction.empty())
  {
    MadeOfFunction = Function->Polynomials(level_, box.piece);
  }
  std::vector<BoxPolynomial> restricted;
  std::ranges::transform(MadeOfFunction, std::back_inserter(restricted),
    [&box](const BoxPolynomial& over) { return Restricted(over, box); });
  return restricted;
}

std::vector<ChebyshevModel> ElementFunctions::Values(const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const PieceBox& places)
{
  const auto modelOf = [&](const BoxPolynomial& polynomial)
  { return place.Of(BoxModel(polynomial, axes, place.IsWideB())); };
  std::vector<ChebyshevModel> models;
  if (Function != nullptr)
  {
    std::ranges::transform(OfFunction(box), std::back_inserter(models), modelOf);
    return Function->Over(models);
  }
  models.reserve(static_cast<std::size_t>(question_.Components()));
  for (int c = 0; c < question_.Components(); ++c)
  {
    models.push_back(modelOf(ValuesOver(Modes != nullptr ? box : places, c)));
  }
  return models;
}

std::vector<Interval> ElementFunctions::ValueRanges(const PieceBox& box)
{
  if (Function != nullptr)
  {
    return Function->Ranges(OfFunction(box));
  }
  std::vector<Interval> ranges;
  ranges.reserve(static_cast<std::size_t>(question_.Components()));
  for (int c = 0; c < question_.Components(); ++c)
  {
    ranges.push_back(ValuesOver(box, c).Hull());
  }
  return ranges;
}

BoxPolynomial ElementFunctions::Clip(const PieceBox& box, std::size_t clip)
{
  return Over(question_.clips[clip], box).s;
}

BoxPolynomial ElementFunctions::CutValues(const PieceBox& box, int component)
{
  return Restricted(
    Over(box.piece, FirstOfCut + kOfComponent * static_cast<std::size_t>(component)), box);
}

BoxPolynomial ElementFunctions::CutSlope(const PieceBox& box, int component, int xi)
{
  return Restricted(Over(box.piece,
                      FirstOfCut + kOfComponent * static_cast<std::size_t>(component) + 1 +
                        static_cast<std::size_t>(xi)),
    box);
}

int ElementFunctions::CutExponent() const
{
  return CutModes != nullptr ? CutModes->exponent : 0;
}

int ElementFunctions::FieldExponent() const
{
  return Modes != nullptr ? Modes->exponent : 0;
}
} // namespace pixelexact
