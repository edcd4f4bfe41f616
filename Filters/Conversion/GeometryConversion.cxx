// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/GeometryConversion.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Basis/Space.h"
#include "Core/Element/ElementUnits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
// The rule for orders that can be dropped. The file holds x_s (1 + e_s) for the node s, |e_s| <= 4
// u: half a unit in the last place from writing it and a few from the solver's evaluation. With the
// change of basis M mode k is then off by at most 4 u max|x| sum_s |M_ks| = 4 u max|x| A_k. A set D
// of trailing modes counts as noise when, for each component,
//
//   |c_k| <= 4 u max|x| A_k + size 2^-53   for each k in D,
//   sum over D of |c_k| B_k <= 1e-6 size,
//
// where B_k is the largest |mode k|. The first condition means that rounding of the nodes or of the
// element's own coefficients explains the mode (a cell without a mode has A = 0 but for M's
// roundings). It decides at usual orders: at order 6 it allows about 1e-14. The second condition
// means that no visible detail is lost where A is large: A grows as 2^n at order n, and the
// rounding of 17^3 equispaced nodes makes modes of 1e-10, a hundred thousand times larger than that
// of 7^3. Dropping them brings the map nearer to the solver's. The uncertainty of the map records
// what is dropped:
//
//   sum over D of |c_k| B_k  +  min(4 u max|x| sum over the kept k of A_k B_k,
//                                   4 u max|x| L + u sum over k of |c_k| B_k),
//
// L (NoiseBound) bounds how far noise in all nodes moves the whole map. It is about a hundredth of
// the sum over k, which includes the rounding of the modes. The rule detects a straight cell with
// nodes at edge midpoints: its orders above 1 are noise. A pyramid of order 2 has another form than
// the straight one; there the modes of their difference are tested instead.

/// Finds the trailing orders of an element's map that are noise from its coordinates' roundings, by
/// the rule above. Refers to its arguments.
class OrderReduction
{
public:
  /// `amplification`: per mode, the factor by which roundings of nodes grow. `modes`: those of the
  /// map's three components, one after the other. `size`: that of the element. Both are in world
  /// units. `roundings`: of the coordinates, world units. `noise`: how far one unit of rounding may
  /// move the map.
  OrderReduction(const Space& space, std::span<const double> amplification,
    std::span<const double> modes, double roundings, double noise, double size);

  /// Whether all modes are noise.
  [[nodiscard]] bool IsNoise() const;
  /// The space without the orders that are noise.
  [[nodiscard]] Space Reduce() const;
  /// Bound of the distance of the map in `kept` from the true map, in world units.
  [[nodiscard]] double Uncertainty(const Space& kept) const;

  /// Whether `space` has a mode.
  static bool Has(const Space& space, int p, int q, int r);

private:
  [[nodiscard]] double At(int component, int mode) const;
  /// Whether rounding explains a mode.
  [[nodiscard]] bool IsExplained(int mode) const;
  /// Whether the modes that are not kept are noise.
  template <class Keeps>
  [[nodiscard]] bool IsNoise(const Keeps& keeps) const;
  /// Lowers `kept` by the last order of these directions where it is noise. Returns whether it was.
  bool Drop(std::span<const int> directions, Space& kept) const;

  Space Full;
  std::span<const double> Amplification;
  std::span<const double> Modes;
  double Roundings;
  double Noise;
  double Size;
  std::array<int, 3> Needed{}; ///< orders below these drop a mode that is no noise
};

constexpr double kLargestLoss = 1e-6;    ///< in units of the element
constexpr double kOwnRounding = 0x1p-53; ///< in units of the element

OrderReduction::OrderReduction(const Space& space, std::span<const double> amplification,
  std::span<const double> modes, double roundings, double noise, double size)
  : Full(space)
  , Amplification(amplification)
  , Modes(modes)
  , Roundings(roundings)
  , Noise(noise)
  , Size(size)
{
  ForEachMode(Full,
    [&](int p, int q, int r, int mode)
    {
      if (!IsExplained(mode))
      {
        Needed = { std::max(Needed[0], p), std::max(Needed[1], q), std::max(Needed[2], r) };
      }
    });
}

double OrderReduction::At(int component, int mode) const
{
  return Modes[static_cast<std::size_t>(component) * Amplification.size() + mode];
}

bool OrderReduction::IsExplained(int mode) const
{
  const double noise = Roundings * Amplification[mode] + kOwnRounding * Size;
  return std::fabs(At(0, mode)) <= noise && std::fabs(At(1, mode)) <= noise &&
    std::fabs(At(2, mode)) <= noise;
}

