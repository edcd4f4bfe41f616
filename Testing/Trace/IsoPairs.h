// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

// Elements with fields whose gradient vanishes on points, lines and sheets, and their roots along
// rays in closed form.
namespace pixelexact::testing
{
/// A polynomial in a ray's t.
class LongPolynomial
{
public:
  LongPolynomial(long double constant = 0.0L) // NOLINT(google-explicit-constructor): numbers mix
    : C{ constant }
  {
  }
  static LongPolynomial Line(long double at, long double slope)
  {
    LongPolynomial p(at);
    p.C.push_back(slope);
    return p;
  }

  [[nodiscard]] long double At(long double t) const
  {
    long double value = 0.0L;
    for (std::size_t i = C.size(); i-- > 0;)
    {
      value = value * t + C[i];
    }
    return value;
  }
  [[nodiscard]] LongPolynomial Derivative() const
  {
    LongPolynomial p;
    for (std::size_t i = 1; i < C.size(); ++i)
    {
      p.Set(i - 1, C[i] * static_cast<long double>(i));
    }
    return p;
  }
  /// The sign changes from `from` to `to`, in order, without the ends of those monotone intervals
  /// where the polynomial may touch zero.
  [[nodiscard]] std::vector<long double> Roots(long double from, long double to) const
  {
    std::vector<long double> roots;
    std::vector<long double> ends = Critical(from, to);
    ends.insert(ends.begin(), from);
    ends.push_back(to);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      long double low = ends[i];
      long double high = ends[i + 1];
      const bool rises = At(low) < 0.0L;
      if (rises == (At(high) < 0.0L))
      {
        continue;
      }
      for (int step = 0; step < 80; ++step)
      {
        const long double middle = (low + high) / 2;
        ((At(middle) < 0.0L) == rises ? low : high) = middle;
      }
      roots.push_back((low + high) / 2);
    }
    return roots;
  }
  [[nodiscard]] std::vector<long double> Critical(long double from, long double to) const
  {
    return C.size() > 2 ? Derivative().Roots(from, to) : std::vector<long double>();
  }

  friend LongPolynomial operator+(LongPolynomial a, const LongPolynomial& b)
  {
    for (std::size_t i = 0; i < b.C.size(); ++i)
    {
      a.Set(i, (i < a.C.size() ? a.C[i] : 0.0L) + b.C[i]);
    }
    return a;
  }
  friend LongPolynomial operator*(const LongPolynomial& a, const LongPolynomial& b)
  {
    LongPolynomial p;
    p.C.assign(a.C.size() + b.C.size() - 1, 0.0L);
    for (std::size_t i = 0; i < a.C.size(); ++i)
    {
      for (std::size_t j = 0; j < b.C.size(); ++j)
      {
        p.C[i + j] += a.C[i] * b.C[j];
      }
    }
    return p;
  }
  friend LongPolynomial operator-(const LongPolynomial& a, const LongPolynomial& b)
  {
    return a + LongPolynomial(-1.0L) * b;
  }

private:
  void Set(std::size_t i, long double value)
  {
    C.resize(std::max(C.size(), i + 1));
    C[i] = value;
  }
  std::vector<long double> C;
};

/// z = Z, y = Y + q(Z), x = X + p(Y, Z), whose inverse is polynomial, too.
inline constexpr int kIsoMaps = 8;
template <class T>
std::array<T, 2> ShiftOf(int map, const T& Y, const T& Z)
{
  const T none(0.0L);
  switch (map)
  {
    case 0:
      return { none, none };
    case 1:
      return { T(0.25L) * Y * Y, none };
    case 2:
      return { T(2.0L) * Y * Y, none };
    case 3:
      return { T(0.5L) * Y, T(0.25L) * Z };
    case 4:
      return { T(0.5L) * Y * Y * Y, none };
    case 5:
      return { T(0.5L) * Y * Z, none };
    case 6:
      return { T(0.5L) * Y * Y * Z, T(0.25L) * Z * Z };
    default:
      return { T(0.25L) * Y * Y + T(0.375L) * Z * Z, T(0.5L) * Z * Z };
  }
}

inline constexpr int kIsoFields = 11;
template <class T>
T IsoFieldAt(int field, const T& X, const T& Y, const T& Z)
{
  switch (field)
  {
    case 0:
      return X * X;
    case 1:
      return X * X + Y * Y;
    case 2:
      return X * Y;
    case 3:
      return X * X * X;
    case 4:
      return X * X - Y * Y;
    case 5:
      return X * X + Y * Y + Z * Z;
    case 6:
      return X * Y * Z;
    case 7:
      return X * X * Y;
    case 8:
      return T(-0.875L) * X * X - T(0.625L) * Z * Z;
    case 9:
      return X * X * X - X * Y * Y;
    default:
      return X * X * X * X;
  }
}
inline constexpr std::array<const char*, kIsoFields> kIsoFieldNames{ "X^2", "X^2+Y^2", "XY", "X^3",
  "X^2-Y^2", "X^2+Y^2+Z^2", "XYZ", "X^2Y", "-(7X^2+5Z^2)/8", "X^3-XY^2", "X^4" };

