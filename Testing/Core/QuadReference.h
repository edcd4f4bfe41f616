// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Modes-inl.h"
#include "Core/Element/Mesh.h"

#include <array>
#include <memory>
#include <vector>

// Elements in 113 bits: what a stored map and a stored field are, to some 1e-32. The sums are
// Modes-inl.h's, in a number type that shares no rounding with what is tested.
namespace pixelexact::HWY_NAMESPACE
{
__extension__ using Float128 = __float128;

struct Quad
{
  Float128 v = 0;
  Quad() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): numbers mix.
  Quad(double number)
    : v(number)
  {
  }
  // NOLINTNEXTLINE(google-explicit-constructor)
  Quad(int number)
    : v(number)
  {
  }
  static Quad Of(Float128 number)
  {
    Quad result;
    result.v = number;
    return result;
  }
  explicit operator double() const { return static_cast<double>(v); }
};

inline Quad operator+(const Quad& a, const Quad& b)
{
  return Quad::Of(a.v + b.v);
}
inline Quad operator-(const Quad& a, const Quad& b)
{
  return Quad::Of(a.v - b.v);
}
inline Quad operator*(const Quad& a, const Quad& b)
{
  return Quad::Of(a.v * b.v);
}
inline Quad operator/(const Quad& a, const Quad& b)
{
  return Quad::Of(a.v / b.v);
}
inline bool operator<(const Quad& a, const Quad& b)
{
  return a.v < b.v;
}
inline Quad Abs(const Quad& a)
{
  return a.v < 0 ? Quad::Of(-a.v) : a;
}
inline Quad MulAdd(const Quad& a, const Quad& b, const Quad& c)
{
  return a * b + c;
}
inline Quad NegMulAdd(const Quad& a, const Quad& b, const Quad& c)
{
  return c - a * b;
}
inline Quad CollapsedQuotient(const Quad& y, const Quad& t)
{
  return y / t;
}
inline Quad SafeReciprocal(const Quad& t)
{
  return Quad(1) / t;
}
} // namespace pixelexact::HWY_NAMESPACE

namespace pixelexact::testing
{
using HWY_NAMESPACE::Quad;
using QuadVec3 = std::array<Quad, 3>;

/// As TensorToReference.
inline QuadVec3 ToXi(Shape shape, const QuadVec3& eta)
{
  const Quad one(1);
  const Quad half(0.5);
  const auto collapse = [&](const Quad& a, const Quad& b)
  { return (one + a) * (one - b) * half - one; };
  switch (shape)
  {
    case Shape::Hexahedron:
      return eta;
    case Shape::Prism:
      return { collapse(eta[0], eta[2]), eta[1], eta[2] };
    case Shape::Tetrahedron:
      return { (one + eta[0]) * (one - eta[1]) * (one - eta[2]) * half * half - one,
        collapse(eta[1], eta[2]), eta[2] };
    default:
      return { collapse(eta[0], eta[2]), collapse(eta[1], eta[2]), eta[2] };
  }
}

struct QuadValue
{
  Quad value;
  QuadVec3 gradient;
};

template <template <class, class, bool> class Modes>
void EvaluateQuad(const Space& space, const double* coefficients, int components,
  const QuadVec3& xi, QuadValue* out)
{
  using namespace HWY_NAMESPACE;
  // Large tables: not on the stack of a test.
  const auto modes =
    std::make_unique<Modes<Quad, AnyOrder, true>>(space, Point<Quad>{ { xi[0], xi[1], xi[2] } });
  for (int c = 0; c < components; ++c)
  {
    const auto e = modes->Evaluate(coefficients + static_cast<std::ptrdiff_t>(c) * space.Modes());
    out[c] = { e.value, { e.gradient[0], e.gradient[1], e.gradient[2] } };
  }
}

/// Each component's sum and its gradient by xi.
inline std::vector<QuadValue> EvaluateQuad(
  const Expansion& expansion, int element, const QuadVec3& xi)
{
  using namespace HWY_NAMESPACE;
  const Space& space = expansion.SpaceOf(element);
  const double* coefficients = expansion.Coefficients(element);
  std::vector<QuadValue> out(static_cast<std::size_t>(expansion.components));
  const auto run = [&](auto evaluate)
  { evaluate(space, coefficients, expansion.components, xi, out.data()); };
  switch (space.shape)
  {
    case Shape::Hexahedron:
      run(EvaluateQuad<HexahedronModes>);
      break;
    case Shape::Prism:
      run(EvaluateQuad<PrismModes>);
      break;
    case Shape::Tetrahedron:
      run(EvaluateQuad<TetrahedronModes>);
      break;
    default:
      space.form == Form::Tensor ? run(EvaluateQuad<TensorPyramidModes>)
                                 : run(EvaluateQuad<PyramidModes>);
  }
  return out;
}

/// The adjugate and the determinant of rows[i].gradient[j].
struct QuadInverse
{
  explicit QuadInverse(const std::vector<QuadValue>& rows)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        const auto at = [&](int k, int l) { return rows[(i + k) % 3].gradient[(j + l) % 3]; };
        Cofactor[i][j] = at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
      }
    }
    for (int j = 0; j < 3; ++j)
    {
      Determinant = Determinant + rows[0].gradient[j] * Cofactor[0][j];
    }
  }
  QuadVec3 Cofactor[3];
  Quad Determinant;
};

/// The stored map's preimage of x near `start`, by Newton's iteration.
inline QuadVec3 InvertQuad(const Mesh& mesh, int element, const Vec3& x, const Vec3& start)
{
  const double* centre = &mesh.centre[3 * static_cast<std::size_t>(element)];
  QuadVec3 xi{ start.x, start.y, start.z };
  for (int step = 0; step < 8; ++step)
  {
    const auto phi = EvaluateQuad(mesh.map, element, xi);
    const QuadInverse inverse(phi);
    QuadVec3 r;
    for (int d = 0; d < 3; ++d)
    {
      r[d] = phi[d].value - (Quad(x[d]) - Quad(centre[d])) / Quad(mesh.size[element]);
    }
    for (int d = 0; d < 3; ++d)
    {
      const Quad delta = inverse.Cofactor[0][d] * r[0] + inverse.Cofactor[1][d] * r[1] +
        inverse.Cofactor[2][d] * r[2];
      xi[d] = xi[d] - delta / inverse.Determinant;
    }
  }
  return xi;
}

/// The field's world values at xi.
inline std::vector<Quad> WorldValuesQuad(
  const Mesh& mesh, const Field& field, int element, const QuadVec3& xi)
{
  const auto F = EvaluateQuad(field.values, element, xi);
  std::vector<Quad> u(F.size());
  const auto phi = EvaluateQuad(mesh.map, element, xi);
  const QuadInverse inverse(phi);
  const Quad size(mesh.size[element]);
  for (std::size_t c = 0; c < F.size(); ++c)
  {
    Quad sum;
    for (std::size_t j = 0; j < 3 && F.size() == 3; ++j)
    {
      sum = sum +
        (field.mapping == Mapping::Covariant ? inverse.Cofactor[c][j] : phi[c].gradient[j]) *
          F[j].value;
    }
    switch (field.mapping)
    {
      case Mapping::Identity:
        u[c] = F[c].value;
        break;
      case Mapping::Covariant:
        u[c] = sum / inverse.Determinant / size;
        break;
      case Mapping::Contravariant:
        u[c] = sum / inverse.Determinant / size / size;
        break;
      default:
        u[c] = F[c].value / inverse.Determinant / size / size / size;
    }
  }
  return u;
}
} // namespace pixelexact::testing
