// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/RangeIngredients.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// The exponent of modes that are all zero.
constexpr int kZeroExponent = -1100;
/// The largest rounding error of conversion, relative to the largest mode, that needs no finer
/// pieces.
constexpr double kHarmless = 1e-11;
} // namespace

ScaledModes::ScaledModes(const Space& itsSpace, const double* modes, int components)
  : space(itsSpace)
  , width(static_cast<std::size_t>(space.Modes()))
  , values(modes, modes + width * static_cast<std::size_t>(components))
{
  double largest = 0.0;
  for (const double c : values)
  {
    finite = finite && std::isfinite(c);
    largest = std::max(largest, std::fabs(c));
  }
  if (!finite)
  {
    return;
  }
  exponent = largest > 0.0 ? std::ilogb(largest) + 1 : kZeroExponent;
  for (double& c : values)
  {
    c = std::ldexp(c, -exponent);
  }
}

BoxPolynomial RangeIngredient::Over(
  int level, const PieceForm::Piece& piece, const Box3& within) const
{
  const PieceForm& form = PieceForm::Of(modes->space, level);
  BoxPolynomial polynomial{ form.Degree(), std::vector<double>(form.Size()) };
  form.Convert(part, piece, Modes(), polynomial.b);
  polynomial.error = form.ErrorBound(part, piece, Modes());
  if (part != Part::Value && !PieceForm::IsClosed(modes->space, Modes()))
  {
    polynomial.error = std::numeric_limits<double>::infinity();
  }
  RestrictTo(within, polynomial);
  return polynomial;
}

double RangeIngredient::RoundingInKernels(int level, const PieceForm::Piece& piece) const
{
  return 4.0 * PieceForm::Of(modes->space, level).ErrorBound(part, piece, Modes());
}

PieceForm::Piece PieceAt(const Box3& box, int level)
{
  PieceForm::Piece piece{};
  for (int d = 0; d < 3; ++d)
  {
    const double middle = 0.5 * (box.lower[d] + box.upper[d]);
    // The cube's upper end belongs to the last piece.
    piece[static_cast<std::size_t>(d)] =
      std::min(static_cast<int>(std::floor(std::ldexp(middle + 1.0, level - 1))), (1 << level) - 1);
  }
  return piece;
}

Box3 PartInPiece(const Box3& box, int level, const PieceForm::Piece& piece)
{
  Box3 part;
  const int pieces = 1 << level;
  for (int d = 0; d < 3; ++d)
  {
    const double middle = (2.0 * piece[static_cast<std::size_t>(d)] + 1.0) / pieces - 1.0;
    part.lower[d] = std::max((box.lower[d] - middle) * pieces, -1.0);
    part.upper[d] = std::min((box.upper[d] - middle) * pieces, 1.0);
  }
  return part;
}

Box3 BoxOfPart(const Box3& within, int level, const PieceForm::Piece& piece)
{
  Box3 box;
  const int pieces = 1 << level;
  for (int d = 0; d < 3; ++d)
  {
    const double middle = (2.0 * piece[static_cast<std::size_t>(d)] + 1.0) / pieces - 1.0;
    box.lower[d] = middle + within.lower[d] / pieces;
    box.upper[d] = middle + within.upper[d] / pieces;
  }
  return box;
}

void RestrictTo(const Box3& within, BoxPolynomial& polynomial)
{
  for (int d = 0; d < 3; ++d)
  {
    if (within.lower[d] > -1.0 || within.upper[d] < 1.0)
    {
      polynomial.Restrict(d, within.lower[d], within.upper[d]);
    }
  }
}

void AddDerivatives(
  const ScaledModes& modes, int first, int count, std::vector<RangeIngredient>& ingredients)
{
  for (int c = first; c < first + count; ++c)
  {
    for (const Part part : { Part::ByXi1, Part::ByXi2, Part::ByXi3 })
    {
      ingredients.push_back({ &modes, c, part });
    }
  }
}

int LevelFor(const std::vector<RangeIngredient>& ingredients)
{
  int level = 0;
  for (const RangeIngredient& one : ingredients)
  {
    const Space& space = one.modes->space;
    const int most = PieceForm::LevelOf(space.MaxOrder());
    if (most > level &&
      !(PieceForm::Of(space, 0).ErrorBound(one.part, { 0, 0, 0 }, one.Modes()) <= kHarmless))
    {
      level = most;
    }
  }
  return level;
}
} // namespace pixelexact
