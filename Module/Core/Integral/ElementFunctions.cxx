// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/ElementFunctions.h"

#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Contour/QuadricPolynomial.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
// Numbers of functions.
constexpr std::size_t kCut = 0;
constexpr std::size_t kMap = 1;
constexpr std::size_t kSlopes = 4;
constexpr std::size_t kValues = 13;

BoxPolynomial Restricted(const BoxPolynomial& over, const PieceBox& box)
{
  BoxPolynomial polynomial = over;
  RestrictTo({ box.lower, box.upper }, polynomial);
  return polynomial;
}
} // namespace

ElementFunctions::ElementFunctions(const IntegralQuestion& question, int element)
  : TheQuestion(question)
  , TheElement(element)
  , Map(question.mesh.map.SpaceOf(element), question.mesh.map.Coefficients(element), 3)
  , TheRadius(std::ldexp(question.mesh.size[static_cast<std::size_t>(element)], Map.exponent))
{
  if (question.field != nullptr)
  {
    const Expansion& values = question.field->values;
    Modes = std::make_unique<const ScaledModes>(
      values.SpaceOf(element), values.Coefficients(element), values.components);
  }
  Finite = Map.finite && (Modes == nullptr || Modes->finite);
  if (!Finite)
  {
    return;
  }
  std::vector<RangeIngredient> all{ { &Map, 0, Part::Value }, { &Map, 1, Part::Value },
    { &Map, 2, Part::Value } };
  AddDerivatives(Map, 0, 3, all);
  for (int c = 0; c < question.Components(); ++c)
  {
    all.push_back({ Modes.get(), c, Part::Value });
  }
  TheLevel = LevelFor(all);
  Made.resize(kValues + static_cast<std::size_t>(question.Components()));
  if (question.cut != nullptr)
  {
    const int factor = question.cut->IsPlane() ? 1 : 2;
    TooHigh = factor * std::ranges::max(Map.space.TensorDegree()) > kMaxDegree;
    for (std::size_t d = 0; d < 3; ++d)
    {
      Z0[d] = Interval(question.mesh.centre[3 * static_cast<std::size_t>(element) + d]) -
        Interval(question.cut->origin[static_cast<int>(d)]);
    }
  }
}

std::vector<PieceBox> ElementFunctions::Pieces() const
{
  const int n = 1 << TheLevel;
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
  return upper ? piece == (1 << TheLevel) - 1 && box.upper[direction] == 1.0
               : piece == 0 && box.lower[direction] == -1.0;
}

Interval ElementFunctions::Middle(const PieceBox& box, int direction) const
{
  const double n = 1 << TheLevel;
  const double first = (2.0 * box.piece[static_cast<std::size_t>(direction)] + 1.0) / n - 1.0;
  const Interval sum = Interval(box.lower[direction]) + Interval(box.upper[direction]);
  return Interval(first) + sum * Interval(0.5 / n);
}

Interval ElementFunctions::HalfWidth(const PieceBox& box, int direction) const
{
  return (Interval(box.upper[direction]) - Interval(box.lower[direction])) *
    Interval(0.5 / (1 << TheLevel));
}

const BoxPolynomial& ElementFunctions::Over(const PieceForm::Piece& piece, std::size_t function)
{
  if (piece != At)
  {
    for (BoxPolynomial& one : Made)
    {
      one = {};
    }
    At = piece;
  }
  BoxPolynomial& made = Made[function];
  if (!made.b.empty())
  {
    return made;
  }
  const Box3 whole{ Vec3(-1.0), Vec3(1.0) };
  if (function == kCut)
  {
    Box3 box;
    const double n = 1 << TheLevel;
    for (int d = 0; d < 3; ++d)
    {
      box.lower[d] = 2.0 * piece[static_cast<std::size_t>(d)] / n - 1.0;
      box.upper[d] = box.lower[d] + 2.0 / n;
    }
    ScaledQuadric quadric =
      QuadricOver(TheQuestion.mesh, TheElement, Map, *TheQuestion.cut, TheLevel, box);
    TheUnit = quadric.unit;
    made = std::move(quadric.s);
  }
  else if (function < kSlopes)
  {
    made = RangeIngredient{ &Map, static_cast<int>(function - kMap), Part::Value }.Over(
      TheLevel, piece, whole);
  }
  else if (function < kValues)
  {
    const auto k = static_cast<int>(function - kSlopes);
    made = RangeIngredient{ &Map, k / 3, static_cast<Part>(k % 3) }.Over(TheLevel, piece, whole);
  }
  else
  {
    made = RangeIngredient{ Modes.get(), static_cast<int>(function - kValues), Part::Value }.Over(
      TheLevel, piece, whole);
  }
  return made;
}

BoxPolynomial ElementFunctions::Cut(const PieceBox& box)
{
  return Restricted(Over(box.piece, kCut), box);
}

BoxPolynomial ElementFunctions::Map3(const PieceBox& box, int component)
{
  return Restricted(Over(box.piece, kMap + static_cast<std::size_t>(component)), box);
}

BoxPolynomial ElementFunctions::Slope(const PieceBox& box, int component, int xi)
{
  return Restricted(Over(box.piece, kSlopes + static_cast<std::size_t>(3 * component + xi)), box);
}

BoxPolynomial ElementFunctions::Values(const PieceBox& box, int component)
{
  return Restricted(Over(box.piece, kValues + static_cast<std::size_t>(component)), box);
}

int ElementFunctions::FieldExponent() const
{
  return Modes != nullptr ? Modes->exponent : 0;
}
} // namespace pixelexact
