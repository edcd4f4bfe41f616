// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Rational/LineTables.h"

#include "Core/Basis/BasisFactor.h"

namespace pixelexact::rational
{
const LineMatrix& LineTables::Find(Kind kind, int from, int to)
{
  const std::lock_guard lock(Access);
  auto& known = Known[{ kind, from, to }];
  if (!known)
  {
    LineMatrix made;
    switch (kind)
    {
      case Kind::BernsteinToNodes:
        made = BernsteinAt(from, NodesOf(to));
        break;
      case Kind::BernsteinToSamples:
        made = BernsteinAt(from, ChebyshevZeros(to));
        break;
      case Kind::NodesToSamples:
        made = LagrangeAt(NodesOf(from), ChebyshevZeros(to));
        break;
      case Kind::NodesToLegendre:
        BasisFactor factor = LineFactor(from, Lagrange(NodesOf(from)));
        made = { factor.rows, factor.columns, std::move(factor.matrix) };
        break;
    }
    known = std::make_unique<LineMatrix>(std::move(made));
  }
  return *known;
}

const LineMatrix& LineTables::BernsteinToNodes(int degree, int order)
{
  return Find(Kind::BernsteinToNodes, degree, order);
}

const LineMatrix& LineTables::BernsteinToSamples(int degree, int samples)
{
  return Find(Kind::BernsteinToSamples, degree, samples);
}

const LineMatrix& LineTables::NodesToSamples(int order, int samples)
{
  return Find(Kind::NodesToSamples, order, samples);
}

const LineMatrix& LineTables::NodesToLegendre(int order)
{
  return Find(Kind::NodesToLegendre, order, order);
}
} // namespace pixelexact::rational
