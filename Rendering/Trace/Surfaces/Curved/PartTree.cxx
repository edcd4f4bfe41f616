// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PartTree.h"

#include "Core/Bernstein/Krawczyk.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/Questions.h"
#include "Trace/Scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Ranges of slopes, relative to the slopes, up to which a piece is flat: of faces, and of volumes.
constexpr double kFlat[2] = { 0.2, 0.5 };
/// Halvings at once, however it bends.
constexpr int kAtOnce[2] = { 8, 9 };
/// Where rays need smaller pieces, they soon need smaller ones still: conversion costs as much as
/// some halvings.
constexpr int kBesides = 2;

constexpr Part kBy[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };

/// The inverse's magnitudes times those of another matrix, the largest row sum; infinite where
/// there is no inverse.
double Relative(const SmallMatrix& matrix, const SmallMatrix& radius, std::size_t columns)
{
  const auto inverse = Inverse(3, matrix);
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t j = 0; j < columns; ++j)
      {
        sum += inverse ? std::fabs((*inverse)[i][k]) * radius[k][j] : kInfinity;
      }
    }
    largest = std::max(largest, sum);
  }
  return std::isnan(largest) ? kInfinity : largest;
}

Vec3 LengthsOf(const SmallMatrix& m)
{
  Vec3 length;
  for (std::size_t j = 0; j < 3; ++j)
  {
    length[static_cast<int>(j)] = std::hypot(m[0][j], m[1][j], m[2][j]);
  }
  return length;
}
} // namespace

