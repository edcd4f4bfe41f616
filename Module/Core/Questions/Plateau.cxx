// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/Plateau.h"

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

namespace pixelexact
{
namespace
{
using Long = long double;

constexpr Interval kNoValue{ 1.0, -1.0 };

/// Points along a line for each degree of a polynomial.
constexpr int kDensity = 2;
/// Covers the rounding of modes and of sums of about ten thousand numbers in blocks, relative to
/// the sum of their magnitudes: about a hundred of 2^-64 each, in long double with 64 bits of
/// mantissa.
constexpr Long kSumRounding = 0x1p-55L;
constexpr std::size_t kBlock = 64;

/// Proven bounds of a component on a part of an element, and of its change by the rounding of its
/// coefficients.
struct Level
{
  Long lower;
  Long upper;
  Long unsure;
};

/// The values that a component holds; for several components, the values of their norm.
Interval HeldBy(std::span<const Level> levels, int exponent)
{
  Level all = levels.front();
  if (levels.size() > 1)
  {
    all = { 0.0L, 0.0L, 0.0L };
    for (const auto& [lower, upper, unsure] : levels)
    {
      const Long least = std::max({ 0.0L, lower, -upper });
      const Long most = std::max(std::fabs(lower), std::fabs(upper));
      all.lower += least * least;
      all.upper += most * most;
      all.unsure += unsure * unsure;
    }
    all = { std::sqrt(all.lower), std::sqrt(all.upper), std::sqrt(all.unsure) };
  }
  const Long least = all.upper - all.unsure;
  const Long most = all.lower + all.unsure;
  // The comparison is written so that a NaN holds nothing.
  if (!(least <= most))
  {
    return kNoValue;
  }
  return { std::ldexp(static_cast<double>(least), exponent),
    std::ldexp(static_cast<double>(most), exponent) };
}

Long LargestOf(std::span<const double> modes)
{
  Long largest = 0.0L;
  for (const double c : modes)
  {
    largest = std::max(largest, static_cast<Long>(std::fabs(c)));
  }
  return largest;
}

std::span<const double> ComponentOf(const ScaledModes& modes, int component)
{
  return std::span(modes.values)
    .subspan(modes.width * static_cast<std::size_t>(component), modes.width);
}

template <class LevelOf>
Interval HeldByEach(const ScaledModes& modes, int components, const LevelOf& levelOf)
{
  const Long digits = kUnitRoundoff * static_cast<Long>(SumOfModeBounds(modes.space));
  std::vector<Level> levels;
  for (int c = 0; c < components; ++c)
  {
    const std::span<const double> own = ComponentOf(modes, c);
    levels.push_back(levelOf(own, digits * LargestOf(own)));
  }
  return HeldBy(levels, modes.exponent);
}

Long SumOfProducts(std::span<const double> a, std::span<const Long> b)
{
  Long sum = 0.0L;
  for (std::size_t first = 0; first < a.size(); first += kBlock)
  {
    Long ofBlock = 0.0L;
    for (std::size_t m = first; m < std::min(first + kBlock, a.size()); ++m)
    {
      ofBlock += a[m] * b[m];
    }
    sum += ofBlock;
  }
  return sum;
}

/// On m > n of Chebyshev's points a polynomial of degree n is somewhere at least cos(pi n / 2m)
/// times its largest (Ehlich and Zeller, Schwankung von Polynomen zwischen Gitterpunkten, 1964).
std::vector<Long> PointsFor(int degree)
{
  std::vector<Long> points(static_cast<std::size_t>(std::max(1, kDensity * degree)));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    points[k] = std::cos(std::numbers::pi_v<Long> * (2.0L * static_cast<Long>(k) + 1.0L) /
      (2.0L * static_cast<Long>(points.size())));
  }
  return points;
}

/// TensorToReference in long double: in doubles, points would be off a slanted face by as much as
/// is measured here.
LongVec3 InXi(Shape shape, const LongVec3& eta)
{
  const auto collapse = [](Long y, Long z) { return (1.0L + y) * (1.0L - z) / 2.0L - 1.0L; };
  LongVec3 xi = eta;
  if (shape == Shape::Pyramid || shape == Shape::Tetrahedron)
  {
    xi[1] = collapse(eta[1], eta[2]);
  }
  if (shape != Shape::Hexahedron)
  {
    xi[0] = collapse(shape == Shape::Tetrahedron ? collapse(eta[0], eta[1]) : eta[0], eta[2]);
  }
  return xi;
}
} // namespace

