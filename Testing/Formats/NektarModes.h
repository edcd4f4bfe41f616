// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "KnownPoints.h"

#include "Formats/FileText.h"
#include "Formats/Nektar/Fields/FieldFile.h"

#include <cmath>
#include <numbers>

// Nektar++'s modified basis (Karniadakis and Sherwin, section 3.2) and its Fourier functions, with
// derivatives. They share nothing with the reader's evaluation.
namespace pixelexact::testing
{
/// Jacobi's P_n^(alpha, 1), alpha >= 1 (Abramowitz and Stegun, 22.7.1).
inline Slope JacobiOfOne(int n, int alpha, const Slope& z)
{
  Slope before(0.0L);
  Slope value(1.0L);
  for (int k = 0; k < n; ++k)
  {
    const long double s = 2 * k + alpha + 1;
    const Slope next = ((s + 1) * (s * (s + 2) * z + (alpha * alpha - 1.0L)) * value -
                         2.0L * (k + alpha) * (k + 1) * (s + 2) * before) /
      (2.0L * (k + 1) * (k + alpha + 2) * s);
    before = value;
    value = next;
  }
  return value;
}

/// The functions of a direction that collapses nothing.
inline Slope FamilyA(int n, const Slope& z)
{
  const Slope low = (1.0L - z) / 2.0L;
  const Slope high = (1.0L + z) / 2.0L;
  return n == 0 ? low : high * (n == 1 ? Slope(1.0L) : low * JacobiOfOne(n - 2, 1, z));
}

/// Functions of a direction that collapses others, in which the mode has indices of sum k.
inline Slope FamilyB(int k, int n, const Slope& z)
{
  if (k == 0)
  {
    return FamilyA(n, z);
  }
  Slope value = n == 0 ? Slope(1.0L) : (1.0L + z) / 2.0L * JacobiOfOne(n - 1, 2 * k - 1, z);
  for (int i = 0; i < k; ++i)
  {
    value = value * (1.0L - z) / 2.0L;
  }
  return value;
}

/// One mode at eta. Functions of a collapsed edge or vertex are the sums over those that coincide
/// there.
inline Slope NektarMode(Shape shape, int p, int q, int r, const SlopeTriple& eta)
{
  const auto& [a, b, c] = eta;
  const Slope one(1.0L);
  const bool isTop = p + q == 0 && r == 1;
  switch (shape)
  {
    case Shape::Hexahedron:
      return FamilyA(p, a) * FamilyA(q, b) * FamilyA(r, c);
    case Shape::Prism:
      return (p == 0 && r == 1 ? one : FamilyA(p, a)) * FamilyA(q, b) * FamilyB(p, r, c);
    case Shape::Tetrahedron:
      return (isTop || (p == 0 && q == 1) ? one : FamilyA(p, a)) *
        (isTop ? one : FamilyB(p, q, b)) * FamilyB(p + q, r, c);
    default:
      // Inside, Nektar++ has one power of (1 - z) / 2 less than the book.
      return (isTop ? one : FamilyA(p, a) * FamilyA(q, b)) *
        (p < 2 || q < 2 ? FamilyB(std::max(p, q), r, c)
                        : FamilyB(p + q - 1, r, c) * 2.0L / (1.0L - c));
  }
}

/// eta with its derivatives by xi, in the shape's inside.
inline SlopeTriple CollapsedPlace(Shape shape, const SlopeTriple& xi)
{
  const auto& [x1, x2, x3] = xi;
  const auto quotient = [](const Slope& x, const Slope& t) { return 2.0L * (1.0L + x) / t - 1.0L; };
  const Slope t3 = 1.0L - x3;
  switch (shape)
  {
    case Shape::Hexahedron:
      return xi;
    case Shape::Prism:
      return { quotient(x1, t3), x2, x3 };
    case Shape::Tetrahedron:
      return { quotient(x1, -1.0L * (x2 + x3)), quotient(x2, t3), x3 };
    default:
      return { quotient(x1, t3), quotient(x2, t3), x3 };
  }
}

/// All modes at xi of the shape's inside, in the order of Nektar++'s files.
inline std::vector<Slope> NektarModes(const nektar::Expansion3& expansion, const SlopeTriple& xi)
{
  const Shape shape = expansion.shape;
  const auto [P, Q, R] = expansion.count;
  SlopeTriple eta = CollapsedPlace(shape, xi);
  for (int d = 0; d < 3; ++d)
  {
    // Across a plane mesh there is function 0 of a line alone, at an end where it is 1.
    eta[d] = expansion.families[d].empty() ? Slope(-1.0L) : eta[d];
  }
  std::vector<Slope> modes;
  if (shape == Shape::Hexahedron)
  {
    for (int i = 0; i < P * Q * R; ++i)
    {
      modes.push_back(NektarMode(shape, i % P, i / P % Q, i / (P * Q), eta));
    }
    return modes;
  }
  const bool isTetrahedron = shape == Shape::Tetrahedron;
  for (int p = 0; p < P; ++p)
  {
    for (int q = 0; q < (isTetrahedron ? Q - p : Q); ++q)
    {
      const int taken = isTetrahedron ? p + q : shape == Shape::Prism ? p : std::max(p, q);
      for (int r = 0; r < R - taken; ++r)
      {
        modes.push_back(NektarMode(shape, p, q, r, eta));
      }
    }
  }
  return modes;
}

/// The factor of a block's homogeneous function at a place: cos(k s) for function 2 k, -sin(k s)
/// for function 2 k + 1, with s = 2 pi z / length. It is 1 in blocks that are not homogeneous.
inline Slope HomogeneousFactor(
  const nektar::FieldBlock& block, std::size_t index, const std::string& field, const Slope& z)
{
  if (!block.homogeneous)
  {
    return 1.0L;
  }
  const nektar::Homogeneous& along = *block.homogeneous;
  int function = along.z.functions.at(index);
  long double sign = 1.0L;
  if (along.half == nektar::HalfMode::Real)
  {
    // Minus function 2, and function 3 for the velocity along z.
    function = field == "w" ? 3 : 2;
    sign = field == "w" ? 1.0L : -1.0L;
  }
  const int k = function / 2;
  const long double wave = 2 * std::numbers::pi_v<long double> * k / along.z.length;
  const long double cosine = sign * std::cos(wave * z.value);
  const long double sine = sign * std::sin(wave * z.value);
  const bool isEven = function % 2 == 0;
  const Slope distance = z - z.value;
  return isEven ? cosine - wave * sine * distance : -1.0L * sine - wave * cosine * distance;
}

/// A point inside, with the fields of a block from its coefficients.
inline KnownPoint PointFromBlock(const SolverModel& model, nektar::FieldBlock& block,
  const nektar::ElementData& data, int element, const Vec3& xi)
{
  const KnownMap map(ViewOf(model.mesh), element, xi);
  KnownPoint point = MakePoint(map, element, xi);
  const std::vector<Slope> modes = NektarModes(block.expansions[data.expansion], VariablesAt(xi));
  const std::size_t functions = block.homogeneous ? block.homogeneous->Functions() : 1;
  std::vector<double> coefficients(data.count);
  for (std::size_t f = 0; f < block.fields.size(); ++f)
  {
    Slope value;
    for (std::size_t k = 0; k < functions; ++k)
    {
      block.values.Take(f * block.perField + data.offset + k * data.count, coefficients);
      Slope sum;
      for (std::size_t i = 0; i < modes.size(); ++i)
      {
        sum = sum + coefficients.at(i) * modes[i];
      }
      value = value + map.InWorld(sum) * HomogeneousFactor(block, k, block.fields[f], point.x[2]);
    }
    point.values.push_back(value);
  }
  return point;
}

/// Points inside all elements, with the fields from the coefficients in Nektar++'s file.
inline std::vector<KnownPoint> PointsFromNektarFile(
  const SolverModel& model, const std::string& path)
{
  nektar::FieldFile file = nektar::ReadFieldFile(FileTexts({ path }).Named.front());
  std::int64_t numbers = 0; // layers over a plane mesh add multiples of this to the file's numbers
  for (const nektar::FieldBlock& block : file.blocks)
  {
    for (const nektar::ElementData& data : block.elements)
    {
      numbers = std::max(numbers, data.id + 1);
    }
  }
  std::vector<KnownPoint> points;
  for (nektar::FieldBlock& block : file.blocks)
  {
    for (const nektar::ElementData& data : block.elements)
    {
      for (int e = 0; e < static_cast<int>(model.mesh.number.size()); ++e)
      {
        if (model.mesh.number[e] % numbers == data.id)
        {
          const Shape shape = ViewOf(model.mesh).ShapeOf(e);
          for (const Vec3& xi : PointsOfElement(shape, e, PointsForEach(model), false))
          {
            points.push_back(PointFromBlock(model, block, data, e, xi));
          }
        }
      }
    }
  }
  return points;
}
} // namespace pixelexact::testing