template <class Keeps>
bool OrderReduction::IsNoise(const Keeps& keeps) const
{
  bool explained = true;
  std::array<double, 3> dropped{};
  ForEachMode(Full,
    [&](int p, int q, int r, int mode)
    {
      if (!explained || keeps(p, q, r))
      {
        return;
      }
      explained = IsExplained(mode);
      const double bound = ModeBound(Full, p, q, r);
      for (int c = 0; c < 3; ++c)
      {
        dropped[c] += std::fabs(At(c, mode)) * bound;
      }
    });
  return explained && *std::ranges::max_element(dropped) <= kLargestLoss * Size;
}

bool OrderReduction::IsNoise() const
{
  return IsNoise([](int, int, int) { return false; });
}

bool OrderReduction::Has(const Space& space, int p, int q, int r)
{
  return p <= space.order[0] && q <= space.LastQ(p) && r <= space.LastR(p, q);
}

bool OrderReduction::Drop(std::span<const int> directions, Space& kept) const
{
  Space next = kept;
  for (const int d : directions)
  {
    if (next.order[d] <= 1)
    {
      return false;
    }
    --next.order[d];
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    if (next.order[d] < Needed[d])
    {
      return false;
    }
  }
  if (!next.IsValid() || !IsNoise([&next](int p, int q, int r) { return Has(next, p, q, r); }))
  {
    return false;
  }
  kept = next;
  return true;
}

Space OrderReduction::Reduce() const
{
  constexpr std::array kAll{ 0, 1, 2 };
  constexpr std::array kTriangle{ 0, 2 };
  Space kept = Full;
  bool again = true;
  while (again)
  {
    switch (Full.shape)
    {
      case Shape::Hexahedron:
        again = Drop(kAll, kept);
        // Tries single directions only where not all three can be lowered.
        for (int d = 0; d < 3 && !again; ++d)
        {
          again = Drop(std::span(&d, 1), kept);
        }
        break;
      case Shape::Prism:
      {
        const bool triangle = Drop(kTriangle, kept);
        again = Drop(std::span(&kAll[1], 1), kept) || triangle;
        break;
      }
      case Shape::Tetrahedron:
        again = Drop(kAll, kept);
        break;
      default:
        again = Full.form == Form::Collapsed && Drop(kAll, kept);
    }
  }
  return kept;
}

double OrderReduction::Uncertainty(const Space& kept) const
{
  std::array<double, 3> dropped{};
  std::array<double, 3> own{};
  double noise = 0.0;
  const bool all = kept == Full;
  ForEachMode(Full,
    [&](int p, int q, int r, int mode)
    {
      const double bound = ModeBound(Full, p, q, r);
      const bool keeps = all || Has(kept, p, q, r);
      noise += keeps ? Roundings * Amplification[mode] * bound : 0.0;
      for (int c = 0; c < 3; ++c)
      {
        const double most = std::fabs(At(c, mode)) * bound;
        own[c] += kOwnRounding * most;
        dropped[c] += keeps ? 0.0 : most;
      }
    });
  return *std::ranges::max_element(dropped) +
    std::min(noise, Noise * Roundings + *std::ranges::max_element(own));
}

ElementUnits UnitsOf(const SourceMesh& mesh, int element)
{
  Vec3 low(INFINITY);
  Vec3 high(-INFINITY);
  const auto xyz = mesh.Coordinates();
  for (const auto p : mesh.Points(element))
  {
    const Vec3 x(xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]);
    low = glm::min(low, x);
    high = glm::max(high, x);
  }
  if (const auto& slab = mesh.GetSlab())
  {
    low.z = slab->middle - slab->thickness / 2;
    high.z = slab->middle + slab->thickness / 2;
  }
  try
  {
    return MakeElementUnits(low, high);
  }
  catch (const InvalidData& error)
  {
    throw InvalidData(mesh.Describe(element) + " " + error.what());
  }
}

/// The modes of all three components, world units, relative to the centre.
std::vector<double> ModesOf(
  const SourceMesh& mesh, int element, const ChangeOfBasis& change, const Vec3& centre)
{
  thread_local std::vector<double> nodes;
  thread_local ChangeOfBasis::Scratch scratch;
  std::vector<double> modes(3 * static_cast<std::size_t>(change.Target().Modes()));
  // The z of a slab does not come from the points.
  const std::size_t components = mesh.GetSlab() ? 2 : 3;
  const std::array<double, 3> shifts{ centre.x, centre.y, centre.z };
  mesh.GatherAll(element, mesh.Coordinates(), 3, static_cast<int>(components), nodes);
  change.Apply(nodes, std::span(shifts).first(components), modes, scratch);
  return modes;
}