Interval HeldInElement(const ScaledModes& modes, int components)
{
  return HeldByEach(modes, components,
    [&](std::span<const double> c, Long unsure) -> Level
    {
      Long rest = 0.0L;
      ForEachMode(modes.space,
        [&](int p, int q, int r, int mode)
        {
          rest += mode == 0 ? 0.0L
                            : std::fabs(static_cast<Long>(c[static_cast<std::size_t>(mode)])) *
              static_cast<Long>(ModeBound(modes.space, p, q, r));
        });
      rest *= 1.0L + kSumRounding;
      return { c[0] - rest, c[0] + rest, unsure };
    });
}

Interval HeldOnFace(const ScaledModes& modes, int components, const ShapeFace& face)
{
  std::array<std::vector<Long>, 3> lines;
  Long factor = 1.0L;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int degree = modes.space.TensorDegree()[d];
    const bool fixed = static_cast<int>(d) == face.direction;
    lines[d] = fixed ? std::vector{ face.upper ? 1.0L : -1.0L } : PointsFor(degree);
    // A hundredth covers the rounding of the points.
    factor /=
      fixed || degree == 0 ? 1.0L : std::cos(std::numbers::pi_v<Long> / (2 * kDensity)) / 1.01L;
  }
  const auto width = modes.width;
  const auto count = static_cast<std::size_t>(components);
  std::vector<Long> basis(width);
  std::vector<Level> found(
    count, { std::numeric_limits<Long>::infinity(), -std::numeric_limits<Long>::infinity(), 0.0L });
  for (const Long x : lines[0])
  {
    for (const Long y : lines[1])
    {
      for (const Long z : lines[2])
      {
        EvaluateModes(modes.space, InXi(modes.space.shape, { x, y, z }), basis.data());
        for (std::size_t c = 0; c < count; ++c)
        {
          const std::span<const double> own = ComponentOf(modes, static_cast<int>(c));
          const Long value = SumOfProducts(own, basis);
          found[c].lower = std::min(found[c].lower, value);
          found[c].upper = std::max(found[c].upper, value);
        }
      }
    }
  }
  std::size_t next = 0;
  return HeldByEach(modes, components,
    [&](std::span<const double> c, Long unsure) -> Level
    {
      const Level& points = found[next++];
      const Long middle = 0.5L * (points.lower + points.upper);
      const Long rounding = kSumRounding * LargestOf(c) * SumOfModeBounds(modes.space);
      const Long off = factor * (points.upper - middle + rounding);
      return { middle - off, middle + off, unsure };
    });
}

