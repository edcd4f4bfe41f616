// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/PointLeaves.h"

#include "Core/Element/FieldMapping.h"
#include "Core/Element/HessianFunction.h"
#include "Core/Math/Mat.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// With K = J^-1, J = d Phi / d xi, and derivatives by xi as the kernels give them:
//
//   du / dx_a = sum over j of du / dxi_j K_ja
//   d2u / dx_a dx_b = sum over j, k of K_ja K_kb (d2u / dxi_j dxi_k - sum over m of du / dx_m
//                     d2Phi_m / dxi_j dxi_k)
//
// J and K are those of the element's units; their size is divided out at the end.
namespace pixelexact
{
namespace
{
// Arrays of the map: Phi, J as [3 c + d], and J^-1 as [3 j + a].
constexpr std::size_t kPhi = 0;
constexpr std::size_t kJacobian = 3;
constexpr std::size_t kInverse = 12;
constexpr std::size_t kMapArrays = 21;
/// The arrays of a component: the value, three slopes, and xx, xy, xz, yy, yz, zz.
constexpr std::size_t kSlope = 1;
constexpr std::size_t kCurvature = 4;
constexpr std::size_t kOfComponent = 10;

std::size_t CurvatureAt(int a, int b)
{
  return HessianFunction::kPlaces[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
}

/// Replaces the derivatives by xi by those by y = x / size.
void ToSlopes(int count, double* const* inverse, double* const* slope)
{
  std::array<double*, 3> s{ slope[0], slope[1], slope[2] };
  for (int i = 0; i < count; ++i)
  {
    const double g0 = s[0][i];
    const double g1 = s[1][i];
    const double g2 = s[2][i];
    for (std::size_t a = 0; a < 3; ++a)
    {
      s[a][i] = g0 * inverse[a][i] + g1 * inverse[3 + a][i] + g2 * inverse[6 + a][i];
    }
  }
}

/// Inverts by the cofactors, in lanes.
void Invert(int count, double* const* jacobian, double* const* inverse)
{
  for (int i = 0; i < count; ++i)
  {
    const double a = jacobian[0][i];
    const double b = jacobian[1][i];
    const double c = jacobian[2][i];
    const double d = jacobian[3][i];
    const double e = jacobian[4][i];
    const double f = jacobian[5][i];
    const double g = jacobian[6][i];
    const double h = jacobian[7][i];
    const double k = jacobian[8][i];
    const double ofA = e * k - f * h;
    const double ofB = f * g - d * k;
    const double ofC = d * h - e * g;
    const double over = 1.0 / (a * ofA + b * ofB + c * ofC);
    inverse[0][i] = ofA * over;
    inverse[1][i] = (c * h - b * k) * over;
    inverse[2][i] = (b * f - c * e) * over;
    inverse[3][i] = ofB * over;
    inverse[4][i] = (a * k - c * g) * over;
    inverse[5][i] = (c * d - a * f) * over;
    inverse[6][i] = ofC * over;
    inverse[7][i] = (b * g - a * h) * over;
    inverse[8][i] = (a * e - b * d) * over;
  }
}

void Scale(int count, double factor, double* out)
{
  for (int i = 0; i < count; ++i)
  {
    out[i] *= factor;
  }
}

double DeterminantAt(double* const* jacobian, int i)
{
  const auto j = [&](std::size_t k) { return jacobian[k][i]; };
  return j(0) * (j(4) * j(8) - j(5) * j(7)) + j(1) * (j(5) * j(6) - j(3) * j(8)) +
    j(2) * (j(3) * j(7) - j(4) * j(6));
}

int DerivativesOf(Operation operation)
{
  return operation == Operation::Value ? 0 : operation == Operation::Slope ? 1 : 2;
}

bool IsOfField(const Graph::Node& leaf)
{
  return leaf.operation == Operation::Value || leaf.operation == Operation::Slope ||
    leaf.operation == Operation::Curvature;
}
} // namespace

PointLeaves::PointLeaves(std::span<const Graph::Node> leaves, std::span<const Field* const> fields,
  std::span<const std::int64_t> numbers)
  : Wanted(leaves.begin(), leaves.end())
  , Numbers(numbers)
  , Arrays(kMapArrays)
{
  for (const Field* field : fields)
  {
    Fields.push_back({ .field = field });
  }
  for (const Graph::Node& leaf : Wanted)
  {
    if (IsOfField(leaf))
    {
      NeededField& needed = Fields[static_cast<std::size_t>(leaf.field)];
      needed.derivatives = std::max(needed.derivatives, DerivativesOf(leaf.operation));
      const bool isMapped = needed.field->mapping != Mapping::Identity;
      NeedsInverse = NeedsInverse || (needed.derivatives > 0 && !isMapped);
    }
    NeedsInverse = NeedsInverse || leaf.operation == Operation::InverseJacobian;
    OfNormals = OfNormals || leaf.operation == Operation::Normal;
    NeedsMap = NeedsMap || NeedsInverse || leaf.operation == Operation::Coordinate ||
      leaf.operation == Operation::Determinant || leaf.operation == Operation::ScaledJacobian;
  }
  for (NeededField& needed : Fields)
  {
    needed.first = Arrays;
    Arrays += needed.derivatives < 0
      ? 0
      : kOfComponent * static_cast<std::size_t>(needed.field->values.components);
  }
  Arrays += Wanted.size();
}

std::size_t PointLeaves::ArrayOf(const Graph::Node& leaf) const
{
  const std::size_t component = Fields[static_cast<std::size_t>(leaf.field)].first +
    kOfComponent * static_cast<std::size_t>(leaf.component);
  switch (leaf.operation)
  {
    case Operation::Value:
      return component;
    case Operation::Slope:
      return component + kSlope + static_cast<std::size_t>(leaf.a);
    default:
      return component + kCurvature + CurvatureAt(leaf.a, leaf.b);
  }
}

std::span<const double* const> PointLeaves::Evaluate(const Mesh& mesh, int element,
  const FunctionPoints& points, const double* const* behind, Scratch& scratch) const
{
  const LanePoints& xi = points.xi;
  scratch.storage.resize(std::max(scratch.storage.size(), Arrays * kTogether));
  scratch.arrays.resize(Arrays);
  for (std::size_t k = 0; k < Arrays; ++k)
  {
    scratch.arrays[k] = &scratch.storage[k * kTogether];
  }
  double* const* map = scratch.arrays.data();
  if (NeedsMap)
  {
    EvaluateMap(mesh, element, xi, map);
  }
  for (const NeededField& needed : Fields)
  {
    if (needed.derivatives >= 0)
    {
      EvaluateField(mesh, element, xi, needed, map, map + needed.first);
    }
  }
  scratch.leaves.resize(Wanted.size());
  for (std::size_t k = 0; k < Wanted.size(); ++k)
  {
    double* const own = scratch.arrays[Arrays - Wanted.size() + k];
    scratch.leaves[k] = own;
    if (IsOfField(Wanted[k]))
    {
      scratch.leaves[k] = scratch.arrays[ArrayOf(Wanted[k])];
    }
    else if (Wanted[k].operation == Operation::Behind)
    {
      scratch.leaves[k] = *behind++;
    }
    else if (Wanted[k].operation == Operation::Normal)
    {
      scratch.leaves[k] = points.normal[Wanted[k].a];
    }
    else if (Wanted[k].operation == Operation::Coordinate && points.x != nullptr)
    {
      scratch.leaves[k] = points.x[Wanted[k].a];
    }
    else
    {
      Fill(mesh, element, xi, Wanted[k], map, own);
    }
  }
  return scratch.leaves;
}

void PointLeaves::EvaluateMap(
  const Mesh& mesh, int element, const LanePoints& xi, double* const* out) const
{
  const Space& space = mesh.map.SpaceOf(element);
  KernelsFor(space).gradient(
    space, mesh.map.Coefficients(element), 3, xi, out + kPhi, out + kJacobian);
  if (NeedsInverse)
  {
    Invert(xi.count, out + kJacobian, out + kInverse);
  }
}

void PointLeaves::EvaluateField(const Mesh& mesh, int element, const LanePoints& xi,
  const NeededField& needed, double* const* map, double* const* out) const
{
  const Expansion& values = needed.field->values;
  const Space& space = values.SpaceOf(element);
  const auto components = static_cast<std::size_t>(values.components);
  std::vector<double*> value(components);
  std::vector<double*> slope(3 * components);
  for (std::size_t c = 0; c < components; ++c)
  {
    value[c] = out[c * kOfComponent];
    std::copy_n(out + c * kOfComponent + kSlope, 3, slope.begin() + std::ptrdiff_t(3 * c));
  }
  const double* coefficients = values.Coefficients(element);
  const KernelSet kernels = KernelsFor(space);
  const bool hasSlopes = needed.derivatives > 0;
  if (hasSlopes)
  {
    kernels.gradient(space, coefficients, values.components, xi, value.data(), slope.data());
  }
  else
  {
    kernels.value(space, coefficients, values.components, xi, value.data());
  }
  if (needed.field->mapping != Mapping::Identity)
  {
    ApplyMapping(mesh, element, needed.field->mapping, xi, values.components, value.data(),
      hasSlopes ? slope.data() : nullptr);
    return;
  }
  if (needed.derivatives > 1)
  {
    Curve(mesh, element, xi, *needed.field, map, out);
  }
  for (std::size_t c = 0; c < components && hasSlopes; ++c)
  {
    double* const* s = &slope[3 * c];
    if (needed.derivatives < 2)
    {
      ToSlopes(xi.count, map + kInverse, s);
    }
    std::for_each_n(s, 3, [&](double* array) { Scale(xi.count, 1.0 / mesh.size[element], array); });
  }
}

/// Second derivatives, and slopes, both by y = x / size; then the former by x.
void PointLeaves::Curve(const Mesh& mesh, int element, const LanePoints& xi, const Field& field,
  double* const* map, double* const* out) const
{
  const int components = field.values.components;
  std::vector<Hessian::value_type> byXi(static_cast<std::size_t>(components));
  Hessian ofMap;
  for (int c = 0; c < components; ++c)
  {
    ToSlopes(xi.count, map + kInverse, out + static_cast<std::size_t>(c) * kOfComponent + kSlope);
  }
  for (int i = 0; i < xi.count; ++i)
  {
    const Vec3 at(xi.x[0][i], xi.x[1][i], xi.x[2][i]);
    SecondDerivatives(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), at, ofMap);
    SecondDerivatives(field.values.SpaceOf(element), field.values.Coefficients(element), at, byXi);
    for (int c = 0; c < components; ++c)
    {
      double* const* const component = out + static_cast<std::size_t>(c) * kOfComponent;
      Mat3 bend; // symmetric
      for (int j = 0; j < 3; ++j)
      {
        for (int k = 0; k < 3; ++k)
        {
          bend[j][k] = byXi[static_cast<std::size_t>(c)][j][k];
          for (std::size_t m = 0; m < 3; ++m)
          {
            bend[j][k] -= component[kSlope + m][i] * ofMap[m][j][k];
          }
        }
      }
      Mat3 inverse; // [j][a]: column j holds d xi_j / d y_a
      for (std::size_t j = 0; j < 3; ++j)
      {
        for (std::size_t a = 0; a < 3; ++a)
        {
          inverse[static_cast<int>(j)][static_cast<int>(a)] = map[kInverse + 3 * j + a][i];
        }
      }
      const Mat3 world = inverse * bend * glm::transpose(inverse);
      for (int a = 0; a < 3; ++a)
      {
        for (int b = a; b < 3; ++b)
        {
          component[kCurvature + CurvatureAt(a, b)][i] =
            world[a][b] / mesh.size[element] / mesh.size[element];
        }
      }
    }
  }
}

/// A leaf that is of no field.
void PointLeaves::Fill(const Mesh& mesh, int element, const LanePoints& xi, const Graph::Node& leaf,
  double* const* map, double* out) const
{
  const auto each = [&](const auto& valueAt)
  {
    for (int i = 0; i < xi.count; ++i)
    {
      out[i] = valueAt(i);
    }
  };
  const double size = mesh.size[element];
  const auto a = static_cast<std::size_t>(leaf.a);
  switch (leaf.operation)
  {
    case Operation::Coordinate:
    {
      const double centre = mesh.centre[3 * static_cast<std::size_t>(element) + a];
      each([&](int i) { return std::fma(size, map[kPhi + a][i], centre); });
      return;
    }
    case Operation::Pi:
      each([](int /*i*/) { return std::numbers::pi; });
      return;
    case Operation::Reference:
      each([&](int i) { return xi.x[a][i]; });
      return;
    case Operation::InverseJacobian:
      each(
        [&](int i) { return map[kInverse + 3 * a + static_cast<std::size_t>(leaf.b)][i] / size; });
      return;
    case Operation::Determinant:
      each([&](int i) { return DeterminantAt(map + kJacobian, i) * size * size * size; });
      return;
    case Operation::ScaledJacobian:
      each(
        [&](int i)
        {
          const auto column = [&](std::size_t d) {
            return std::hypot(
              map[kJacobian + d][i], map[kJacobian + 3 + d][i], map[kJacobian + 6 + d][i]);
          };
          return DeterminantAt(map + kJacobian, i) / (column(0) * column(1) * column(2));
        });
      return;
    case Operation::ElementNumber:
      each(
        [&](int /*i*/)
        {
          return static_cast<double>(
            Numbers.empty() ? element : Numbers[static_cast<std::size_t>(element)]);
        });
      return;
    default:
      each([&, order = OrderOf(leaf, Fields, element)](int /*i*/) { return order; });
  }
}
} // namespace pixelexact
