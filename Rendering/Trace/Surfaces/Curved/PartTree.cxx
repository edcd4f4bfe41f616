// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PartTree.h"

#include "Core/Math/Rounding.h"
#include "Core/Questions/Questions.h"
#include "Trace/Scene.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Where rays need smaller pieces, they soon need smaller ones still: conversion costs as much as
/// some halvings.
constexpr int kBesides = 2;

constexpr Part kBy[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };
} // namespace

PartTree::PartTree(
  const CurvedEquation& equation, const CurvedPart& part, const FaceModes* faceModes)
  : Equation(equation)
  , ThePart(part)
  , Modes(faceModes)
  , TheShape(equation.mesh.ShapeOf(part.element))
  , Map(faceModes ? ScaledModes(faceModes->space, faceModes->coefficients.data(), 3)
                  : ScaledModes(equation.mesh.map.SpaceOf(part.element),
                      equation.mesh.map.Coefficients(part.element), 3))
{
  const auto e = static_cast<std::size_t>(part.element);
  Uncertainty = rounding::Above(equation.mesh.uncertainty[e] / equation.mesh.size[e]);
  std::vector<RangeIngredient> all{ { &Map, 0, Part::Value }, { &Map, 1, Part::Value },
    { &Map, 2, Part::Value } };
  if (equation.field != nullptr)
  {
    const Expansion& values = equation.field->values;
    // The others' sizes, or that they are not finite, do not matter.
    const Space& space = values.SpaceOf(part.element);
    const int first = equation.component == kMagnitude ? 0 : equation.component;
    Field.emplace(space,
      values.Coefficients(part.element) +
        static_cast<std::ptrdiff_t>(first) * static_cast<std::ptrdiff_t>(space.Modes()),
      Components());
    if (!Field->finite)
    {
      return;
    }
    ScaledValue = std::ldexp(equation.value, -Field->exponent);
    for (int c = 0; c < Components(); ++c)
    {
      all.push_back({ &*Field, c, Part::Value });
    }
  }
  Level = LevelFor(all);
  const int count = 1 << Level;
  const auto ends = FacesOf(TheShape);
  for (int i = 0; i < count * count * count; ++i)
  {
    const int number[3] = { i / (count * count), i / count % count, i % count };
    auto root = std::make_unique<CurvedPiece>();
    bool onFace = true;
    for (int d = 0; d < 3; ++d)
    {
      root->box.lower[d] = std::ldexp(number[d], 1 - Level) - 1.0;
      root->box.upper[d] = std::ldexp(number[d] + 1, 1 - Level) - 1.0;
      if (ThePart.face >= 0 && ends[static_cast<std::size_t>(ThePart.face)].direction == d)
      {
        const bool upper = ends[static_cast<std::size_t>(ThePart.face)].upper;
        onFace = number[d] == (upper ? count - 1 : 0);
        (upper ? root->box.lower : root->box.upper)[d] = upper ? 1.0 : -1.0;
      }
    }
    if (onFace)
    {
      const Polys whole = Convert(PieceAt({ root->box.lower, root->box.upper }, Level));
      Fill(*root, Restricted(whole, root->box, true), 0);
      if (!root->IsEmpty())
      {
        All.push_back(std::move(root));
      }
    }
  }
}

int PartTree::Components() const
{
  return Equation.component == kMagnitude ? Equation.field->values.components : 1;
}

PartTree::Polys PartTree::ConvertOnFace(const PieceForm::Piece& piece) const
{
  const FaceChart chart = ChartOf(TheShape, ThePart.face);
  const auto over = [&](int c, Part part) {
    return OverFace(chart, { &Map, c, part }, Level, piece);
  };
  Polys polys;
  for (int c = 0; c < 3; ++c)
  {
    polys.push_back(over(c, Part::Value));
  }
  for (int c = 0; c < 3; ++c)
  {
    for (int d = 0; d < 3; ++d)
    {
      polys.push_back(d == chart.across ? BoxPolynomial{ {}, { 0.0 } }
                                        : over(c, d == chart.free[0] ? Part::ByXi1 : Part::ByXi3));
    }
  }
  return polys;
}

PartTree::Polys PartTree::Convert(const PieceForm::Piece& piece) const
{
  if (Modes != nullptr)
  {
    return ConvertOnFace(piece);
  }
  const Box3 all{ Vec3(-1.0), Vec3(1.0) };
  const ShapeFace* face =
    ThePart.face < 0 ? nullptr : &FacesOf(TheShape)[static_cast<std::size_t>(ThePart.face)];
  Polys polys;
  const auto add = [&](const ScaledModes& modes, int c, Part part)
  {
    const BoxPolynomial whole = RangeIngredient{ &modes, c, part }.Over(Level, piece, all);
    polys.push_back(face ? whole.AtEnd(face->direction, face->upper) : whole);
  };
  const auto addAll = [&](const ScaledModes& modes, int components)
  {
    for (int c = 0; c < components; ++c)
    {
      add(modes, c, Part::Value);
    }
    for (int c = 0; c < components; ++c)
    {
      for (const Part by : kBy)
      {
        add(modes, c, by);
      }
    }
  };
  addAll(Map, 3);
  if (Field)
  {
    addAll(*Field, Components());
  }
  return polys;
}

const PartTree::Polys& PartTree::Converted(const PieceForm::Piece& piece) const
{
  const std::scoped_lock lock(Converting);
  const auto found = Whole.find(piece);
  if (found != Whole.end())
  {
    return found->second;
  }
  return Whole.emplace(piece, Convert(piece)).first->second;
}

