// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/GeometryConversion.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Element/ElementUnits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

// Which orders may go. The file holds x_s (1 + e_s) for the node s, |e_s| <= 4 u: half a unit in
// the last place from writing it and a few from the solver's evaluation. With the change of basis M
// mode k is then off by at most 4 u max|x| sum_s |M_ks| = 4 u max|x| A_k. A set D of trailing modes
// is taken for noise when, for each component,
//
//   |c_k| <= 4 u max|x| A_k + size 2^-53   for each k in D,
//   sum over D of |c_k| B_k <= 1e-6 size,
//
// B_k the largest |mode k|. The first says that rounding explains it, that of the nodes or of the
// element's own coefficients (a cell without a mode has A = 0 but for M's roundings), and decides
// at usual orders: at order 6 it allows about 1e-14. The second says that nothing is lost which
// could be seen, where A is large: it grows as 2^n at order n, and the rounding of 17^3 equispaced
// nodes makes modes of 1e-10, a hundred thousand times larger than that of 7^3. Dropping them
// brings the map nearer to the solver's. What is dropped is recorded: the map is uncertain by
//
//   sum over D of |c_k| B_k  +  4 u max|x| min(L, sum over the kept k of A_k B_k),
//
// L (NoiseBound) what noise in all nodes can move the whole map; it is some hundredth of the sum.
// A straight cell with nodes halfway is found so: its orders above 1 are noise. A pyramid of order
// 2 is in another form than the straight one; the modes of their difference are judged instead.
namespace pixelexact
{
namespace
{
constexpr double kCoordinateRoundings = 4.0;
constexpr double kLargestLoss = 1e-6;    ///< in units of the element
constexpr double kOwnRounding = 0x1p-53; ///< in units of the element

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

/// Decides about trailing orders by the rule above.
class Reduction
{
public:
  /// `roundings`: of the coordinates, world units; `noise`: how far one of them may move the map.
  Reduction(const Space& space, std::span<const double> amplification,
    std::span<const double> modes, double roundings, double noise, double size)
    : Full(space)
    , Amplification(amplification)
    , Modes(modes)
    , Roundings(roundings)
    , Noise(noise)
    , Size(size)
  {
    Visit(
      [&](int p, int q, int r, int mode)
      {
        if (!IsExplained(mode))
        {
          Needed = { std::max(Needed[0], p), std::max(Needed[1], q), std::max(Needed[2], r) };
        }
      });
  }

  /// Whether nothing but noise is there.
  [[nodiscard]] bool IsNoise() const
  {
    return IsNoise([](int, int, int) { return false; });
  }

  [[nodiscard]] Space Reduce() const
  {
    Space kept = Full;
    const auto accept = [&](std::initializer_list<int> directions)
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
    };
    bool again = true;
    while (again)
    {
      switch (Full.shape)
      {
        case Shape::Hexahedron:
          again = accept({ 0, 1, 2 });
          // One direction alone only where not all three can go.
          for (int d = 0; d < 3 && !again; ++d)
          {
            again = accept({ d });
          }
          break;
        case Shape::Prism:
        {
          const bool triangle = accept({ 0, 2 });
          again = accept({ 1 }) || triangle;
          break;
        }
        case Shape::Tetrahedron:
          again = accept({ 0, 1, 2 });
          break;
        default:
          again = Full.form == Form::Collapsed && accept({ 0, 1, 2 });
      }
    }
    return kept;
  }

  /// World units: how far the kept map may be from the true one.
  [[nodiscard]] double Uncertainty(const Space& kept) const
  {
    std::array<double, 3> dropped{};
    double noise = 0.0;
    const bool all = kept == Full;
    Visit(
      [&](int p, int q, int r, int mode)
      {
        const double bound = ModeBound(Full, p, q, r);
        if (all || Has(kept, p, q, r))
        {
          noise += Roundings * Amplification[mode] * bound;
          return;
        }
        for (int c = 0; c < 3; ++c)
        {
          dropped[c] += std::fabs(At(c, mode)) * bound;
        }
      });
    return *std::ranges::max_element(dropped) + std::min(noise, Noise * Roundings);
  }

  static bool Has(const Space& space, int p, int q, int r)
  {
    return p <= space.order[0] && q <= space.LastQ(p) && r <= space.LastR(p, q);
  }

private:
  template <class Function>
  void Visit(Function&& function) const
  {
    ForEachMode(Full, function);
  }
  [[nodiscard]] double At(int component, int mode) const
  {
    return Modes[static_cast<std::size_t>(component) * Amplification.size() + mode];
  }

  /// Whether rounding explains a mode.
  [[nodiscard]] bool IsExplained(int mode) const
  {
    const double noise = Roundings * Amplification[mode] + kOwnRounding * Size;
    return std::fabs(At(0, mode)) <= noise && std::fabs(At(1, mode)) <= noise &&
      std::fabs(At(2, mode)) <= noise;
  }

  /// Whether the modes that are not kept are noise.
  template <class Keeps>
  [[nodiscard]] bool IsNoise(const Keeps& keeps) const
  {
    bool explained = true;
    std::array<double, 3> dropped{};
    Visit(
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

  Space Full;
  std::span<const double> Amplification;
  std::span<const double> Modes;
  double Roundings;
  double Noise;
  double Size;
  std::array<int, 3> Needed{}; ///< orders below these drop a mode that is no noise
};

/// The modes of all three components, world units, relative to the centre.
std::vector<double> ModesOf(
  const SourceMesh& mesh, int element, const ChangeOfBasis& change, const Vec3& centre)
{
  thread_local std::vector<double> nodes;
  thread_local ChangeOfBasis::Scratch scratch;
  std::vector<double> modes(3 * static_cast<std::size_t>(change.Target().Modes()));
  // A slab's z is not the points'.
  const std::size_t components = mesh.GetSlab() ? 2 : 3;
  const std::array<double, 3> shifts{ centre.x, centre.y, centre.z };
  mesh.GatherAll(element, mesh.Coordinates(), 3, static_cast<int>(components), nodes);
  change.Apply(nodes, std::span(shifts).first(components), modes, scratch);
  return modes;
}

/// How far a pyramid of order 2 is from the straight one between its vertices, world units; none
/// where rounding does not explain it.
std::optional<double> DistanceToStraight(const CellBasis& basis, std::vector<double> modes,
  const std::vector<double>& straight, double roundings, double size)
{
  std::ranges::transform(modes, straight, modes.begin(), std::minus());
  std::vector<double> amplification(
    basis.change.Amplification().begin(), basis.change.Amplification().end());
  std::ranges::transform(
    amplification, basis.straight[0].Amplification(), amplification.begin(), std::plus());
  const Space& space = basis.GetSpace();
  const Reduction difference(
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
/// From the plane's space into the slab's.
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
  const Reduction reduction(full, change->Amplification(), modes, roundings, noise, geometry.size);
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
        if (Reduction::Has(geometry.space, p, q, r))
        {
          // A power of two: exact.
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