Interval HeldOnPlane(
  const ScaledModes& modes, int components, const ScaledModes& map, const PlaneInElement& plane)
{
  if (map.space.form != modes.space.form)
  {
    return kNoValue; // equal numbers are other functions
  }
  // n . Phi - offset, by the numbers of its modes.
  using Place = std::array<int, 3>;
  struct Term
  {
    Long field = 0.0L;
    Long plane = 0.0L;
    double largest = 1.0;
  };
  std::map<Place, Term> terms;
  Long planeDigits = std::fabs(plane.offset);
  Long sizes = 0.0L;
  ForEachMode(map.space,
    [&](int p, int q, int r, int mode)
    {
      Term& term = terms[{ p, q, r }];
      term.largest = ModeBound(map.space, p, q, r);
      for (int d = 0; d < 3; ++d)
      {
        term.plane += static_cast<Long>(plane.normal[d]) *
          std::ldexp(
            static_cast<Long>(ComponentOf(map, d)[static_cast<std::size_t>(mode)]), map.exponent);
      }
      term.plane -= mode == 0 ? plane.offset : 0.0L;
      sizes += term.largest;
    });
  for (int d = 0; d < 3; ++d)
  {
    planeDigits +=
      std::fabs(plane.normal[d]) * std::ldexp(LargestOf(ComponentOf(map, d)), map.exponent) * sizes;
  }
  planeDigits *= kUnitRoundoff;
  ForEachMode(modes.space,
    [&](int p, int q, int r, int) {
      terms[{ p, q, r }].largest = ModeBound(modes.space, p, q, r);
    });
  const auto steepest = std::ranges::max_element(terms, {},
    [](const auto& one) { return one.first == Place{} ? -1.0L : std::fabs(one.second.plane); });
  return HeldByEach(modes, components,
    [&](std::span<const double> c, Long unsure) -> Level
    {
      for (auto& [place, term] : terms)
      {
        term.field = 0.0L;
      }
      ForEachMode(modes.space,
        [&](int p, int q, int r, int mode) {
          terms[{ p, q, r }].field = c[static_cast<std::size_t>(mode)];
        });
      const auto& [place, steep] = *steepest;
      const Long lambda =
        place == Place{} || !(std::fabs(steep.plane) > 0.0L) ? 0.0L : steep.field / steep.plane;
      const Term& constant = terms[Place{}];
      const Long value = constant.field - lambda * constant.plane;
      Long rest = kSumRounding * (std::fabs(value) + std::fabs(constant.field));
      for (const auto& [at, term] : terms)
      {
        rest += at == Place{}
          ? 0.0L
          : std::fabs(term.field - lambda * term.plane) * term.largest * (1.0L + kSumRounding);
      }
      return { value - rest, value + rest, unsure + std::fabs(lambda) * planeDigits };
    });
}

ElementPlateaus::ElementPlateaus(const Mesh& mesh, int element, const Field& field, int component)
  : mesh_(mesh)
  , Element(element)
  , field_(field)
  , Component(component)
  , MayHold(field.function == nullptr && field.mapping == Mapping::Identity && Modes().finite)
{
}

ScaledModes ElementPlateaus::Modes() const
{
  const Space& space = field_.values.SpaceOf(Element);
  return { space,
    field_.values.Coefficients(Element) +
      static_cast<std::ptrdiff_t>(std::max(Component, 0)) * space.Modes(),
    Components() };
}

int ElementPlateaus::Components() const
{
  return Component < 0 ? field_.values.components : 1;
}

const Interval& ElementPlateaus::InElement() const
{
  return Kept.Get(6,
    [this]
    {
      return std::make_unique<const Interval>(
        MayHold ? HeldInElement(Modes(), Components()) : kNoValue);
    });
}

const Interval& ElementPlateaus::OnFace(int face) const
{
  const auto k = static_cast<std::size_t>(face);
  return Kept.Get(k,
    [this, k]
    {
      return std::make_unique<const Interval>(
        MayHold ? HeldOnFace(Modes(), Components(), FacesOf(mesh_.ShapeOf(Element))[k]) : kNoValue);
    });
}

Interval ElementPlateaus::OnPlane(const Vec3& point, const Vec3& normal) const
{
  const ScaledModes map(mesh_.map.SpaceOf(Element), mesh_.map.Coefficients(Element), 3);
  if (!MayHold || !map.finite)
  {
    return kNoValue;
  }
  const std::size_t e = 3 * static_cast<std::size_t>(Element);
  const Vec3 centre(mesh_.centre[e], mesh_.centre[e + 1], mesh_.centre[e + 2]);
  const double size = mesh_.size[static_cast<std::size_t>(Element)];
  return HeldOnPlane(
    Modes(), Components(), map, { normal, glm::dot(normal, (point - centre) / size) });
}
} // namespace pixelexact