PartTree::Polys PartTree::Restricted(const Polys& whole, const EtaBox& box, bool slopes) const
{
  const Box3 at{ box.lower, box.upper };
  Box3 within = PartInPiece(at, Level, PieceAt(at, Level));
  if (ThePart.face >= 0)
  {
    const int across = FacesOf(TheShape)[static_cast<std::size_t>(ThePart.face)].direction;
    within.lower[across] = -1.0;
    within.upper[across] = 1.0;
  }
  constexpr std::size_t kOfMap = 12;
  const double scale = std::ldexp(1.0, Map.exponent);
  Polys polys;
  const auto add = [&](std::size_t first, std::size_t count)
  {
    for (std::size_t k = first; k < first + count; ++k)
    {
      BoxPolynomial& p = polys.emplace_back(whole[k]);
      RestrictTo(within, p);
      if (k < kOfMap)
      {
        std::ranges::for_each(p.b, [scale](double& b) { b *= scale; });
        p.error = rounding::Above(std::ldexp(p.error, Map.exponent)) + 0x1p-1000;
        if (Modes != nullptr)
        {
          p.error = rounding::Above(p.error + (k < 3 ? Modes->error : Modes->SlopeError()));
        }
      }
    }
  };
  add(0, slopes ? kOfMap : 3);
  const std::size_t components = (whole.size() - kOfMap) / 4;
  add(kOfMap, slopes ? 4 * components : components);
  return polys;
}

std::vector<BoxPolynomial> PartTree::Polynomials(const CurvedPiece& piece) const
{
  Polys polys =
    Restricted(Converted(PieceAt({ piece.box.lower, piece.box.upper }, Level)), piece.box, false);
  const bool hasField = Field && Equation.component != kMagnitude;
  for (std::size_t c = 0; c < 3; ++c)
  {
    polys[c].error = rounding::Above(polys[c].error + Uncertainty);
  }
  if (hasField)
  {
    double largest = 0.0;
    for (double& b : polys[3].b)
    {
      b -= ScaledValue;
      largest = std::max(largest, std::fabs(b));
    }
    polys[3].error = rounding::Above(polys[3].error + Gamma(2) * largest) + 0x1p-1000;
  }
  polys.resize(hasField ? 4 : 3);
  return polys;
}

/// Describes a piece, and halves it while it bends, and so often besides.
void PartTree::Fill(CurvedPiece& piece, Polys polys, int besides) const
{
  Describe(piece, polys);
  const bool isPoint = piece.plateau && !Field;
  if (!piece.IsEmpty() && !isPoint && (!piece.flat || besides > 0))
  {
    SplitInto(piece, std::move(polys), piece.flat ? besides - 1 : 0);
  }
}

void PartTree::SplitInto(const CurvedPiece& piece, Polys polys, int besides) const
{
  const int direction = DirectionOf(piece, polys);
  auto halves = std::make_unique<std::array<CurvedPiece, 2>>();
  Polys upper;
  upper.reserve(polys.size());
  for (BoxPolynomial& p : polys)
  {
    upper.push_back(p.Halve(direction));
  }
  const double middle = 0.5 * (piece.box.lower[direction] + piece.box.upper[direction]);
  for (std::size_t k = 0; k < 2; ++k)
  {
    CurvedPiece& half = (*halves)[k];
    half.box = piece.box;
    (k == 0 ? half.box.upper : half.box.lower)[direction] = middle;
    half.halvings = piece.halvings + 1;
    Fill(half, std::move(k == 0 ? polys : upper), besides);
  }
  piece.children.store(halves.release(), std::memory_order_release);
}

const std::array<CurvedPiece, 2>& PartTree::Split(const CurvedPiece& piece) const
{
  if (const auto* made = piece.children.load(std::memory_order_acquire))
  {
    return *made;
  }
  const std::scoped_lock lock(Growing);
  if (piece.children.load(std::memory_order_relaxed) == nullptr)
  {
    const Polys& whole = Converted(PieceAt({ piece.box.lower, piece.box.upper }, Level));
    SplitInto(piece, Restricted(whole, piece.box, true), kBesides);
  }
  return *piece.children.load(std::memory_order_relaxed);
}

/// Along which the slopes vary most.
int PartTree::DirectionOf(const CurvedPiece& piece, const Polys& polys) const
{
  double largest[2] = { 0.0, 0.0 };
  for (std::size_t c = 0; c < 4; ++c)
  {
    for (const double s : piece.slope[c])
    {
      largest[c / 3] = std::max(largest[c / 3], std::fabs(s));
    }
  }
  int best = -1;
  double most = -1.0;
  for (int d = 0; d < 3; ++d)
  {
    const double width = piece.box.upper[d] - piece.box.lower[d];
    if (width == 0.0)
    {
      continue;
    }
    // Where nothing varies, or nothing is known of slopes, the widest.
    double sum = 1e-9 * width;
    const auto add = [&](std::size_t k, double scale)
    { sum += scale > 0.0 ? polys[k].Variation(d, 1) / scale : 0.0; };
    for (std::size_t k = 3; k < 12; ++k)
    {
      add(k, largest[0]);
    }
    for (std::size_t k = 13; k < polys.size() && Equation.component != kMagnitude; ++k)
    {
      add(k, largest[1]);
    }
    if (Equation.field != nullptr && Equation.component == kMagnitude)
    {
      sum += width;
    }
    if (sum > most || best < 0)
    {
      best = d;
      most = sum;
    }
  }
  return best;
}

} // namespace pixelexact