// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/Collection.h"

#include "Core/Base/Error.h"
#include "Core/Basis/BasisFactor.h"

#include <array>
#include <numeric>
#include <vector>

// MFEM's unit elements, and values of its bases by way of the canonical coefficients.
namespace pixelexact::mfem
{
using Point = std::array<long double, 3>;

inline constexpr std::array kSolids{ Geometry::Tetrahedron, Geometry::Cube, Geometry::Prism,
  Geometry::Pyramid };

inline LongVec3 ToXi(Geometry solid, const Point& x)
{
  if (solid == Geometry::Prism)
  {
    return { 2 * x[0] - 1, 1 - 2 * x[2], 2 * x[1] - 1 };
  }
  return { 2 * x[0] - 1, 2 * x[1] - 1, 2 * x[2] - 1 };
}

/// Points inside of the unit element, of no symmetry.
inline std::vector<Point> Inside(Geometry solid)
{
  std::vector<Point> points;
  for (int i = 0; i < 7; ++i)
  {
    Point x{ 0.11L + 0.12L * i, 0.87L - 0.11L * i, 0.09L + 0.117L * ((3 * i) % 7) };
    if (solid == Geometry::Tetrahedron || solid == Geometry::Pyramid)
    {
      x[0] *= 1 - x[2];
      x[1] *= 1 - x[2];
    }
    if (solid == Geometry::Tetrahedron || solid == Geometry::Prism)
    {
      x[0] *= 1 - x[1] / (solid == Geometry::Prism ? 1 : 1 - x[2]);
    }
    points.push_back(x);
  }
  return points;
}

/// The value of one part for given source coefficients.
inline long double Value(
  const ChangeOfBasis& part, Geometry solid, const std::vector<double>& source, const Point& x)
{
  const int modes = part.Target().Modes();
  std::vector<double> canonical(modes);
  part.Apply(source, 0.0, canonical);
  std::vector<long double> mode(modes);
  EvaluateModes(part.Target(), ToXi(solid, x), mode.data());
  return std::inner_product(mode.begin(), mode.end(), canonical.begin(), 0.0L);
}

inline std::vector<double> Unit(int n, int at)
{
  std::vector<double> unit(n, 0.0);
  unit[at] = 1.0;
  return unit;
}

inline std::vector<Point> Vertices(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Tetrahedron:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    case Geometry::Cube:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
        { 1, 1, 1 }, { 0, 1, 1 } };
    case Geometry::Prism:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } };
    default:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  }
}

/// MFEM's edges.
inline std::vector<std::array<int, 2>> Edges(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Tetrahedron:
      return { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
    case Geometry::Cube:
      return { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 4, 5 }, { 5, 6 }, { 7, 6 }, { 4, 7 },
        { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
    case Geometry::Prism:
      return { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 },
        { 2, 5 } };
    default:
      return { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } };
  }
}

/// MFEM's faces.
inline std::vector<std::vector<int>> Faces(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Tetrahedron:
      return { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    case Geometry::Cube:
      return { { 3, 2, 1, 0 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
        { 4, 5, 6, 7 } };
    case Geometry::Prism:
      return { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } };
    default:
      return { { 3, 2, 1, 0 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  }
}

inline Geometry FaceGeometry(const std::vector<int>& face)
{
  return face.size() == 3 ? Geometry::Triangle : Geometry::Square;
}

inline bool HasBasis(const Collection& collection, Geometry solid)
{
  try
  {
    return collection.Basis(solid).sources > 0;
  }
  catch (const Unsupported&)
  {
    return false;
  }
}

/// A field of vectors in MFEM's unit element.
inline Point UnitVector(
  const Collection& collection, Geometry solid, const std::vector<double>& source, const Point& x)
{
  const auto& parts = collection.Basis(solid).parts;
  const long double scale = collection.GetContinuity() == Continuity::HCurl ? 2 : 4;
  Point f{};
  for (int d = 0; d < 3; ++d)
  {
    f[d] = scale * Value(parts[d], solid, source, x);
  }
  return solid == Geometry::Prism ? Point{ f[0], f[2], -f[1] } : f;
}
} // namespace pixelexact::mfem
