// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/SimplexNodes.h"

#include "Core/Base/Error.h"
#include "Core/Basis/LineFunctions.h"

#include <string>

namespace pixelexact
{
namespace
{
/// Up to this order, symmetry determines the Gauss-Lobatto-Legendre nodes inside triangles.
constexpr int kUniqueOrder = 3;
} // namespace

std::vector<long double> LineNodes(int order, NodeFamily family)
{
  return family == NodeFamily::GaussLobatto && order > 0 ? GaussLobattoPoints(order + 1)
                                                         : ClosedUniformPoints(order + 1);
}

SimplexNodes::SimplexNodes(int order, NodeFamily family)
  : Places(LineNodes(order, family))
  , Nodes(family)
{
  if (family == NodeFamily::GaussLobatto && order > kUniqueOrder)
  {
    throw Unsupported("the places of Gauss-Lobatto-Legendre nodes inside triangles of order " +
      std::to_string(order) + " are a matter of choice.");
  }
}

long double SimplexNodes::At(int i, std::initializer_list<int> others) const
{
  if (Nodes == NodeFamily::Equispaced)
  {
    return Places[i];
  }
  // On edges the two places in [0,2] that are not zero sum to 2; at a centroid all are equal.
  long double sum = 1 + Places[i];
  for (const int other : others)
  {
    sum += 1 + Places[other];
  }
  return 2 * (1 + Places[i]) / sum - 1;
}
} // namespace pixelexact
