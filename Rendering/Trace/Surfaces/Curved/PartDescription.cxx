// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PartTree.h"

#include "Core/Faces/FacePlane.h"
#include "Core/Math/Rounding.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/PieceBend.h"
#include "Trace/Surfaces/Curved/PieceCurvature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{
/// Ranges of slopes, relative to the slopes, up to which a piece is flat: of faces, and of volumes.
constexpr double kFlat[2] = { 0.2, 0.3 };
/// Of f and y: values that rounding may have made of a zero.
constexpr double kPlateau = 1e-14;
/// Subdivisions at once, however it bends.
constexpr int kAtOnce[2] = { 8, 11 };

/// On a straight way in xi from a box's centre the part of the way is no less than that of eta's,
/// times this: by how much the shape is wider, at most, than at the centre.
Vec3 WideningOf(Shape shape, const EtaBox& box)
{
  const auto ratio = [&box](int d)
  {
    const double width = 1.0 - 0.5 * (box.lower[d] + box.upper[d]);
    return width > 0.0 ? (1.0 - box.lower[d]) / width : 1.0;
  };
  switch (shape)
  {
    case Shape::Hexahedron:
      return Vec3(1.0);
    case Shape::Prism:
      return { ratio(2), 1.0, 1.0 };
    case Shape::Tetrahedron:
      return { ratio(1) * ratio(2), ratio(2), 1.0 };
    default:
      return { ratio(2), ratio(2), 1.0 };
  }
}

/// A derivative of function c by xi_d: its value at the centre, and how far it is from that.
void SetSlope(const BoxPolynomial& by, std::size_t c, std::size_t d, CurvedPiece& piece)
{
  piece.slope[c][d] = by.At({ 0.0, 0.0, 0.0 }).Middle();
  piece.radius[c][d] = by.Hull().RadiusAround(piece.slope[c][d]);
}

/// Of a polynomial's largest coefficient: more than rounding leaves of an error in a value.
constexpr double kEvaluation = 4096.0 * kUnitRoundoff;

/// What is left of function c beyond value and slopes, by the derivatives along each xi: their mean
/// on the way from the centre, less what they are there, is half of what they may be at its end.
void SetBend(
  std::span<const BoxPolynomial> by, const Vec3& widening, std::size_t c, CurvedPiece& piece)
{
  double bend = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    double varies = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      // Its derivative by a coordinate that goes from 0 to 1, of which half is on either side.
      varies += 0.5 * widening[k] * by[d].Variation(k, 1);
    }
    const double largest = std::fabs(piece.slope[c][d]) + piece.radius[c][d];
    const double mean = 0.5 * varies + 4.0 * by[d].error + kEvaluation * largest;
    bend += std::min(mean, piece.radius[c][d]) * piece.half[static_cast<int>(d)];
  }
  piece.bend[c] = bend * (1.0 + 1e-9);
}
} // namespace

void PartTree::Describe(CurvedPiece& piece, const Polys& polys) const
{
  Count.fetch_add(1, std::memory_order_relaxed);
  const auto e = static_cast<std::size_t>(part_.element);
  const Box3 around = HullInXi(shape_, piece.box);
  piece.centre = TensorToReference(shape_, 0.5 * (piece.box.lower + piece.box.upper));
  piece.half = glm::max(around.upper - piece.centre, piece.centre - around.lower);
  piece.half *= 1.0 + 8.0 * kUnitRoundoff;
  piece.plateau = true;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto at = static_cast<int>(c);
    const Interval hull = polys[c].Hull();
    piece.plateau = piece.plateau && hull.Width() <= kPlateau + 4.0 * polys[c].error;
    const Interval y = hull + Interval(-Uncertainty, Uncertainty);
    const Interval x =
      Interval(Equation.mesh.centre[3 * e + c]) + y * Interval(Equation.mesh.size[e]);
    piece.bounds.lower[at] = x.lower;
    piece.bounds.upper[at] = x.upper;
    const Interval middle = polys[c].At({ 0.0, 0.0, 0.0 });
    piece.value[c] = middle.Middle();
    piece.error[c] = middle.RadiusAround(piece.value[c]) + Uncertainty;
    for (std::size_t d = 0; d < 3; ++d)
    {
      SetSlope(polys[3 + 3 * c + d], c, d, piece);
    }
  }
  if (Field)
  {
    DescribeField(piece, polys);
  }
  else
  {
    const Vec3& n = FacePlanesOf(shape_)[static_cast<std::size_t>(part_.face)].gradient;
    for (int d = 0; d < 3; ++d)
    {
      piece.slope[3][d] = n[d];
    }
  }
  for (std::size_t c = 0; c < 4; ++c)
  {
    // The centre is rounded, too.
    double largest = std::fabs(piece.value[c]);
    for (std::size_t d = 0; d < 3; ++d)
    {
      largest += std::fabs(piece.slope[c][d]) + piece.radius[c][d];
    }
    piece.error[c] += 8.0 * kUnitRoundoff * largest;
  }
  const int which = Field ? 1 : 0;
  piece.flat =
    piece.subdivisions >= kAtOnce[which] || BendOf(piece, Field.has_value()) <= kFlat[which];
  if (piece.flat && !piece.IsEmpty())
  {
    const std::span all(polys);
    const Vec3 widening = WideningOf(shape_, piece.box);
    for (std::size_t c = 0; c < 3; ++c)
    {
      SetBend(all.subspan(3 + 3 * c, 3), widening, c, piece);
    }
    if (Field && Equation.component != kMagnitude)
    {
      SetBend(all.subspan(13, 3), widening, 3, piece);
    }
    if (Field)
    {
      SetCurvature(piece, polys);
    }
  }
}