PartTree::PartTree(const CurvedEquation& equation, const CurvedPart& part)
  : Equation(equation)
  , ThePart(part)
  , TheShape(equation.mesh.ShapeOf(part.element))
  , Map(equation.mesh.map.SpaceOf(part.element), equation.mesh.map.Coefficients(part.element), 3)
{
  const auto e = static_cast<std::size_t>(part.element);
  Uncertainty = rounding::Above(equation.mesh.uncertainty[e] / equation.mesh.size[e]);
  std::vector<RangeIngredient> all;
  for (int c = 0; c < 3; ++c)
  {
    all.push_back({ &Map, c, Part::Value });
  }
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
      Fill(*root, Convert(root->box), 0);
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

BoxPolynomial PartTree::OnFace(BoxPolynomial polynomial) const
{
  const ShapeFace& face = FacesOf(TheShape)[static_cast<std::size_t>(ThePart.face)];
  const auto d = static_cast<std::size_t>(face.direction);
  const std::size_t stride = StrideOf(polynomial.degree, face.direction);
  const std::size_t block = stride * static_cast<std::size_t>(polynomial.degree[d] + 1);
  BoxPolynomial slice{ polynomial.degree, {}, polynomial.error };
  slice.degree[d] = 0;
  for (std::size_t start = face.upper ? block - stride : 0; start < polynomial.b.size();
       start += block)
  {
    slice.b.insert(slice.b.end(), &polynomial.b[start], &polynomial.b[start] + stride);
  }
  return slice;
}

PartTree::Polys PartTree::Convert(const EtaBox& box) const
{
  PieceForm::Piece piece{};
  for (int d = 0; d < 3; ++d)
  {
    const double middle = 0.5 * (box.lower[d] + box.upper[d]);
    piece[static_cast<std::size_t>(d)] =
      std::min(static_cast<int>(std::ldexp(middle + 1.0, Level - 1)), (1 << Level) - 1);
  }
  Box3 within = PartInPiece({ box.lower, box.upper }, Level, piece);
  if (ThePart.face >= 0)
  {
    const int d = FacesOf(TheShape)[static_cast<std::size_t>(ThePart.face)].direction;
    within.lower[d] = -1.0;
    within.upper[d] = 1.0;
  }
  Polys polys;
  const auto add = [&](const ScaledModes& modes, int components)
  {
    for (int c = 0; c < components; ++c)
    {
      polys.push_back(RangeIngredient{ &modes, c, Part::Value }.Over(Level, piece, within));
    }
    for (int c = 0; c < components; ++c)
    {
      for (const Part by : kBy)
      {
        polys.push_back(RangeIngredient{ &modes, c, by }.Over(Level, piece, within));
      }
    }
  };
  add(Map, 3);
  const double scale = std::ldexp(1.0, Map.exponent);
  for (BoxPolynomial& p : polys)
  {
    for (double& b : p.b)
    {
      b *= scale;
    }
    p.error = rounding::Above(std::ldexp(p.error, Map.exponent)) + 0x1p-1000;
  }
  if (Field)
  {
    add(*Field, Components());
  }
  if (ThePart.face >= 0)
  {
    for (BoxPolynomial& p : polys)
    {
      p = OnFace(std::move(p));
    }
  }
  return polys;
}

std::vector<BoxPolynomial> PartTree::Polynomials(const CurvedPiece& piece) const
{
  Polys polys = Convert(piece.box);
  const bool hasField = Field && Equation.component != kMagnitude;
  for (std::size_t c = 0; c < 3; ++c)
  {
    polys[c].error = rounding::Above(polys[c].error + Uncertainty);
  }
  if (hasField)
  {
    std::swap(polys[3], polys[12]);
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
  if (!piece.IsEmpty() && (!piece.flat || besides > 0))
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
  // Who makes a piece's halves is alone with it.
  const_cast<CurvedPiece&>(piece).children.store(halves.release(), std::memory_order_release);
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
    SplitInto(piece, Convert(piece.box), kBesides);
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
    // Where nothing varies, the widest.
    double sum = 1e-9 * width;
    for (std::size_t k = 3; k < polys.size(); ++k)
    {
      if (k < 12)
      {
        sum += polys[k].Variation(d, 1) / largest[0];
      }
      else if (k == 12 || Equation.component == kMagnitude)
      {
        continue;
      }
      else
      {
        sum += polys[k].Variation(d, 1) / largest[1];
      }
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

void PartTree::Describe(CurvedPiece& piece, const Polys& polys) const
{
  Count.fetch_add(1, std::memory_order_relaxed);
  const auto e = static_cast<std::size_t>(ThePart.element);
  const Box3 hull = HullInXi(TheShape, piece.box);
  piece.centre = TensorToReference(TheShape, 0.5 * (piece.box.lower + piece.box.upper));
  piece.half = glm::max(hull.upper - piece.centre, piece.centre - hull.lower);
  piece.half *= 1.0 + 8.0 * kUnitRoundoff;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto at = static_cast<int>(c);
    const Interval y = polys[c].Hull() + Interval(-Uncertainty, Uncertainty);
    const Interval x =
      Interval(Equation.mesh.centre[3 * e + c]) + y * Interval(Equation.mesh.size[e]);
    piece.bounds.lower[at] = x.lower;
    piece.bounds.upper[at] = x.upper;
    const Interval middle = polys[c].At({ 0.0, 0.0, 0.0 });
    piece.value[c] = middle.Middle();
    piece.error[c] = middle.RadiusAround(piece.value[c]) + Uncertainty;
    for (std::size_t d = 0; d < 3; ++d)
    {
      const Interval slope = polys[3 + 3 * c + d].Hull();
      piece.slope[c][d] = slope.Middle();
      piece.radius[c][d] = slope.RadiusAround(piece.slope[c][d]);
    }
  }
  if (Field)
  {
    DescribeField(piece, polys);
  }
  else
  {
    const ShapeFace& face = FacesOf(TheShape)[static_cast<std::size_t>(ThePart.face)];
    const auto end = static_cast<std::size_t>(2 * face.direction + (face.upper ? 1 : 0));
    std::ranges::copy(EndNormals(TheShape, piece.box)[end], piece.slope[3]);
  }
  for (std::size_t c = 0; c < 4; ++c)
  {
    // The centre is rounded, too.
    double around = std::fabs(piece.value[c]);
    for (std::size_t d = 0; d < 3; ++d)
    {
      around += std::fabs(piece.slope[c][d]) + piece.radius[c][d];
    }
    piece.error[c] += 8.0 * kUnitRoundoff * around;
  }
  const int which = Field ? 1 : 0;
  piece.flat = piece.halvings >= kAtOnce[which] || Bend(piece) <= kFlat[which];
}

void PartTree::DescribeField(CurvedPiece& piece, const Polys& polys) const
{
  constexpr std::size_t kFirst = 12;
  const std::size_t components = (polys.size() - kFirst) / 4;
  const bool squares = Equation.component == kMagnitude;
  Interval hull = squares ? -Square(Interval(ScaledValue)) : Interval(-ScaledValue);
  Interval middle = hull;
  std::array<Interval, 3> slope;
  for (std::size_t c = 0; c < components; ++c)
  {
    const Interval values = polys[kFirst + c].Hull();
    const Interval value = polys[kFirst + c].At({ 0.0, 0.0, 0.0 });
    hull += squares ? Square(values) : values;
    middle += squares ? Square(value) : value;
    for (std::size_t d = 0; d < 3; ++d)
    {
      const Interval by = polys[kFirst + components + 3 * c + d].Hull();
      slope[d] += squares ? Interval(2.0) * values * by : by;
    }
  }
  if (!hull.Contains(0.0))
  {
    piece.bounds = { Vec3(1.0), Vec3(-1.0) };
    return;
  }
  piece.value[3] = middle.Middle();
  piece.error[3] = middle.RadiusAround(piece.value[3]);
  for (std::size_t d = 0; d < 3; ++d)
  {
    piece.slope[3][d] = slope[d].Middle();
    piece.radius[3][d] = slope[d].RadiusAround(piece.slope[3][d]);
  }
}

/// How much the slopes vary over a piece, relative to themselves: of a face's tangents and normal,
/// or of the map and of the field's gradient.
double PartTree::Bend(const CurvedPiece& piece) const
{
  SmallMatrix slope{};
  SmallMatrix radius{};
  if (Field)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      std::ranges::copy(piece.slope[c], slope[c].begin());
      std::ranges::copy(piece.radius[c], radius[c].begin());
    }
    const auto inverse = Inverse(3, slope);
    double length = 0.0;
    double change = 0.0;
    for (std::size_t j = 0; inverse && j < 3; ++j)
    {
      double sum = 0.0;
      double around = 0.0;
      for (std::size_t d = 0; d < 3; ++d)
      {
        sum += piece.slope[3][d] * (*inverse)[d][j];
        around += piece.radius[3][d] * std::fabs((*inverse)[d][j]);
      }
      length = std::hypot(length, sum);
      change = std::hypot(change, around);
    }
    return inverse && length > 0.0 ? std::max(Relative(slope, radius, 3), change / length)
                                   : kInfinity;
  }
  // Tangents along two directions in the face, and the normal, as long as they are.
  const Vec3 across(piece.slope[3][0], piece.slope[3][1], piece.slope[3][2]);
  const Vec3 size = glm::abs(across);
  const int last = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  for (int k = 0; k < 2; ++k)
  {
    const int d = (last + 1 + k) % 3;
    const double back = across[d] / across[last];
    for (std::size_t c = 0; c < 3; ++c)
    {
      slope[c][static_cast<std::size_t>(k)] = piece.slope[c][d] - back * piece.slope[c][last];
      radius[c][static_cast<std::size_t>(k)] =
        piece.radius[c][d] + std::fabs(back) * piece.radius[c][last];
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    const std::size_t p = (c + 1) % 3;
    const std::size_t q = (c + 2) % 3;
    slope[c][2] = slope[p][0] * slope[q][1] - slope[q][0] * slope[p][1];
  }
  const Vec3 length = LengthsOf(slope);
  const double scale = 0.5 * (length.x + length.y) / length.z;
  for (auto& row : slope)
  {
    row[2] *= scale;
  }
  return Relative(slope, radius, 2);
}
} // namespace pixelexact
