// SPDX-License-Identifier: BSD-3-Clause
#include "GeometryConversion.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Element/ElementUnits.h"

#include <algorithm>
#include <cmath>
#include <functional>

// Which orders may go. The file holds x_s (1 + e_s) for the node s, |e_s| <= 4 u: half a unit in
// the last place from writing it and a few from the solver's evaluation. With the change of basis M
// mode k is then off by at most 4 u max|x| sum_s |M_ks| = 4 u max|x| A_k. A set D of trailing modes
// is taken for noise when, for each component,
//
//   |c_k| <= 4 u max|x| A_k                for each k in D,
//   sum over D of |c_k| B_k <= 1e-6 size,
//
// B_k the largest |mode k|. The first says that rounding explains it, and decides at usual orders:
// at order 6 it allows about 1e-14. The second says that nothing is lost which could be seen, where
// A is large: it grows as 2^n at order n, and the rounding of 17^3 equispaced nodes makes modes of
// 1e-10, a hundred thousand times larger than that of 7^3. Dropping them brings the map nearer to
// the solver's. What is dropped is recorded: the map is uncertain by
//
//   sum over D of |c_k| B_k  +  4 u max|x| sum over the kept k of A_k B_k.
namespace pixelexact
{
namespace
{
constexpr double kCoordinateRoundings = 4.0;
constexpr double kLargestLoss = 1e-6; ///< in units of the element

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
  Reduction(const Space& space, std::span<const double> amplification,
    std::span<const double> modes, double roundings, double largestLoss)
    : Full(space)
    , Amplification(amplification)
    , Modes(modes)
    , Roundings(roundings)
    , LargestLoss(largestLoss)
  {
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
      if (!next.IsValid() || !IsNoise(next))
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
    Visit(
      [&](int p, int q, int r, int mode)
      {
        const double bound = ModeBound(Full, p, q, r);
        if (Has(kept, p, q, r))
        {
          noise += Roundings * Amplification[mode] * bound;
          return;
        }
        for (int c = 0; c < 3; ++c)
        {
          dropped[c] += std::fabs(At(c, mode)) * bound;
        }
      });
    return *std::ranges::max_element(dropped) + noise;
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

  [[nodiscard]] bool IsNoise(const Space& kept) const
  {
    bool explained = true;
    std::array<double, 3> dropped{};
    Visit(
      [&](int p, int q, int r, int mode)
      {
        if (!explained || Has(kept, p, q, r))
        {
          return;
        }
        const double bound = ModeBound(Full, p, q, r);
        for (int c = 0; c < 3; ++c)
        {
          explained = explained && std::fabs(At(c, mode)) <= Roundings * Amplification[mode];
          dropped[c] += std::fabs(At(c, mode)) * bound;
        }
      });
    return explained && *std::ranges::max_element(dropped) <= LargestLoss;
  }

  Space Full;
  std::span<const double> Amplification;
  std::span<const double> Modes;
  double Roundings;
  double LargestLoss;
};
} // namespace

ElementGeometry ConvertGeometry(const SourceMesh& mesh, int element)
{
  const ElementUnits units = UnitsOf(mesh, element);
  const ChangeOfBasis& change = mesh.Basis(element).change;
  const Space full = change.Target();
  const auto count = static_cast<std::size_t>(full.Modes());
  std::vector<double> modes(3 * count);
  std::vector<double> nodes;
  for (int c = 0; c < 3; ++c)
  {
    mesh.Gather(element, mesh.Coordinates(), 3, c, nodes);
    change.Apply(nodes, units.centre[c], std::span(modes).subspan(c * count, count));
  }
  ElementGeometry geometry;
  geometry.centre = { units.centre.x, units.centre.y, units.centre.z };
  geometry.size = std::ldexp(1.0, units.exponent);
  const double u = mesh.CoordinateRoundoff();
  const Reduction reduction(full, change.Amplification(), modes,
    kCoordinateRoundings * u * units.largest, kLargestLoss * geometry.size);
  geometry.space = reduction.Reduce();
  geometry.uncertainty = reduction.Uncertainty(geometry.space);
  for (int c = 0; c < 3; ++c)
  {
    ForEachMode(full,
      [&](int p, int q, int r, int mode)
      {
        if (Reduction::Has(geometry.space, p, q, r))
        {
          // A power of two: exact.
          geometry.coefficients.push_back(std::ldexp(modes[c * count + mode], -units.exponent));
        }
      });
  }
  return geometry;
}
} // namespace pixelexact