void PartTree::SetCurvature(CurvedPiece& piece, const Polys& polys) const
{
  const std::span all(polys);
  const PieceCorners corners(shape_, piece);
  piece.curves = true;
  for (std::size_t c = 0; c < 3; ++c)
  {
    piece.curves = piece.curves && corners.SetCurvature(all.subspan(3 + 3 * c, 3), c, piece);
  }
  if (Equation.component != kMagnitude)
  {
    piece.curves = piece.curves && corners.SetCurvature(all.subspan(13, 3), 3, piece);
    return;
  }
  // Of a magnitude no polynomial is kept.
  for (std::size_t d = 0; d < 3; ++d)
  {
    piece.curves = piece.curves && piece.radius[3][d] < std::numeric_limits<float>::max();
    piece.rest[3][d] = AboveFloat(piece.radius[3][d]);
  }
}

void PartTree::DescribeField(CurvedPiece& piece, const Polys& polys) const
{
  constexpr std::size_t kFirst = 12;
  const std::size_t components = (polys.size() - kFirst) / 4;
  const bool squares = Equation.component == kMagnitude;
  Interval hull = squares ? -Square(Interval(ScaledValue)) : Interval(-ScaledValue);
  Interval middle = hull;
  std::array<Interval, 3> slope;
  double error = 0.0;
  for (std::size_t c = 0; c < components; ++c)
  {
    const Interval values = polys[kFirst + c].Hull();
    error += polys[kFirst + c].error;
    const Interval value = polys[kFirst + c].At({ 0.0, 0.0, 0.0 });
    hull += squares ? Square(values) : values;
    middle += squares ? Square(value) : value;
    for (std::size_t d = 0; d < 3 && squares; ++d)
    {
      const Interval by = polys[kFirst + components + 3 * c + d].Hull();
      slope[d] += Interval(2.0) * values * by;
    }
  }
  if (!hull.Contains(0.0))
  {
    piece.bounds = { Vec3(1.0), Vec3(-1.0) };
    return;
  }
  piece.plateau = hull.Magnitude() <= kPlateau + 2.0 * error;
  piece.value[3] = middle.Middle();
  piece.error[3] = middle.RadiusAround(piece.value[3]);
  for (std::size_t d = 0; d < 3; ++d)
  {
    if (!squares)
    {
      SetSlope(polys[kFirst + 1 + d], 3, d, piece);
      continue;
    }
    piece.slope[3][d] = slope[d].Middle();
    piece.radius[3][d] = slope[d].RadiusAround(piece.slope[3][d]);
    piece.bend[3] += piece.radius[3][d] * piece.half[static_cast<int>(d)] * (1.0 + 1e-12);
  }
}

/// f is the sum of the components' squares: its slopes change with the components and with theirs.
double PartTree::MagnitudeVariation(const Polys& polys, int direction) const
{
  constexpr std::size_t kFirst = 12;
  const std::size_t components = (polys.size() - kFirst) / 4;
  double sum = 0.0;
  for (std::size_t c = 0; c < components; ++c)
  {
    const BoxPolynomial& value = polys[kFirst + c];
    const double size = value.Hull().Magnitude();
    const double change = value.Variation(direction, 1);
    for (std::size_t d = 0; d < 3; ++d)
    {
      const BoxPolynomial& by = polys[kFirst + components + 3 * c + d];
      sum += 2.0 * (change * by.Hull().Magnitude() + size * by.Variation(direction, 1));
    }
  }
  return sum;
}

/// Along which the slopes vary most, compared with the largest slope anywhere in the piece: the one
/// at its centre may be zero. Of a field's plateau, along which it is longest.
int PartTree::DirectionOf(const CurvedPiece& piece, const Polys& polys) const
{
  double largest[2] = { 0.0, 0.0 };
  for (std::size_t c = 0; c < 4; ++c)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      largest[c / 3] = std::max(largest[c / 3], std::fabs(piece.slope[c][d]) + piece.radius[c][d]);
    }
  }
  const bool isMagnitude = Field && Equation.component == kMagnitude;
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
    const auto add = [&](double variation, double scale)
    { sum += scale > 0.0 ? variation / scale : 0.0; };
    const bool isPlateau = piece.plateau && Field;
    for (std::size_t k = isPlateau ? 0 : 3; k < (isPlateau ? 3U : 12U); ++k)
    {
      add(polys[k].Variation(d, 1), largest[0]);
    }
    for (std::size_t k = 13; k < polys.size() && !isMagnitude && !isPlateau; ++k)
    {
      add(polys[k].Variation(d, 1), largest[1]);
    }
    if (isMagnitude && !isPlateau)
    {
      add(MagnitudeVariation(polys, d), largest[1]);
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
