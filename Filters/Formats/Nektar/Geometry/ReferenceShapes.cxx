// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/ReferenceShapes.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::nektar
{
namespace
{
/// Jacobi's polynomial P_n^{(a,b)}(z) by its three-term recurrence (Abramowitz and Stegun, 22.7.1).
long double Jacobi(int n, int a, int b, long double z)
{
  long double previous = 1.0L;
  if (n == 0)
  {
    return previous;
  }
  long double current = (a - b + (a + b + 2) * z) / 2;
  for (int k = 1; k < n; ++k)
  {
    const long double s = 2 * k + a + b;
    const long double left = 2.0L * (k + 1) * (k + a + b + 1) * s;
    const long double middle = (s + 1) * (a * a - b * b + s * (s + 2) * z);
    const long double last = 2.0L * (k + a) * (k + b) * (s + 2);
    const long double next = (middle * current - last * previous) / left;
    previous = current;
    current = next;
  }
  return current;
}

long double Low(long double z)
{
  return (1 - z) / 2;
}

long double High(long double z)
{
  return (1 + z) / 2;
}

/// B_{pq}: B_{0q} = A_q, B_{p0} = ((1-z)/2)^p.
long double ModifiedB(int p, int q, long double z)
{
  if (p == 0)
  {
    return ModifiedA(q, z);
  }
  const long double decay = std::pow(Low(z), p);
  return q == 0 ? decay : decay * High(z) * Jacobi(q - 1, 2 * p - 1, 1, z);
}

/// The third function of the pyramid's modified basis.
long double ModifiedPyramidC(int p, int q, int r, long double z)
{
  if (p < 2 || q < 2)
  {
    return ModifiedB(std::max(p, q), r, z);
  }
  const long double decay = std::pow(Low(z), p + q - 2);
  return r == 0 ? decay : decay * High(z) * Jacobi(r - 1, 2 * p + 2 * q - 3, 1, z);
}

/// Collapsed coordinates of a point inside the shape.
LongVec3 Collapsed(Shape shape, const LongVec3& xi)
{
  LongVec3 eta = xi;
  const auto quotient = [](long double numerator, long double denominator)
  { return denominator != 0 ? 2 * numerator / denominator - 1 : -1.0L; };
  switch (shape)
  {
    case Shape::Prism:
      eta[0] = quotient(1 + xi[0], 1 - xi[2]);
      break;
    case Shape::Pyramid:
      eta[0] = quotient(1 + xi[0], 1 - xi[2]);
      eta[1] = quotient(1 + xi[1], 1 - xi[2]);
      break;
    case Shape::Tetrahedron:
      eta[0] = quotient(1 + xi[0], -xi[1] - xi[2]);
      eta[1] = quotient(1 + xi[1], 1 - xi[2]);
      break;
    default:
      break;
  }
  return eta;
}
} // namespace

const SolidTable& TableOf(Shape shape)
{
  static const SolidTable hexahedron{ { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
                                        { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } },
    { { 4, { 0, 1, 2, 3 }, 4 }, { 4, { 0, 1, 5, 4 }, 2 }, { 4, { 1, 2, 6, 5 }, 1 },
      { 4, { 3, 2, 6, 7 }, 3 }, { 4, { 0, 3, 7, 4 }, 0 }, { 4, { 4, 5, 6, 7 }, 5 } },
    { { 0, 1, 4 }, { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 1, 4, 5 }, { 1, 2, 5 }, { 2, 3, 5 },
      { 3, 4, 5 } },
    { 0, 1, 2, 3, 4, 5, 6, 7 } };
  static const SolidTable prism{ { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
                                   { -1, -1, 1 }, { -1, 1, 1 } },
    { { 4, { 0, 1, 2, 3 }, 2 }, { 3, { 0, 1, 4, -1 }, 1 }, { 4, { 1, 2, 5, 4 }, 3 },
      { 3, { 3, 2, 5, -1 }, 0 }, { 4, { 0, 3, 5, 4 }, 4 } },
    { { 0, 1, 4 }, { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 1, 2, 4 }, { 2, 3, 4 } },
    { 3, 2, 5, 0, 1, 4 } };
  static const SolidTable tetrahedron{ { { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 },
                                         { -1, -1, 1 } },
    { { 3, { 0, 1, 2, -1 }, 3 }, { 3, { 0, 1, 3, -1 }, 0 }, { 3, { 1, 2, 3, -1 }, 1 },
      { 3, { 0, 2, 3, -1 }, 2 } },
    { { 0, 1, 3 }, { 0, 1, 2 }, { 0, 2, 3 }, { 1, 2, 3 } }, { 0, 1, 2, 3 } };
  static const SolidTable pyramid{ { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
                                     { -1, -1, 1 } },
    { { 4, { 0, 1, 2, 3 }, 0 }, { 3, { 0, 1, 4, -1 }, 1 }, { 3, { 1, 2, 4, -1 }, 2 },
      { 3, { 3, 2, 4, -1 }, 3 }, { 3, { 0, 3, 4, -1 }, 4 } },
    { { 0, 1, 4 }, { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 1, 3, 3 } }, { 0, 1, 2, 3, 4 } };
  switch (shape)
  {
    case Shape::Hexahedron:
      return hexahedron;
    case Shape::Prism:
      return prism;
    case Shape::Tetrahedron:
      return tetrahedron;
    default:
      return pyramid;
  }
}

std::vector<Mode> ModesOf(Shape shape, const std::array<int, 3>& count)
{
  std::vector<Mode> modes;
  switch (shape)
  {
    case Shape::Hexahedron: // p fastest
      for (int r = 0; r < count[2]; ++r)
      {
        for (int q = 0; q < count[1]; ++q)
        {
          for (int p = 0; p < count[0]; ++p)
          {
            modes.push_back({ p, q, r });
          }
        }
      }
      break;
    default: // r fastest
      for (int p = 0; p < count[0]; ++p)
      {
        for (int q = 0; q < count[1] - (shape == Shape::Tetrahedron ? p : 0); ++q)
        {
          const int taken = shape == Shape::Prism ? p
            : shape == Shape::Tetrahedron         ? p + q
                                                  : std::max(p, q);
          for (int r = 0; r < count[2] - taken; ++r)
          {
            modes.push_back({ p, q, r });
          }
        }
      }
  }
  return modes;
}

bool IsInterior(Shape shape, const Mode& mode)
{
  const auto [p, q, r] = mode;
  switch (shape)
  {
    case Shape::Hexahedron:
      return p >= 2 && q >= 2 && r >= 2;
    case Shape::Tetrahedron:
      return p >= 2 && q >= 1 && r >= 1;
    default:
      return p >= 2 && q >= 2 && r >= 1;
  }
}

long double ModifiedA(int n, long double z)
{
  return n == 0 ? Low(z) : n == 1 ? High(z) : Low(z) * High(z) * Jacobi(n - 2, 1, 1, z);
}

long double ModifiedMode(Shape shape, const Mode& mode, const LongVec3& xi)
{
  const auto [p, q, r] = mode;
  const LongVec3 eta = Collapsed(shape, xi);
  switch (shape)
  {
    case Shape::Hexahedron:
      return ModifiedA(p, eta[0]) * ModifiedA(q, eta[1]) * ModifiedA(r, eta[2]);
    case Shape::Prism:
      // The collapsed edge has one function: the sum of the functions of its two ends in eta1.
      return (p == 0 && r == 1 ? 1.0L : ModifiedA(p, eta[0])) * ModifiedA(q, eta[1]) *
        ModifiedB(p, r, eta[2]);
    case Shape::Tetrahedron:
    {
      const bool apex = p == 0 && q == 0 && r == 1;
      const long double a = apex || (p == 0 && q == 1) ? 1.0L : ModifiedA(p, eta[0]);
      const long double b = apex ? 1.0L : ModifiedB(p, q, eta[1]);
      return a * b * ModifiedB(p + q, r, eta[2]);
    }
    default:
    {
      const bool apex = p == 0 && q == 0 && r == 1;
      const long double ab = apex ? 1.0L : ModifiedA(p, eta[0]) * ModifiedA(q, eta[1]);
      return ab * ModifiedPyramidC(p, q, r, eta[2]);
    }
  }
}

long double OrthogonalMode(Shape shape, const Mode& mode, const LongVec3& xi)
{
  const auto [p, q, r] = mode;
  const LongVec3 eta = Collapsed(shape, xi);
  const auto a = [](int n, long double z) { return std::sqrt(n + 0.5L) * Jacobi(n, 0, 0, z); };
  const auto b = [](int m, int n, long double z)
  { return std::sqrt(m + n + 1.0L) * std::pow(Low(z), m) * Jacobi(n, 2 * m + 1, 0, z); };
  const auto c = [](int m, int n, long double z)
  { return std::sqrt(m + n + 1.5L) * std::pow(Low(z), m) * Jacobi(n, 2 * m + 2, 0, z); };
  switch (shape)
  {
    case Shape::Hexahedron:
      return a(p, eta[0]) * a(q, eta[1]) * a(r, eta[2]);
    case Shape::Prism:
      return a(p, eta[0]) * a(q, eta[1]) * b(p, r, eta[2]);
    case Shape::Tetrahedron:
      return a(p, eta[0]) * b(p, q, eta[1]) * c(p + q, r, eta[2]);
    default:
      throw Unsupported("the pyramid's orthogonal basis is not read.");
  }
}
} // namespace pixelexact::nektar
