// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PartTree.h"

#include "Core/Faces/FacePlane.h"
#include "Core/Math/Rounding.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/PieceCurvature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{
/// Largest ranges of slopes, relative to the slopes, of flat pieces: of faces, and of volumes.
constexpr double kFlat[2] = { 0.2, 0.3 };
/// Largest magnitude of f and y that may result from rounding of a zero.
constexpr double kPlateau = 1e-14;
/// Count of subdivisions after which a piece is flat even if it bends: of faces, and of volumes.
constexpr int kAtOnce[2] = { 8, 11 };

/// Factors for straight lines in xi from a box's centre: progress in xi is at least progress in eta
/// times the factor. They are the largest ratio of the shape's width to that at the centre.
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

/// Sets a derivative of function c by xi_d: its value at the centre, and its largest deviation from
/// it.
void SetSlope(const BoxPolynomial& by, std::size_t c, std::size_t d, CurvedPiece& piece)
{
  piece.slope[c][d] = by.At({ 0.0, 0.0, 0.0 }).Middle();
  piece.radius[c][d] = by.Hull().RadiusAround(piece.slope[c][d]);
}

/// Relative to a polynomial's largest coefficient; exceeds the rounding of an evaluation.
constexpr double kEvaluation = 4096.0 * kUnitRoundoff;

/// Bounds function c minus value and slopes, by the derivatives along each xi. The mean of a
/// derivative on the line from the centre differs from its value there by half of its largest
/// change.
void SetBend(
  std::span<const BoxPolynomial> by, const Vec3& widening, std::size_t c, CurvedPiece& piece)
{
  double bend = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    double varies = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      // The derivative is by a coordinate from 0 to 1, half of which is on either side of the
      // centre.
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
    // Includes the rounding of the centre.
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
  // For a magnitude there is no polynomial.
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

/// f is the sum of the components' squares, so its slopes change with the components and with their
/// slopes.
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

/// The direction along which the slopes vary most, relative to the largest slope anywhere in the
/// piece, because the slope at its centre may be zero. For a field's plateau, the longest
/// direction.
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
    // The width decides where nothing varies, or slopes are unknown.
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