/// Distance of a pyramid of order 2 from the straight pyramid between its vertices, world units.
/// None where rounding does not explain it.
std::optional<double> DistanceToStraight(const CellBasis& basis, std::vector<double> modes,
  const std::vector<double>& straight, double roundings, double size)
{
  std::ranges::transform(modes, straight, modes.begin(), std::minus());
  std::vector<double> amplification(
    basis.change.Amplification().begin(), basis.change.Amplification().end());
  std::ranges::transform(
    amplification, basis.straight[0].Amplification(), amplification.begin(), std::plus());
  const Space& space = basis.GetSpace();
  const OrderReduction difference(
    space, amplification, modes, roundings, std::numeric_limits<double>::infinity(), size);
  if (!difference.IsNoise())
  {
    return std::nullopt;
  }
  double largest = 0.0;
  const auto count = static_cast<std::size_t>(space.Modes());
  for (int c = 0; c < 3; ++c)
  {
    double sum = 0.0;
    ForEachMode(space,
      [&](int p, int q, int r, int mode)
      { sum += std::fabs(modes[c * count + mode]) * ModeBound(space, p, q, r); });
    largest = std::max(largest, sum);
  }
  return largest;
}
/// Maps the geometry from the plane's space to the slab's.
void Lift(const Slab& slab, const ElementUnits& units, ElementGeometry& geometry)
{
  const Space plane = geometry.space;
  const auto inUnits = [&units](double x) { return std::ldexp(x, -units.exponent); };
  std::vector<double> modes = std::move(geometry.coefficients);
  modes.resize(2 * static_cast<std::size_t>(plane.Modes()));
  geometry.space = Lifted(plane);
  geometry.coefficients.resize(3 * static_cast<std::size_t>(geometry.space.Modes()));
  LiftMap(plane, modes, inUnits(slab.middle - units.centre.z), inUnits(slab.thickness / 2),
    geometry.coefficients);
}
} // namespace

ElementGeometry ConvertGeometry(const SourceMesh& mesh, int element)
{
  const ElementUnits units = UnitsOf(mesh, element);
  const CellBasis& basis = mesh.Basis(element);
  ElementGeometry geometry;
  geometry.centre = { units.centre.x, units.centre.y, units.centre.z };
  geometry.size = std::ldexp(1.0, units.exponent);
  const double roundings = kCoordinateRoundings * mesh.CoordinateRoundoff() * units.largest;
  const ChangeOfBasis* change = &basis.change;
  std::vector<double> modes = ModesOf(mesh, element, *change, units.centre);
  if (!basis.straight.empty())
  {
    const auto distance = DistanceToStraight(basis, modes,
      ModesOf(mesh, element, basis.straight[0], units.centre), roundings, geometry.size);
    if (distance)
    {
      geometry.uncertainty = *distance;
      change = &basis.straight[1];
      modes = ModesOf(mesh, element, *change, units.centre);
    }
  }
  const Space full = change->Target();
  const double noise =
    change == &basis.change ? basis.noise : std::numeric_limits<double>::infinity();
  const OrderReduction reduction(
    full, change->Amplification(), modes, roundings, noise, geometry.size);
  geometry.space = reduction.Reduce();
  geometry.uncertainty += reduction.Uncertainty(geometry.space) + mesh.Loss(element);
  const auto count = static_cast<std::size_t>(full.Modes());
  const double inUnits = std::ldexp(1.0, -units.exponent);
  if (geometry.space == full && !mesh.GetSlab())
  {
    std::ranges::transform(
      modes, modes.begin(), [inUnits](double mode) { return inUnits * mode; }); // exact
    geometry.coefficients = std::move(modes);
    return geometry;
  }
  geometry.coefficients.reserve(3 * static_cast<std::size_t>(geometry.space.Modes()));
  for (int c = 0; c < 3; ++c)
  {
    ForEachMode(full,
      [&](int p, int q, int r, int mode)
      {
        if (OrderReduction::Has(geometry.space, p, q, r))
        {
          // The factor is a power of two, so the product is exact.
          geometry.coefficients.push_back(inUnits * modes[c * count + mode]);
        }
      });
  }
  if (mesh.GetSlab())
  {
    Lift(*mesh.GetSlab(), units, geometry);
  }
  return geometry;
}

std::size_t MostCoefficients(const SourceMesh& mesh, int element)
{
  const CellBasis& basis = mesh.Basis(element);
  int modes = 0;
  const auto note = [&](const ChangeOfBasis& change)
  {
    const Space& space = change.Target();
    modes = std::max(modes, mesh.GetSlab() ? Lifted(space).Modes() : space.Modes());
  };
  note(basis.change);
  std::ranges::for_each(basis.straight, note);
  return 3 * static_cast<std::size_t>(modes);
}
} // namespace pixelexact
