// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"

// The continuous functions of Fuentes, Keith, Demkowicz and Nagaraj (2015) on the pyramid: their
// space, in a basis of its own.
namespace pixelexact::mfem
{
/// The pyramid's tensor coordinates. The apex, where the first two are not defined, is taken as the
/// upper end of the edge from the origin.
LongVec3 InTensorSpace(const LongVec3& xi);

class FuentesFunctions
{
public:
  explicit FuentesFunctions(int order)
    : Order(order)
  {
  }

  [[nodiscard]] int Count() const { return Order * (Order * Order + 3) + 1; }
  void Evaluate(const LongVec3& xi, long double* values) const;

private:
  int Order;
};
} // namespace pixelexact::mfem
