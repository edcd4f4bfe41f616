// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Fields/FieldBasis.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Geometry/ReferenceShapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pixelexact::nektar
{
namespace
{
/// Dense changes of basis beyond this take minutes.
constexpr int kMostDenseModes = 2000;

LineFunctions LineOf(const std::string& family, int count)
{
  if (family == "GLL_Lagrange" && count >= 2)
  {
    return Lagrange(GaussLobattoPoints(count));
  }
  if (family == "Gauss_Lagrange")
  {
    return Lagrange(GaussPoints(count));
  }
  if (family == "Modified_A")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = ModifiedA(n, z);
        }
      } };
  }
  if (family == "Ortho_A" || family == "Legendre")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = std::sqrt(n + 0.5L) * std::legendre(n, z);
        }
      } };
  }
  if (family == "Chebyshev")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = std::cos(n * std::acos(std::clamp(z, -1.0L, 1.0L)));
        }
      } };
  }
  if (family == "Monomial")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = std::pow(z, n);
        }
      } };
  }
  throw Unsupported("the family of functions '" + family.substr(0, 40) +
    "' is not read on hexahedra; Modified_A, Ortho_A, GLL_Lagrange and Gauss_Lagrange are.");
}

/// Across a slab.
LineFunctions Constant()
{
  return { 1, [](long double /*z*/, long double* value) { *value = 1.0L; } };
}

ChangeOfBasis HexahedronChange(const Expansion3& expansion)
{
  Space space{ Shape::Hexahedron, Form::Collapsed, {} };
  std::array<LineFunctions, 3> lines;
  for (int d = 0; d < 3; ++d)
  {
    space.order[d] = static_cast<std::uint8_t>(expansion.count[d] - 1);
    lines[d] = expansion.families[d].empty() ? Constant()
                                             : LineOf(expansion.families[d], expansion.count[d]);
  }
  const auto& n = expansion.count;
  std::vector<int> source;
  for (int i = 0; i < n[0]; ++i)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int k = 0; k < n[2]; ++k)
      {
        source.push_back((k * n[1] + j) * n[0] + i); // p fastest in the file
      }
    }
  }
  return ChangeOfBasis::FromLines(space, lines, source);
}

/// The families that belong to a shape: those of the modified and those of the orthogonal basis.
bool IsFamily(const Expansion3& expansion, const char* kind)
{
  const std::string a = std::string(kind) + "_A";
  const std::string b = std::string(kind) + "_B";
  const std::string c = std::string(kind) + "_C";
  const std::string pyramid = std::string(kind) + "Pyr_C";
  const auto& f = expansion.families;
  switch (expansion.shape)
  {
    case Shape::Prism:
      return f[0] == a && (f[1] == a || expansion.IsPlane()) && f[2] == b;
    case Shape::Tetrahedron:
      return f[0] == a && f[1] == b && f[2] == c;
    default:
      return f[0] == a && f[1] == a && (f[2] == pyramid || f[2] == c);
  }
}

void RequireNestedOrders(const Expansion3& expansion)
{
  const auto [p, q, r] = expansion.count;
  const bool sound = expansion.shape == Shape::Prism ? p <= r
    : expansion.shape == Shape::Tetrahedron          ? p <= q && q <= r
                                                     : std::max(p, q) <= r;
  if (!sound)
  {
    throw InvalidData("the numbers of modes " + std::to_string(p) + ", " + std::to_string(q) +
      ", " + std::to_string(r) + " are not nested as a " + NameOf(expansion) + " needs them.");
  }
}
} // namespace

ChangeOfBasis ChangeInto(Shape shape, const std::array<int, 3>& order, int functions,
  const std::function<void(const LongVec3&, long double*)>& evaluate)
{
  Space space{ shape, Form::Collapsed, {} };
  std::ranges::copy(order, space.order.begin());
  if (space.Modes() > kMostDenseModes)
  {
    throw Unsupported("elements of " + std::to_string(space.Modes()) +
      " modes are not read; up to " + std::to_string(kMostDenseModes) + " are.");
  }
  if (shape != Shape::Pyramid)
  {
    return ChangeOfBasis::FromFunctions(space, functions, evaluate);
  }
  // The factor ((1 - z) / 2)^(p + q - 2) of Nektar++'s inner functions may exceed the collapsed
  // space; a tensor space holds every one of them.
  try
  {
    return ChangeOfBasis::FromFunctions(space, functions, evaluate);
  }
  catch (const InvalidData&)
  {
    const int lower = std::min(order[0], order[1]);
    space.form = Form::Tensor;
    space.order[2] = static_cast<std::uint8_t>(order[2] + std::max(0, lower - 2));
    return ChangeOfBasis::FromFunctions(space, functions, evaluate);
  }
}

ElementBasis MakeFieldBasis(const Expansion3& expansion)
{
  ElementBasis basis;
  const auto modes = ModesOf(expansion.shape, expansion.count);
  basis.sources = static_cast<int>(modes.size());
  if (expansion.shape == Shape::Hexahedron)
  {
    basis.parts.push_back(HexahedronChange(expansion));
    return basis;
  }
  const bool modified = IsFamily(expansion, "Modified");
  if (!modified && !IsFamily(expansion, "Ortho"))
  {
    throw Unsupported("the basis " + Describe(expansion) + " on a " + NameOf(expansion) +
      " is not read; the modified and the orthogonal ones are.");
  }
  RequireNestedOrders(expansion);
  const auto function = modified ? &ModifiedMode : &OrthogonalMode;
  const auto& n = expansion.count;
  basis.parts.push_back(ChangeInto(expansion.shape, { n[0] - 1, n[1] - 1, n[2] - 1 }, basis.sources,
    [&](const LongVec3& xi, long double* values)
    {
      // A triangle's functions are a prism's at one end, up to what the line's one is there.
      const LongVec3 at = expansion.IsPlane() ? LongVec3{ xi[0], -1, xi[2] } : xi;
      const long double across = expansion.IsPlane() && !modified ? std::sqrt(0.5L) : 1.0L;
      for (const Mode& mode : modes)
      {
        *values++ = function(expansion.shape, mode, at) / across;
      }
    }));
  return basis;
}
} // namespace pixelexact::nektar
