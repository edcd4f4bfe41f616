// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Rational/LineMatrix.h"

#include <map>
#include <memory>
#include <mutex>

namespace pixelexact::rational
{
/// Matrices that many elements share, each made when it is first asked for. For several threads.
class LineTables
{
public:
  /// From Bernstein's coefficients to the nodes of an order.
  const LineMatrix& BernsteinToNodes(int degree, int order);
  /// From Bernstein's coefficients to `samples` zeros of a Chebyshev polynomial.
  const LineMatrix& BernsteinToSamples(int degree, int samples);
  /// From the nodes of an order to these.
  const LineMatrix& NodesToSamples(int order, int samples);
  /// From the nodes of an order to Legendre's coefficients.
  const LineMatrix& NodesToLegendre(int order);

private:
  enum class Kind : std::uint8_t
  {
    BernsteinToNodes,
    BernsteinToSamples,
    NodesToSamples,
    NodesToLegendre
  };
  const LineMatrix& Find(Kind kind, int from, int to);

  std::mutex Access;
  std::map<std::tuple<Kind, int, int>, std::unique_ptr<LineMatrix>> Known;
};
} // namespace pixelexact::rational
