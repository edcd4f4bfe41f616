// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/OrderReduction.h"

#include "Core/Basis/ModeBound.h"

#include <algorithm>
#include <cmath>

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
namespace pixelexact
{
namespace
{
constexpr double kLargestLoss = 1e-6;    ///< in units of the element
constexpr double kOwnRounding = 0x1p-53; ///< in units of the element
} // namespace

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

std::vector<double> OrderReduction::Keep(const Space& kept, double factor) const
{
  std::vector<double> modes;
  modes.reserve(3 * static_cast<std::size_t>(kept.Modes()));
  for (int c = 0; c < 3; ++c)
  {
    ForEachMode(Full,
      [&](int p, int q, int r, int mode)
      {
        if (Has(kept, p, q, r))
        {
          modes.push_back(factor * At(c, mode));
        }
      });
  }
  return modes;
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
} // namespace pixelexact