/// One hexahedron and its field.
struct IsoPair
{
  IsoPair(int itsMap, int itsField, double itsValue)
    : map(itsMap)
    , number(itsField)
    , value(itsValue)
  {
    mesh.Add(UniformSpace(Shape::Hexahedron, 3),
      [this](const LongVec3& xi)
      {
        const auto [p, q] = ShiftOf<long double>(map, xi[1], xi[2]);
        return LongVec3{ xi[0] + p, xi[1] + q, xi[2] };
      });
    values.Add(UniformSpace(Shape::Hexahedron, 4),
      [this](const LongVec3& xi, long double* u)
      { u[0] = IsoFieldAt<long double>(number, xi[0], xi[1], xi[2]); });
    index = std::make_unique<ElementIndex>(mesh.View());
    field = { "u", values.View() };
    iso = std::make_unique<IsoSurface>(*index, field, 0, value, true);
  }

  /// X, Y and Z along a ray from t0 on.
  [[nodiscard]] std::array<LongPolynomial, 3> Along(const Ray& ray, long double t0) const
  {
    const auto line = [&](int d)
    {
      const long double slope = ray.direction[d];
      return LongPolynomial::Line(ray.origin[d] + t0 * slope, slope);
    };
    const LongPolynomial Z = line(2);
    const LongPolynomial q = ShiftOf<LongPolynomial>(map, LongPolynomial(), Z)[1];
    const LongPolynomial Y = line(1) - q;
    return { line(0) - ShiftOf<LongPolynomial>(map, Y, Z)[0], Y, Z };
  }

  int map;
  int number;
  double value;
  MeshBuilder mesh;
  ExpansionBuilder values{ 1 };
  std::unique_ptr<ElementIndex> index;
  Field field;
  std::unique_ptr<IsoSurface> iso;
};

/// The hits of a ray in closed form.
struct IsoTruth
{
  std::vector<double> roots; ///< in the element
  /// A root is near to the element's end, or is multiple, or nearly so: of an extremum near to the
  /// value, or with a small slope. Rounding may decide what the ray meets.
  bool isClose = false;
};

inline IsoTruth TruthOf(
  const IsoPair& pair, const Ray& ray, double nearEnd = 1e-9, double nearValue = 1e-9)
{
  constexpr long double kSmallSlope = 1e-6L;
  // About the element's middle: of its powers no digits are lost.
  const bool crosses = std::fabs(ray.direction.z) > 0.05;
  const long double t0 = crosses ? -static_cast<long double>(ray.origin.z) / ray.direction.z
                                 : -static_cast<long double>(glm::dot(ray.origin, ray.direction));
  const long double far = crosses ? 1.0001L / std::fabs(ray.direction.z) : 8.0L;
  const auto xi = pair.Along(ray, t0);
  const LongPolynomial f =
    IsoFieldAt<LongPolynomial>(pair.number, xi[0], xi[1], xi[2]) - LongPolynomial(pair.value);
  const LongPolynomial slope = f.Derivative();
  const auto marginAt = [&](long double t)
  {
    long double margin = 2.0L;
    for (const LongPolynomial& one : xi)
    {
      margin = std::min(margin, 1.0L - std::fabs(one.At(t)));
    }
    return margin;
  };
  IsoTruth truth;
  std::vector<long double> critical = f.Critical(-far, far);
  // Powers of a coordinate have multiple roots, which changes of sign alone do not find for
  // certain.
  for (const LongPolynomial& one : xi)
  {
    std::ranges::copy(one.Roots(-far, far), std::back_inserter(critical));
    std::ranges::copy(one.Critical(-far, far), std::back_inserter(critical));
  }
  for (const long double t : critical)
  {
    truth.isClose = truth.isClose ||
      (marginAt(t) > -nearEnd && std::fabs(f.At(t)) <= nearValue &&
        std::fabs(slope.At(t)) <= kSmallSlope);
  }
  for (const long double t : f.Roots(-far, far))
  {
    const long double margin = marginAt(t);
    truth.isClose = truth.isClose || std::fabs(margin) <= nearEnd ||
      (margin > 0.0L && std::fabs(slope.At(t)) <= kSmallSlope);
    if (margin > 0.0L)
    {
      truth.roots.push_back(static_cast<double>(t0 + t));
    }
  }
  // A ray along which f is the value throughout, up to rounding.
  long double largest = 0.0L;
  for (int i = 0; i <= 64; ++i)
  {
    const long double t = -far + 2 * far * i / 64;
    largest = std::max(largest, std::fabs(f.At(t)));
  }
  truth.isClose = truth.isClose || largest <= nearValue;
  return truth;
}
} // namespace pixelexact::testing
