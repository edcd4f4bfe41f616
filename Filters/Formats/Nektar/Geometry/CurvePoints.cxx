// SPDX-License-Identifier: BSD-3-Clause
//
// Electrostatic points: J. S. Hesthaven, From electrostatics to almost optimal nodal sets for
// polynomial interpolation in a simplex, SIAM J. Numer. Anal. 35(2), 1998,
// doi:10.1137/S003614299630587X. Fekete points: M. A. Taylor, B. A. Wingate, R. E. Vincent, An
// algorithm for computing Fekete points in the triangle, SIAM J. Numer. Anal. 38(5), 2000,
// doi:10.1137/S0036142998337247. The numbers and the order of the points are Nektar++'s
// (LibUtilities/Foundations, NodalTriElec and NodalTriFekete): its ten digits are what its files'
// points belong to. Its Fekete points of order 10 have one twice and end the table.
#include "Formats/Nektar/Geometry/CurvePoints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact::nektar
{
namespace
{
/// The equal ones among a point's three weights.
enum class Equal : std::uint8_t
{
  All,
  First, ///< the first two
  Last,  ///< the last two
  None
};

/// A point of the triangle, on an edge or inside; the others of its orbit exchange its weights.
struct Orbit
{
  int order;
  Equal equal;
  double weights[3];
};

constexpr Orbit kElectrostatic[] = {
  { 2, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 3, Equal::None, { 0.7236067977, 0.2763932023, 0.0000000000 } },
  { 3, Equal::All, { 0.3333333333, 0.3333333333, 0.3333333333 } },
  { 4, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 4, Equal::None, { 0.8273268354, 0.1726731646, 0.0000000000 } },
  { 4, Equal::First, { 0.2371200168, 0.2371200168, 0.5257599664 } },
  { 5, Equal::None, { 0.6426157582, 0.3573842418, 0.0000000000 } },
  { 5, Equal::None, { 0.8825276620, 0.1174723380, 0.0000000000 } },
  { 5, Equal::First, { 0.4105151510, 0.4105151510, 0.1789696980 } },
  { 5, Equal::First, { 0.1575181512, 0.1575181512, 0.6849636976 } },
  { 6, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 6, Equal::None, { 0.7344243967, 0.2655756033, 0.0000000000 } },
  { 6, Equal::None, { 0.9151119481, 0.0848880519, 0.0000000000 } },
  { 6, Equal::All, { 0.3333333333, 0.3333333333, 0.3333333333 } },
  { 6, Equal::First, { 0.1061169285, 0.1061169285, 0.7877661430 } },
  { 6, Equal::None, { 0.3097982151, 0.5569099204, 0.1332918645 } },
  { 7, Equal::None, { 0.9358700743, 0.0641299257, 0.0000000000 } },
  { 7, Equal::None, { 0.7958500907, 0.2041499093, 0.0000000000 } },
  { 7, Equal::None, { 0.6046496090, 0.3953503910, 0.0000000000 } },
  { 7, Equal::None, { 0.2325524777, 0.6759625951, 0.0914849272 } },
  { 7, Equal::First, { 0.4477725053, 0.4477725053, 0.1044549894 } },
  { 7, Equal::First, { 0.2604038024, 0.2604038024, 0.4791923952 } },
  { 7, Equal::First, { 0.0660520784, 0.0660520784, 0.8678958432 } },
  { 8, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 8, Equal::None, { 0.9498789977, 0.0501210023, 0.0000000000 } },
  { 8, Equal::None, { 0.8385931398, 0.1614068602, 0.0000000000 } },
  { 8, Equal::None, { 0.6815587319, 0.3184412681, 0.0000000000 } },
  { 8, Equal::First, { 0.3905496216, 0.3905496216, 0.2189007568 } },
  { 8, Equal::First, { 0.2033467796, 0.2033467796, 0.5933064408 } },
  { 8, Equal::First, { 0.0469685351, 0.0469685351, 0.9060629298 } },
  { 8, Equal::None, { 0.3617970895, 0.5541643672, 0.0840385433 } },
  { 8, Equal::None, { 0.1801396087, 0.7519065566, 0.0679538347 } },
  { 9, Equal::None, { 0.9597669541, 0.0402330459, 0.0000000000 } },
  { 9, Equal::None, { 0.8693869326, 0.1306130674, 0.0000000000 } },
  { 9, Equal::None, { 0.7389624749, 0.2610375251, 0.0000000000 } },
  { 9, Equal::None, { 0.5826394788, 0.4173605212, 0.0000000000 } },
  { 9, Equal::All, { 0.3333333333, 0.3333333333, 0.3333333333 } },
  { 9, Equal::First, { 0.4640303025, 0.4640303025, 0.0719393950 } },
  { 9, Equal::First, { 0.1633923069, 0.1633923069, 0.6732153862 } },
  { 9, Equal::First, { 0.0355775717, 0.0355775717, 0.9288448566 } },
  { 9, Equal::None, { 0.3225890045, 0.4968009397, 0.1806100558 } },
  { 9, Equal::None, { 0.2966333890, 0.6349633653, 0.0684032457 } },
  { 9, Equal::None, { 0.1439089974, 0.8031490682, 0.0529419344 } },
  { 10, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 10, Equal::None, { 0.9670007152, 0.0329992848, 0.0000000000 } },
  { 10, Equal::None, { 0.8922417368, 0.1077582632, 0.0000000000 } },
  { 10, Equal::None, { 0.7826176635, 0.2173823365, 0.0000000000 } },
  { 10, Equal::None, { 0.6478790678, 0.3521209322, 0.0000000000 } },
  { 10, Equal::First, { 0.4232062312, 0.4232062312, 0.1535875376 } },
  { 10, Equal::First, { 0.2833924371, 0.2833924371, 0.4332151258 } },
  { 10, Equal::First, { 0.1330857076, 0.1330857076, 0.7338285848 } },
  { 10, Equal::First, { 0.0265250690, 0.0265250690, 0.9469498620 } },
  { 10, Equal::None, { 0.3934913008, 0.5472380443, 0.0592706549 } },
  { 10, Equal::None, { 0.2707097521, 0.5811217960, 0.1481684519 } },
  { 10, Equal::None, { 0.2462883939, 0.6991456238, 0.0545659823 } },
  { 10, Equal::None, { 0.1163195333, 0.8427538829, 0.0409265838 } },
};
constexpr Orbit kFekete[] = {
  { 2, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 3, Equal::None, { 0.7236067977, 0.2763932023, 0.0000000000 } },
  { 3, Equal::All, { 0.3333333333, 0.3333333333, 0.3333333333 } },
  { 4, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 4, Equal::None, { 0.8273268354, 0.1726731646, 0.0000000000 } },
  { 4, Equal::Last, { 0.5669152707, 0.2165423647, 0.2165423647 } },
  { 5, Equal::None, { 0.8825276620, 0.1174723380, 0.0000000000 } },
  { 5, Equal::None, { 0.6426157582, 0.3573842418, 0.0000000000 } },
  { 5, Equal::Last, { 0.7039610574, 0.1480194713, 0.1480194713 } },
  { 5, Equal::First, { 0.4208255393, 0.4208255393, 0.1583489214 } },
  { 6, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 6, Equal::None, { 0.9151145777, 0.0848854223, 0.0000000000 } },
  { 6, Equal::None, { 0.7344348598, 0.2655651402, 0.0000000000 } },
  { 6, Equal::All, { 0.3333333333, 0.3333333333, 0.3333333333 } },
  { 6, Equal::Last, { 0.7873290632, 0.1063354684, 0.1063354684 } },
  { 6, Equal::None, { 0.5665492870, 0.3162697959, 0.1171809171 } },
  { 7, Equal::None, { 0.9358700743, 0.0641299257, 0.0000000000 } },
  { 7, Equal::None, { 0.7958500908, 0.2041499092, 0.0000000000 } },
  { 7, Equal::None, { 0.6046496090, 0.3953503910, 0.0000000000 } },
  { 7, Equal::Last, { 0.8408229862, 0.0795885069, 0.079588506 } },
  { 7, Equal::Last, { 0.4735817901, 0.2632091050, 0.2632091050 } },
  { 7, Equal::First, { 0.4539853441, 0.4539853441, 0.0920293119 } },
  { 7, Equal::None, { 0.6676923094, 0.2433646431, 0.0889430475 } },
  { 8, Equal::First, { 0.5000000000, 0.5000000000, 0.0000000000 } },
  { 8, Equal::None, { 0.9498789977, 0.0501210023, 0.0000000000 } },
  { 8, Equal::None, { 0.8385931398, 0.1614068602, 0.0000000000 } },
  { 8, Equal::None, { 0.6815587319, 0.3184412681, 0.0000000000 } },
  { 8, Equal::Last, { 0.8444999609, 0.0777500195, 0.0777500195 } },
  { 8, Equal::First, { 0.4683305115, 0.4683305115, 0.0633389771 } },
  { 8, Equal::First, { 0.3853668203, 0.3853668204, 0.2292663593 } },
  { 8, Equal::None, { 0.7172965409, 0.2335581033, 0.0491453558 } },
  { 8, Equal::None, { 0.5853134902, 0.2667701010, 0.1479164088 } },
  { 9, Equal::None, { 0.9597669930, 0.0402330070, 0.0000000000 } },
  { 9, Equal::None, { 0.8693870908, 0.1306129092, 0.0000000000 } },
  { 9, Equal::None, { 0.7389628040, 0.2610371960, 0.0000000000 } },
  { 9, Equal::None, { 0.5826397065, 0.4173602935, 0.0000000000 } },
  { 9, Equal::All, { 0.3333333333, 0.3333333333, 0.3333333333 } },
  { 9, Equal::Last, { 0.9021308608, 0.0489345696, 0.0489345696 } },
  { 9, Equal::Last, { 0.6591363598, 0.1704318201, 0.1704318201 } },
  { 9, Equal::First, { 0.4699587644, 0.4699587644, 0.0600824712 } },
  { 9, Equal::None, { 0.7904339977, 0.1543901944, 0.0551758079 } },
  { 9, Equal::None, { 0.6401193011, 0.3010242110, 0.0588564879 } },
  { 9, Equal::None, { 0.4963227512, 0.3252434900, 0.1784337588 } },
};

using Permutation = std::array<int, 3>;

/// Nektar++'s order of an orbit's points.
std::vector<Permutation> PermutationsOf(Equal equal)
{
  switch (equal)
  {
    case Equal::All:
      return { { 0, 1, 2 } };
    case Equal::First:
      return { { 0, 1, 2 }, { 2, 0, 1 }, { 0, 2, 1 } };
    case Equal::Last:
      return { { 0, 1, 2 }, { 1, 0, 2 }, { 1, 2, 0 } };
    default:
      return { { 0, 1, 2 }, { 1, 0, 2 }, { 2, 0, 1 }, { 2, 1, 0 }, { 0, 2, 1 }, { 1, 2, 0 } };
  }
}

/// All points of a table but the vertices, in its order.
std::vector<LongVec3> Expand(std::span<const Orbit> table, int order)
{
  std::vector<LongVec3> points;
  for (const Orbit& orbit : table)
  {
    if (orbit.order != order)
    {
      continue;
    }
    for (const Permutation& p : PermutationsOf(orbit.equal))
    {
      // The digits of the three need not sum to one: Nektar++ takes the last two.
      const long double b = orbit.weights[p[1]];
      const long double c = orbit.weights[p[2]];
      points.push_back({ orbit.weights[p[0]] == 0 ? 0 : 1 - b - c, b, c });
    }
  }
  return points;
}

/// The points in the order of the files: along the edges, then inside from the lowest row on, each
/// from left to right.
std::vector<LongVec3> SortedPoints(std::span<const Orbit> table, int order)
{
  auto points = Expand(table, order);
  auto begin = points.begin();
  for (int edge = 0; edge < 3; ++edge)
  {
    const int next = (edge + 1) % 3;
    const auto end = std::stable_partition(
      begin, points.end(), [&](const LongVec3& x) { return x[(edge + 2) % 3] == 0; });
    std::sort(begin, end, [&](const LongVec3& x, const LongVec3& y) { return x[next] < y[next]; });
    begin = end;
  }
  // Points of equal height keep the table's order, as in Nektar++.
  std::stable_sort(
    begin, points.end(), [](const LongVec3& x, const LongVec3& y) { return x[2] < y[2]; });
  for (int n = order - 2; n > 0; --n)
  {
    std::stable_sort(
      begin, begin + n, [](const LongVec3& x, const LongVec3& y) { return x[1] < y[1]; });
    begin += n;
  }
  return points;
}

/// The same for evenly spaced points.
std::vector<LongVec3> EvenPoints(int order)
{
  std::vector<LongVec3> points;
  const auto n = static_cast<long double>(order);
  for (int edge = 0; edge < 3; ++edge)
  {
    for (int i = 1; i < order; ++i)
    {
      LongVec3& at = points.emplace_back();
      at[edge] = 1 - i / n;
      at[(edge + 1) % 3] = i / n;
    }
  }
  for (int j = 1; j < order; ++j)
  {
    for (int i = 1; i + j < order; ++i)
    {
      points.push_back({ 1 - i / n - j / n, i / n, j / n });
    }
  }
  return points;
}
} // namespace

bool IsTriangular(Distribution distribution)
{
  return distribution == Distribution::TriangleEquispaced || IsTabulated(distribution);
}

bool IsTabulated(Distribution distribution)
{
  return distribution == Distribution::TriangleElectrostatic ||
    distribution == Distribution::TriangleFekete;
}

int HighestOrder(Distribution distribution)
{
  return distribution == Distribution::TriangleElectrostatic ? std::end(kElectrostatic)[-1].order
    : distribution == Distribution::TriangleFekete           ? std::end(kFekete)[-1].order
                                                             : kMaxOrder;
}

std::vector<long double> LinePoints(Distribution distribution, int order)
{
  switch (distribution)
  {
    case Distribution::GaussLobatto:
      return GaussLobattoPoints(order + 1);
    case Distribution::LobattoChebyshev:
    {
      std::vector<long double> points(order + 1);
      for (int i = 0; i <= order; ++i)
      {
        points[i] = -std::cos(std::numbers::pi_v<long double> * i / order);
      }
      return points;
    }
    default:
      return ClosedUniformPoints(order + 1);
  }
}

std::vector<LongVec3> TrianglePoints(Distribution distribution, int order)
{
  std::vector<LongVec3> points{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const auto others = distribution == Distribution::TriangleElectrostatic
    ? SortedPoints(kElectrostatic, order)
    : distribution == Distribution::TriangleFekete ? SortedPoints(kFekete, order)
                                                   : EvenPoints(order);
  points.insert(points.end(), others.begin(), others.end());
  return points;
}
} // namespace pixelexact::nektar
